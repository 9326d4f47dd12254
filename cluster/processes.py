"""Programs that we start: each in a group of its own, ended by its process id and by no name."""

import os
import shutil
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from types import FrameType
from typing import IO, NoReturn

ROOT = Path(__file__).resolve().parent.parent
Process = subprocess.Popen[bytes]


class NotPossibleError(RuntimeError):
    """Something that a cluster needs is not there; says what, and how to get it."""


def program(name: str, package: str) -> str:
    """Return the path of a program. Raises NotPossibleError with the package that has it."""
    found = shutil.which(name, path=f"{os.environ.get('PATH', '')}:/usr/sbin:/sbin")
    if found is None:
        raise NotPossibleError(f"{name} is not installed: apt-get install {package}")
    return found


def start(command: Sequence[str], log: IO[bytes], environment: Mapping[str, str]) -> Process:
    """Start a program, in the project's folder, with a process group of its own."""
    return subprocess.Popen(
        command,
        cwd=ROOT,
        env=dict(environment),
        stdin=subprocess.DEVNULL,
        stdout=log,
        stderr=log,
        start_new_session=True,
    )


def end(process: Process, number: signal.Signals, seconds: float = 30) -> None:
    """Send a signal to a program and wait; what is left of its group then is killed."""
    if process.poll() is None:
        process.send_signal(number)
        with suppress(subprocess.TimeoutExpired):
            process.wait(seconds)
    kill(process)


def kill(process: Process) -> None:
    """End a program and all it has started at once, as a power cut would."""
    with suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGKILL)
    process.wait()


def end_when_told() -> None:
    """Let SIGTERM end this program as Ctrl-C does, so that what it has started ends too."""

    def told(number: int, _frame: FrameType | None) -> NoReturn:
        raise SystemExit(128 + number)

    signal.signal(signal.SIGTERM, told)


def signal_group(process: Process, number: signal.Signals) -> None:
    """Send a signal to a program and all it has started."""
    with suppress(ProcessLookupError):
        os.killpg(process.pid, number)


def plain_environment() -> dict[str, str]:
    """Return the environment without any setting of the service."""
    ours = ("CAIR_", "DATABASE_", "DJANGO_")
    return {name: value for name, value in os.environ.items() if not name.startswith(ours)}


def manage(environment: Mapping[str, str], *arguments: str) -> str:
    """Run manage.py and return what it printed. Raises RuntimeError with what it complained of."""
    done = subprocess.run(
        [sys.executable, "manage.py", *arguments],
        cwd=ROOT,
        env=dict(environment),
        capture_output=True,
        text=True,
        check=False,
        timeout=300,
    )
    if done.returncode:
        raise RuntimeError(f"manage.py {arguments[0]}: {done.stderr[-3000:]}")
    return done.stdout


def free_port() -> int:
    """Return a port of the loopback that nobody uses just now."""
    with socket.socket() as tried:
        tried.bind(("127.0.0.1", 0))
        return int(tried.getsockname()[1])


def wait_until(what: Callable[[], bool], seconds: float, pause: float = 0.05) -> float | None:
    """Return after how many seconds something became true, None where it did not in time."""
    began = time.monotonic()
    while not what():
        if time.monotonic() - began > seconds:
            return None
        time.sleep(pause)
    return time.monotonic() - began
