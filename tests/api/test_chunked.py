"""Bodies sent in chunks, without a length: Django gets their length, within the limit."""

from io import BytesIO
from typing import Any

from cair_site.chunked import Chunked

CHUNKED = {"HTTP_TRANSFER_ENCODING": "Chunked"}


class Asked:
    """A server behind the middleware: it remembers what reached it."""

    def __init__(self) -> None:
        self.body: bytes | None = None
        self.status = ""

    def __call__(self, environ: dict[str, Any], start_response: Any) -> list[bytes]:
        self.body = environ["wsgi.input"].read(int(environ.get("CONTENT_LENGTH") or 0))
        return [b"ok"]

    def start(self, status: str, headers: list[tuple[str, str]], *error: object) -> Any:
        self.status = status


def send(body: bytes, **environ: str) -> tuple[Asked, bytes]:
    asked = Asked()
    answer = Chunked(asked, 10)(dict(environ, **{"wsgi.input": BytesIO(body)}), asked.start)
    return asked, b"".join(answer)


def test_a_chunked_body_gets_its_length() -> None:
    asked, answer = send(b"0123456789", **CHUNKED)
    assert (asked.body, answer) == (b"0123456789", b"ok")


def test_a_chunked_body_beyond_the_limit_is_refused() -> None:
    asked, answer = send(b"0123456789a", **CHUNKED)
    assert asked.body is None
    assert asked.status.startswith("413")
    assert b"body.too_large" in answer


def test_a_chunked_body_may_be_empty() -> None:
    assert send(b"", **CHUNKED)[0].body == b""


def test_a_body_with_a_length_is_left_alone() -> None:
    assert send(b"0123456789abc", CONTENT_LENGTH="13")[0].body == b"0123456789abc"


def test_a_length_wins_over_chunks() -> None:
    assert send(b"0123", CONTENT_LENGTH="2", **CHUNKED)[0].body == b"01"
