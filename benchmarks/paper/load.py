"""A load generator: many HTTP/1.1 requests at their times, one thread, sockets that never wait.

A response time counts from the moment its request was due, so a generator or a queue that is late
makes figures worse, never better.
"""

import resource
import select
import socket
import time
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from benchmarks.paper.http_answer import Answer, AnswerError

READ = 65_536
FILES = 65_536


class Result(NamedTuple):
    """One request: seconds from when it was due, milliseconds the server counted, or an error."""

    due: float
    seconds: float
    server: float | None
    error: str


class Target(NamedTuple):
    """A server on loopback; `keep_alive` reuses connections, else each request has its own."""

    host: str
    port: int
    keep_alive: bool = False


@dataclass(slots=True)
class _Call:
    """A request on its way."""

    due: float
    socket: socket.socket
    left: bytes
    reused: bool = False
    answer: Answer = field(default_factory=Answer)


def request(method: str, path: str, body: bytes, kind: str, *, keep_alive: bool = False) -> bytes:
    """Return the bytes of a request."""
    lines = (
        f"{method} {path} HTTP/1.1",
        "Host: 127.0.0.1",
        f"Content-Type: {kind}",
        f"Content-Length: {len(body)}",
        f"Connection: {'keep-alive' if keep_alive else 'close'}",
    )
    return "\r\n".join(lines).encode() + b"\r\n\r\n" + body


def spread(count: int, seconds: float) -> list[float]:
    """Return when each of `count` requests is due: evenly, the first at once."""
    return [seconds * number / count for number in range(count)]


def allow_many_sockets() -> int:
    """Raise the limit of open files as far as it goes; return it."""
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    wanted = FILES if hard == resource.RLIM_INFINITY else min(FILES, hard)
    if soft < wanted:
        resource.setrlimit(resource.RLIMIT_NOFILE, (wanted, hard))
    return max(soft, wanted)


class Load:
    """Sends requests at their times and hears the answers."""

    def __init__(self, target: Target, timeout: float = 30.0) -> None:
        self.target, self.timeout = target, timeout
        self.idle: list[socket.socket] = []
        self.calls: dict[int, _Call] = {}
        self.results: list[Result] = []
        self.began = 0.0

    def run(self, bodies: Sequence[bytes], dues: Iterable[float]) -> list[Result]:
        """Send a request at each moment (seconds from now), the bodies in turn; wait for all."""
        self._begin()
        waiting = list(enumerate(dues))
        waiting.reverse()
        deadline = (waiting[0][1] if waiting else 0.0) + self.timeout
        while (waiting or self.calls) and self._now() < deadline:
            while waiting and waiting[-1][1] <= self._now():
                number, due = waiting.pop()
                self._open(bodies[number % len(bodies)], due)
                if number % 16 == 15:
                    self._hear(0)
            self._hear(self._pause(waiting, deadline))
        self._give_up([due for _number, due in waiting])
        return self.results

    def saturate(self, bodies: Sequence[bytes], count: int, at_once: int) -> list[Result]:
        """Send `count` requests, `at_once` of them always on their way; wait for all."""
        self._begin()
        sent = 0
        while len(self.results) < count and self._now() < self.timeout:
            while sent < count and len(self.calls) < at_once:
                self._open(bodies[sent % len(bodies)], self._now())
                sent += 1
            self._hear(min(1.0, max(0.0, self.timeout - self._now())))
        self._give_up([self._now()] * (count - sent))
        return self.results

    def close(self) -> None:
        """Close the connections that were kept."""
        while self.idle:
            self.idle.pop().close()

    def _begin(self) -> None:
        self.results, self.calls, self.epoll = [], {}, select.epoll()
        self.began = time.perf_counter()

    def _now(self) -> float:
        return time.perf_counter() - self.began

    def _pause(self, waiting: list[tuple[int, float]], deadline: float) -> float:
        until = waiting[-1][1] if waiting else deadline
        return min(max(0.0, until - self._now()), 1.0)

    def _open(self, body: bytes, due: float) -> None:
        reused = bool(self.idle)
        try:
            one = self.idle.pop() if reused else self._connected()
        except OSError as error:
            self.results.append(Result(due, self._now() - due, None, type(error).__name__))
            return
        self.calls[one.fileno()] = _Call(due, one, body, reused)
        self.epoll.register(one.fileno(), select.EPOLLOUT)

    def _connected(self) -> socket.socket:
        one = socket.socket()
        one.setblocking(False)
        one.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        one.connect_ex((self.target.host, self.target.port))
        return one

    def _hear(self, seconds: float) -> None:
        for number, event in self.epoll.poll(seconds, 512):
            call = self.calls[number]
            try:
                if event & select.EPOLLOUT and call.left:
                    self._write(call)
                elif event:
                    self._read(call)
            except (OSError, AnswerError) as error:
                self._end(call, type(error).__name__)

    def _write(self, call: _Call) -> None:
        call.left = call.left[call.socket.send(call.left) :]
        if not call.left:
            self.epoll.modify(call.socket.fileno(), select.EPOLLIN)

    def _read(self, call: _Call) -> None:
        data = call.socket.recv(READ)
        if call.answer.feed(data):
            status = call.answer.status
            self._end(call, "" if status == 200 else f"HTTP {status}")

    def _end(self, call: _Call, error: str) -> None:
        del self.calls[call.socket.fileno()]
        self.epoll.unregister(call.socket.fileno())
        self.results.append(Result(call.due, self._now() - call.due, call.answer.server, error))
        if self.target.keep_alive and not error and not call.answer.closes:
            self.idle.append(call.socket)
        else:
            call.socket.close()

    def _give_up(self, unsent: list[float]) -> None:
        for call in list(self.calls.values()):
            self._end(call, "timeout")
        self.results += [Result(due, self.timeout, None, "not sent") for due in unsent]
        self.epoll.close()
