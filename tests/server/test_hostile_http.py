"""Hostile and unusual HTTP against a real server: each is answered, and the next request works."""

import json
import socket
import zlib
from collections.abc import Iterator

import pytest

from tests.server.conftest import Server

TURN = b'{"client_sentence": "play the song Hey Brother"}'
PATHS = pytest.mark.parametrize("path", ["/api/v1/hub/", "/CAIR_hub"])


@pytest.fixture(autouse=True)
def _goes_on(server: Server) -> Iterator[None]:
    """Check after each test that the server still talks."""
    yield
    for _ in range(4):
        assert server.ask("POST", "/api/v1/hub/", TURN).status == 200


def raw(server: Server, *pieces: bytes, seconds: float = 5) -> bytes:
    """Send bytes as they are and return what comes back until the other side closes or waits."""
    with socket.create_connection(("127.0.0.1", server.port), timeout=seconds) as connection:
        for piece in pieces:
            connection.sendall(piece)
        received = b""
        try:
            while piece := connection.recv(65536):
                received += piece
        except TimeoutError:
            pass
        return received


def request(path: str, *headers: str, method: str = "POST") -> bytes:
    lines = [f"{method} {path} HTTP/1.1", "Host: localhost", "Connection: close", *headers]
    return "\r\n".join([*lines, "", ""]).encode()


def chunks(body: bytes, size: int = 7) -> bytes:
    pieces = [body[start : start + size] for start in range(0, len(body), size)]
    return b"".join(b"%x\r\n%s\r\n" % (len(piece), piece) for piece in pieces) + b"0\r\n\r\n"


@PATHS
@pytest.mark.parametrize("body", [TURN, zlib.compress(TURN)])
@pytest.mark.parametrize("size", [1, 7, 10_000])
def test_a_chunked_turn_is_a_turn(server: Server, path: str, body: bytes, size: int) -> None:
    answer = raw(server, request(path, "Transfer-Encoding: chunked"), chunks(body, size))
    assert answer.startswith(b"HTTP/1.1 200")
    text = answer.partition(b"\r\n\r\n")[2]
    said = json.loads(zlib.decompress(text) if text[:1] == b"\x78" else text)
    assert said["plan"] == "#action=playsong title=Hey Brother"


def test_a_chunked_body_that_is_empty_starts_an_old_client(server: Server) -> None:
    answer = raw(
        server, request("/CAIR_hub", "Transfer-Encoding: chunked", method="PUT"), chunks(b"")
    )
    assert json.loads(answer.partition(b"\r\n\r\n")[2])["dialogue_state"]


@PATHS
def test_a_chunked_body_beyond_the_limit_is_refused(server: Server, path: str) -> None:
    body = chunks(bytes(1_000_000), 50_000)
    answer = raw(server, request(path, "Transfer-Encoding: chunked"), body)
    assert answer.startswith(b"HTTP/1.1 413")
    assert b"body.too_large" in answer


@pytest.mark.parametrize(
    "body", [b"zz\r\nhello\r\n0\r\n\r\n", b"5\r\nhello", b"ffffffffffffffffff\r\nhello", b"-5\r\n"]
)
def test_broken_chunks_are_no_fault_of_ours(server: Server, body: bytes) -> None:
    head = request("/api/v1/hub/", "Transfer-Encoding: chunked")
    answer = raw(server, head, body, seconds=0.5)
    assert not answer.startswith(b"HTTP/1.1 200")


@PATHS
def test_a_huge_body_is_refused_before_it_is_read(server: Server, path: str) -> None:
    answer = raw(server, request(path, "Content-Length: 10000000000"), b"{", seconds=2)
    assert answer.startswith(b"HTTP/1.1 413")
    assert b"body.too_large" in answer


@pytest.mark.parametrize(
    "head",
    [
        b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03",
        b"GET\r\n\r\n",
        b"GET / HTTP/9.9\r\n\r\n",
        b"GET /" + b"a" * 100_000 + b" HTTP/1.1\r\n\r\n",
        b"POST /api/v1/hub/ HTTP/1.1\r\nHost: a\r\nContent-Length: -1\r\n\r\n",
        b"POST /api/v1/hub/ HTTP/1.1\r\nHost: a\r\nContent-Length: 2\r\n"
        b"Transfer-Encoding: chunked\r\n\r\n{}",
        b"GET /api/v1/hub/ HTTP/1.1\r\n" + b"X: y\r\n" * 1000 + b"\r\n",
        b"GET /%ff%fe/%00 HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n",
    ],
)
def test_what_is_no_http_is_turned_away(server: Server, head: bytes) -> None:
    assert b" 200 " not in raw(server, head, seconds=1)[:20]


def test_half_a_body_holds_nobody_else(server: Server) -> None:
    opened = [socket.create_connection(("127.0.0.1", server.port)) for _ in range(20)]
    for connection in opened:
        connection.sendall(request("/api/v1/hub/", "Content-Length: 100") + b'{"client')
    assert server.ask("POST", "/api/v1/hub/", TURN).status == 200
    for connection in opened:
        connection.close()


def test_the_log_holds_no_sentence(server: Server) -> None:
    secret = json.dumps({"client_sentence": "Margaret is ill", "seed": -1}).encode()
    server.ask("POST", "/api/v1/hub/", secret)
    server.ask("PUT", "/CAIR_hub", zlib.compress(b'{"client_sentence": "Margaret is ill"}'))
    assert b"Margaret" not in server.log.read_bytes()
