"""A service on another machine: limits of time that hold, connections that are kept, trouble."""

import socket
import threading
import time
from collections.abc import Callable, Iterator

import pytest

from cair_site.elsewhere import MOST_TIMEOUTS, Call, Elsewhere, SilentError

OK = b"HTTP/1.1 200 OK\r\nContent-Length: 2\r\n\r\n{}"
Speak = Callable[[socket.socket, int], None]


class Server:
    """Accepts connections one after the other and lets `speak` do what it wants with each."""

    def __init__(self, speak: Speak) -> None:
        self.socket = socket.create_server(("127.0.0.1", 0))
        self.connections = 0
        self.ended = threading.Event()
        self._speak = speak
        self.service = Elsewhere(f"http://127.0.0.1:{self.socket.getsockname()[1]}/x")
        self._thread = threading.Thread(target=self._serve, daemon=True)
        self._thread.start()

    def _serve(self) -> None:
        while True:
            try:
                accepted, _address = self.socket.accept()
            except OSError:
                return
            self.connections += 1
            threading.Thread(target=self._one, args=(accepted,), daemon=True).start()

    def _one(self, accepted: socket.socket) -> None:
        with accepted:
            try:
                self._speak(accepted, self.connections)
            except OSError:
                return


@pytest.fixture
def serve() -> Iterator[Callable[[Speak], Server]]:
    """Return a function that starts a server; it is closed after the test."""
    started: list[Server] = []

    def start(speak: Speak) -> Server:
        started.append(Server(speak))
        return started[-1]

    yield start
    for server in started:
        server.ended.set()
        server.service.hang_up()
        server.socket.close()


def call(seconds: float = 20, most: int = 100) -> Call:
    return Call(b"{}", {"Content-Type": "application/json"}, time.monotonic() + seconds, most)


def heard(connection: socket.socket) -> bool:
    """Read a request; False where the other side hung up."""
    text = b""
    while not text.endswith(b"\r\n\r\n{}"):
        piece = connection.recv(65536)
        if not piece:
            return False
        text += piece
    return True


def answer_all(connection: socket.socket, number: int) -> None:
    while heard(connection):
        connection.sendall(OK)


def test_one_connection_serves_many_calls(serve: Callable[[Speak], Server]) -> None:
    server = serve(answer_all)
    service = server.service
    assert [service.post(call()) for _ in range(5)] == [b"{}"] * 5
    assert server.connections == 1


def test_threads_never_share_a_connection(serve: Callable[[Speak], Server]) -> None:
    server = serve(answer_all)
    service, answers = server.service, []
    threads = [
        threading.Thread(target=lambda: answers.extend(service.post(call()) for _ in range(20)))
        for _ in range(8)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert answers == [b"{}"] * 160
    assert server.connections <= 8


def test_a_connection_that_was_closed_meanwhile_is_made_anew(
    serve: Callable[[Speak], Server],
) -> None:
    def once(connection: socket.socket, number: int) -> None:
        if heard(connection):
            connection.sendall(OK)

    server = serve(once)
    service = server.service
    assert [service.post(call()) for _ in range(3)] == [b"{}"] * 3
    assert server.connections == 3


def test_an_answer_without_keeping_the_connection_is_read_whole(
    serve: Callable[[Speak], Server],
) -> None:
    def closing(connection: socket.socket, number: int) -> None:
        if heard(connection):
            connection.sendall(b"HTTP/1.1 200 OK\r\nConnection: close\r\n\r\n{")
            connection.sendall(b"}")

    assert serve(closing).service.post(call()) == b"{}"


def test_who_hangs_up_twice_is_silent(serve: Callable[[Speak], Server]) -> None:
    server = serve(lambda connection, number: heard(connection) and None)
    with pytest.raises(SilentError):
        server.service.post(call())
    assert server.connections == 2


def test_dripping_does_not_stretch_the_time(serve: Callable[[Speak], Server]) -> None:
    """Each piece comes in time, all together never would."""
    server: list[Server] = []

    def drip(connection: socket.socket, number: int) -> None:
        heard(connection)
        connection.sendall(b"HTTP/1.1 200 OK\r\nX-Long: ")
        while not server[0].ended.wait(0.02):
            connection.sendall(b"x")

    server.append(serve(drip))
    with pytest.raises(SilentError, match="ran out of time"):
        server[0].service.post(call(0.3))


def test_who_runs_out_of_time_again_and_again_may_rest(serve: Callable[[Speak], Server]) -> None:
    server: list[Server] = []

    def hang(connection: socket.socket, number: int) -> None:
        server[0].ended.wait(30)

    server.append(serve(hang))
    service = server[0].service
    for _ in range(MOST_TIMEOUTS):
        with pytest.raises(SilentError, match=r"out of time$"):
            service.post(call(0.1))
    with pytest.raises(SilentError, match="again and again"):
        service.post(call(20))


def test_an_answer_that_is_too_long_is_none(serve: Callable[[Speak], Server]) -> None:
    with pytest.raises(SilentError, match="too long"):
        serve(answer_all).service.post(call(most=1))


def test_a_refusal_is_no_answer(serve: Callable[[Speak], Server]) -> None:
    def refuse(connection: socket.socket, number: int) -> None:
        while heard(connection):
            connection.sendall(b"HTTP/1.1 403 Forbidden\r\nContent-Length: 2\r\n\r\n{}")

    with pytest.raises(SilentError, match="403"):
        serve(refuse).service.post(call())


def test_nobody_there_is_told_at_once() -> None:
    with pytest.raises(SilentError, match="ConnectionRefusedError"):
        Elsewhere("http://127.0.0.1:9/").post(call())


def test_a_key_of_the_hub_is_sent(
    settings: object, serve: Callable[[Speak], Server], monkeypatch: pytest.MonkeyPatch
) -> None:
    from cair_site.services import _headers

    monkeypatch.setattr(settings, "CAIR_SERVICE_KEY", "secret", raising=False)
    assert _headers()["Authorization"] == "Api-Key secret"
    monkeypatch.setattr(settings, "CAIR_SERVICE_KEY", "", raising=False)
    assert "Authorization" not in _headers()
