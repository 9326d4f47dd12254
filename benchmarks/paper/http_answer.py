"""An HTTP/1.1 answer as it arrives: status, length, and what the server says of its time."""

import re
import zlib
from dataclasses import dataclass

_STATUS = re.compile(rb"HTTP/1\.[01] (\d{3})")
_LENGTH = re.compile(rb"\r\ncontent-length: *(\d+)", re.IGNORECASE)
_TOTAL = re.compile(rb"\r\nserver-timing:[^\r]*\btotal;dur=([\d.]+)", re.IGNORECASE)
_CLOSE = re.compile(rb"\r\nconnection: *close", re.IGNORECASE)


class AnswerError(Exception):
    """The server closed too early, or did not speak HTTP."""


@dataclass(slots=True)
class Answer:
    """Collects bytes until the answer is whole; `server` is its processing time in ms."""

    data: bytes = b""
    begin: int = -1
    length: int = -1
    status: int = 0
    server: float | None = None
    closes: bool = False

    def feed(self, data: bytes) -> bool:
        """Take more bytes, none where the server closed; say whether the answer is whole.

        Raises AnswerError where it can never be.
        """
        self.data += data
        if self.begin < 0:
            self._head()
        if not data:
            self.closes = True
            if self.begin < 0 or len(self.data) - self.begin < self.length:
                raise AnswerError("The server closed before its answer was whole.")
            return True
        return 0 <= self.length <= len(self.data) - self.begin

    def body(self) -> bytes:
        """Return the body, inflated where it is zlib."""
        body = self.data[self.begin :]
        return zlib.decompress(body) if body[:1] == b"\x78" else body

    def _head(self) -> None:
        end = self.data.find(b"\r\n\r\n")
        if end < 0:
            return
        head, self.begin = self.data[: end + 2], end + 4
        status = _STATUS.match(head)
        if status is None:
            raise AnswerError("This is not HTTP.")
        length, total = _LENGTH.search(head), _TOTAL.search(head)
        self.status = int(status[1])
        self.length = int(length[1]) if length else -1
        self.server = float(total[1]) if total else None
        self.closes = _CLOSE.search(head) is not None
