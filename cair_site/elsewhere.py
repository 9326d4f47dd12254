"""A service on another machine: JSON in and out over kept connections, within a limit of time.

A call is a turn or a part of one, and the services keep nothing of it: asking twice does no harm.
So a connection that the other side has closed meanwhile is made anew and the call sent again.
"""

import io
import os
import socket
import threading
import time
from collections import deque
from functools import lru_cache
from http.client import HTTPConnection, HTTPException, HTTPSConnection
from typing import NamedTuple, cast
from urllib.parse import urlsplit

#: Shorter than servers keep an idle connection (gunicorn: 15 s), in seconds.
LONGEST_IDLE = 10.0
MOST_IDLE = 32
LONGEST_CONNECT = 1.0
#: After so many calls in a row that ran out of time, callers are told at once for a while.
MOST_TIMEOUTS = 3
REST_SECONDS = 2.0
OK = 200


class Call(NamedTuple):
    """What is sent, by when the answer must be there, and how many bytes it may have."""

    body: bytes
    headers: dict[str, str]
    until: float  # of the monotonic clock
    most: int


class SilentError(Exception):
    """A service did not answer in time, or not with 200; says why, never what was sent."""


class TimedSocket:
    """A connected socket on which sending and receiving end together at one moment."""

    def __init__(self, connected: socket.socket) -> None:
        self.connected = connected
        self.until = 0.0

    def hurry(self) -> None:
        """Let the next step take what is left. Raises TimeoutError where nothing is."""
        left = self.until - time.monotonic()
        if left <= 0:
            raise TimeoutError("The time is over.")
        self.connected.settimeout(left)

    def sendall(self, data: bytes) -> None:
        """Send all of it."""
        self.hurry()
        self.connected.sendall(data)

    def makefile(self, mode: str) -> io.BufferedReader:
        """Return what is received, to be read by http.client."""
        return io.BufferedReader(_Received(self))

    def close(self) -> None:
        """Close it once it is no longer read."""
        self.connected.close()


class _Received(io.RawIOBase):
    """The bytes that come in, each wait for them within the limit."""

    def __init__(self, timed: TimedSocket) -> None:
        self.timed = timed
        self.raw = timed.connected.makefile("rb", buffering=0)

    def readable(self) -> bool:
        return True

    def readinto(self, buffer: bytearray | memoryview) -> int | None:  # type: ignore[override]
        self.timed.hurry()
        return self.raw.readinto(buffer)

    def close(self) -> None:
        self.raw.close()
        super().close()


class _Kept(NamedTuple):
    connection: HTTPConnection
    since: float


class Elsewhere:
    """A service at a URL, with the connections to it that nobody uses just now."""

    def __init__(self, url: str) -> None:
        parts = urlsplit(url)
        self._kind = HTTPSConnection if parts.scheme == "https" else HTTPConnection
        self._host, self._port = parts.hostname or "", parts.port
        self._path = (parts.path or "/") + (f"?{parts.query}" if parts.query else "")
        self._idle: deque[_Kept] = deque()
        self._counting = threading.Lock()
        self._timeouts, self._rests_until = 0, 0.0

    def post(self, call: Call) -> bytes:
        """Return the answer's body. Raises SilentError."""
        if time.monotonic() < self._rests_until:
            raise SilentError("it ran out of time again and again")
        try:
            text = self._ask(call)
        except TimeoutError as error:
            self._count(timed_out=True)
            raise SilentError("it ran out of time") from error
        except (OSError, HTTPException, ValueError) as error:
            raise SilentError(type(error).__name__) from error
        self._count(timed_out=False)
        return text

    def forget(self) -> None:
        """Forget the connections of the process this one was forked from; it goes on using them."""
        self._idle = deque()
        self._counting = threading.Lock()

    def _ask(self, call: Call) -> bytes:
        """Ask on a kept connection or a new one; once more where the other side hung up."""
        connection = self._take() or self._connect(call.until)
        try:
            return self._talk(connection, call)
        except TimeoutError:
            raise
        except (ConnectionError, HTTPException):
            # RemoteDisconnected is both. Its neighbours are of the same server: all are old.
            self.hang_up()
        return self._talk(self._connect(call.until), call)

    def _talk(self, connection: HTTPConnection, call: Call) -> bytes:
        whole = False
        try:
            cast(TimedSocket, connection.sock).until = call.until
            connection.request("POST", self._path, call.body, call.headers)
            answer = connection.getresponse()
            text = answer.read(call.most + 1)
            whole = answer.isclosed() and not answer.will_close
        finally:
            if not whole:
                connection.close()
        if whole:
            self._keep(connection)
        if answer.status != OK:
            raise SilentError(f"it answered {answer.status}")
        if len(text) > call.most:
            raise SilentError("its answer is too long")
        return text

    def _connect(self, until: float) -> HTTPConnection:
        """Return a new connection; one address may take half of the time, so that two are tried."""
        left = until - time.monotonic()
        if left <= 0:
            raise TimeoutError("The time is over.")
        connection = self._kind(self._host, self._port, timeout=min(LONGEST_CONNECT, left / 2))
        connection.connect()
        connection.sock = TimedSocket(connection.sock)
        return connection

    def _take(self) -> HTTPConnection | None:
        """Return the connection used last, closing those that were idle for too long."""
        while self._idle:
            try:
                kept = self._idle.pop()
            except IndexError:  # Another thread was faster.
                return None
            if time.monotonic() - kept.since < LONGEST_IDLE:
                return kept.connection
            kept.connection.close()
        return None

    def _keep(self, connection: HTTPConnection) -> None:
        if len(self._idle) >= MOST_IDLE:
            connection.close()
            return
        self._idle.append(_Kept(connection, time.monotonic()))

    def hang_up(self) -> None:
        """Close the connections that nobody uses just now."""
        while (connection := self._take()) is not None:
            connection.close()

    def _count(self, *, timed_out: bool) -> None:
        if not timed_out and not self._timeouts:
            return
        with self._counting:
            self._timeouts = self._timeouts + 1 if timed_out else 0
            if self._timeouts >= MOST_TIMEOUTS:
                self._rests_until = time.monotonic() + REST_SECONDS


_known: list[Elsewhere] = []


@lru_cache(64)
def elsewhere(url: str) -> Elsewhere:
    """Return the service at a URL, the same one each time."""
    _known.append(Elsewhere(url))
    return _known[-1]


def _after_fork() -> None:
    for service in _known:
        service.forget()


os.register_at_fork(after_in_child=_after_fork)
