"""The load generator of the paper's experiments: what it counts, and what it never hides."""

import socket
import threading
from collections.abc import Iterator

import pytest

from benchmarks.paper.http_answer import Answer, AnswerError
from benchmarks.paper.load import Load, Target, request, spread

OK = (
    b"HTTP/1.1 200 OK\r\nContent-Length: 2\r\n"
    b"Server-Timing: match;dur=0.1, total;dur=1.25\r\n\r\n{}"
)


def _serve(listener: socket.socket, answers: list[bytes], heard: list[bytes]) -> None:
    for answer in answers:
        connection, _address = listener.accept()
        with connection:
            heard.append(connection.recv(65_536))
            connection.sendall(answer)


class Server:
    """Answers so many connections with what it was given, then stops."""

    def __init__(self, answers: list[bytes]) -> None:
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.port = self.listener.getsockname()[1]
        self.heard: list[bytes] = []
        self.thread = threading.Thread(
            target=_serve, args=(self.listener, answers, self.heard), daemon=True
        )
        self.thread.start()

    def close(self) -> None:
        self.thread.join(5)
        self.listener.close()


@pytest.fixture
def serve() -> Iterator[list[Server]]:
    made: list[Server] = []
    yield made
    for one in made:
        one.close()


def _run(
    serve: list[Server], answers: list[bytes], timeout: float = 5.0
) -> list[tuple[float, str]]:
    serve.append(Server(answers))
    load = Load(Target("127.0.0.1", serve[0].port), timeout)
    body = request("POST", "/x", b"{}", "application/json")
    return [(one.server or 0.0, one.error) for one in load.run([body], [0.0] * len(answers))]


def test_the_servers_own_time_is_read_from_server_timing(serve: list[Server]) -> None:
    assert _run(serve, [OK, OK]) == [(1.25, ""), (1.25, "")]


def test_a_request_is_whole_http_with_its_length(serve: list[Server]) -> None:
    _run(serve, [OK])
    assert serve[0].heard[0].startswith(b"POST /x HTTP/1.1\r\n")
    assert b"Content-Length: 2\r\n" in serve[0].heard[0]


def test_an_error_of_the_server_is_counted_as_one(serve: list[Server]) -> None:
    refused = OK.replace(b"200 OK", b"503 Busy")
    assert [error for _server, error in _run(serve, [refused])] == ["HTTP 503"]


def test_an_answer_cut_short_is_an_error(serve: list[Server]) -> None:
    assert [error for _server, error in _run(serve, [OK[:-1]])] == ["AnswerError"]


def test_a_saturating_load_sends_all_and_never_more_at_once(serve: list[Server]) -> None:
    serve.append(Server([OK] * 7))
    load = Load(Target("127.0.0.1", serve[0].port), 5.0)
    seen: list[int] = []
    hear = load._hear
    load._hear = lambda seconds: seen.append(len(load.calls)) or hear(seconds)  # type: ignore[method-assign,func-returns-value]
    results = load.saturate([request("POST", "/x", b"{}", "application/json")], 7, 3)
    assert [one.error for one in results] == [""] * 7
    assert max(seen) == 3


def test_a_saturating_load_gives_up_in_time() -> None:
    with socket.create_server(("127.0.0.1", 0)) as silent:
        load = Load(Target("127.0.0.1", silent.getsockname()[1]), 0.2)
        results = load.saturate([b"x"], 5, 2)
    assert sorted(one.error for one in results) == ["not sent"] * 3 + ["timeout"] * 2


def test_nobody_listening_is_an_error_and_no_exception() -> None:
    with socket.create_server(("127.0.0.1", 0)) as one:
        port = one.getsockname()[1]
    results = Load(Target("127.0.0.1", port), 2.0).run([b"x"], [0.0])
    assert results[0].error == "ConnectionRefusedError"


def test_requests_are_spread_evenly_over_their_period() -> None:
    assert spread(4, 10.0) == [0.0, 2.5, 5.0, 7.5]


def test_an_answer_may_come_byte_by_byte() -> None:
    answer = Answer()
    fed = [answer.feed(OK[place : place + 1]) for place in range(len(OK))]
    assert fed == [False] * (len(OK) - 1) + [True]
    assert (answer.status, answer.server, answer.body()) == (200, 1.25, b"{}")


def test_what_is_not_http_is_refused() -> None:
    with pytest.raises(AnswerError):
        Answer().feed(b"hello\r\n\r\n")
