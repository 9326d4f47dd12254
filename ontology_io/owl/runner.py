"""Run a program that reads from a pipe and answers to one, and never wait for it for ever."""

import contextlib
import os
import signal
import subprocess
import threading
from typing import IO, NamedTuple

_HEARD = 64 * 1024


class Outcome(NamedTuple):
    """What a program answered; `code` as of subprocess, `late` and `long` say who ended it."""

    answer: bytes
    errors: str
    code: int
    late: bool
    long: bool


def run(command: list[str], data: bytes, *, seconds: float, most: int) -> Outcome:
    """Give `data` to the program, return up to `most` bytes of its answer.

    After `seconds`, or beyond `most`, it is killed with all it has started.
    """
    process = subprocess.Popen(  # noqa: S603 - our own interpreter, nothing from the file
        command,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        cwd="/",
        env={"LC_ALL": "C.UTF-8", "PATH": ""},
        start_new_session=True,
    )
    late = threading.Event()
    timer = threading.Timer(seconds, _end, (process, late))
    heard = bytearray()
    threads = [
        threading.Thread(target=_feed, args=(process.stdin, data), daemon=True),
        threading.Thread(target=_hear, args=(process.stderr, heard), daemon=True),
    ]
    for thread in (timer, *threads):
        thread.start()
    try:
        answer = _answer(process.stdout, most)
        long = len(answer) > most
        if long:
            _kill(process)
    except BaseException:
        _kill(process)
        raise
    finally:
        code = process.wait()
        timer.cancel()
        for thread in threads:
            thread.join(timeout=5)
        _close(process)
    return Outcome(bytes(answer), heard.decode("utf-8", "replace"), code, late.is_set(), long)


def _answer(pipe: IO[bytes] | None, most: int) -> bytearray:
    answer = bytearray()
    while pipe and len(answer) <= most and (chunk := pipe.read(_HEARD)):
        answer += chunk
    return answer


def _feed(pipe: IO[bytes], data: bytes) -> None:
    with contextlib.suppress(OSError), pipe:
        pipe.write(data)


def _hear(pipe: IO[bytes], heard: bytearray) -> None:
    with contextlib.suppress(OSError, ValueError):
        while chunk := pipe.read(_HEARD):
            heard += chunk[: _HEARD - len(heard)]


def _end(process: subprocess.Popen[bytes], late: threading.Event) -> None:
    late.set()
    _kill(process)


def _kill(process: subprocess.Popen[bytes]) -> None:
    """Kill the process and all it has started; only while nobody has waited for it."""
    with contextlib.suppress(OSError):
        if hasattr(os, "killpg"):
            os.killpg(process.pid, signal.SIGKILL)
        else:
            process.kill()


def _close(process: subprocess.Popen[bytes]) -> None:
    for pipe in (process.stdout, process.stderr):
        if pipe:
            with contextlib.suppress(OSError):
                pipe.close()
