"""A network that can be lost: a proxy in front of a server, and small servers that misbehave."""

import socket
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from http.server import BaseHTTPRequestHandler, HTTPServer


class Network:
    """A proxy on a port that stays the same; while it is down nobody listens there."""

    def __init__(self, to_port: int) -> None:
        self.to_port = to_port
        self.port = 0
        self.answers_to_lose = 0
        self._listening: socket.socket | None = None

    def up(self) -> None:
        """Listen, on the same port as before."""
        listening = socket.socket()
        listening.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listening.bind(("127.0.0.1", self.port))
        listening.listen()
        self.port = listening.getsockname()[1]
        self._listening = listening
        threading.Thread(target=self._serve, args=(listening,), daemon=True).start()

    def down(self) -> None:
        """Hang up."""
        if self._listening:
            with suppress(OSError):
                self._listening.shutdown(socket.SHUT_RDWR)
            self._listening.close()
            self._listening = None

    @property
    def address(self) -> str:
        return f"http://127.0.0.1:{self.port}"

    def _serve(self, listening: socket.socket) -> None:
        while True:
            try:
                near, _ = listening.accept()
            except OSError:
                return
            self._carry(near)

    def _carry(self, near: socket.socket) -> None:
        """Carry one request and its answer; a lost answer is one the server has given."""
        with (
            near,
            socket.create_connection(("127.0.0.1", self.to_port), 20) as far,
            suppress(OSError),
        ):
            near.settimeout(20)
            far.sendall(request_of(near))
            answer = b"".join(iter(lambda: far.recv(65536), b""))
            if self.answers_to_lose:
                self.answers_to_lose -= 1
                answer = answer[: len(answer) - 5]
            near.sendall(answer)


def request_of(near: socket.socket) -> bytes:
    """Return one whole request."""
    data = b""
    while b"\r\n\r\n" not in data:
        data += near.recv(65536)
    head, _, body = data.partition(b"\r\n\r\n")
    lengths = [line for line in head.lower().split(b"\r\n") if line.startswith(b"content-length:")]
    missing = int(lengths[0].split(b":")[1]) - len(body) if lengths else 0
    while missing > 0:
        piece = near.recv(65536)
        data += piece
        missing -= len(piece)
    return data


@contextmanager
def answering(
    status: int, headers: dict[str, str], body: bytes, tls: object = None
) -> Iterator[tuple[int, list[str]]]:
    """Serve one answer to all; yields the port and the keys that were sent."""
    keys: list[str] = []

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            keys.append(self.headers.get("X-Api-Key", ""))
            self.send_response(status)
            for name, value in headers.items():
                self.send_header(name, value)
            self.end_headers()
            self.wfile.write(body)

        def log_message(self, *_: object) -> None:
            pass

    class Quiet(HTTPServer):
        def handle_error(self, *_: object) -> None:
            pass

    with Quiet(("127.0.0.1", 0), Handler) as running:
        if tls is not None:
            running.socket = tls.wrap_socket(running.socket, server_side=True)  # type: ignore[attr-defined]
        thread = threading.Thread(target=running.serve_forever, args=(0.02,), daemon=True)
        thread.start()
        yield running.server_port, keys
        running.shutdown()
        thread.join()
