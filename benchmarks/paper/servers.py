"""The two systems as processes on loopback, each ended by its own process id."""

import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from urllib.error import URLError
from urllib.request import urlopen

from benchmarks.paper.content import ROOT
from benchmarks.paper.prepare import VARIABLES

HOST = "127.0.0.1"
WORKERS = 2
PLAN, DIALOGUE, HUB = "CAIR_plan_manager", "CAIR_dialogue_manager", "CAIR_hub"


def free_port() -> int:
    """Return a port of loopback that nobody listens on."""
    with socket.socket() as one:
        one.bind((HOST, 0))
        return int(one.getsockname()[1])


def environment(**variables: str) -> dict[str, str]:
    """Return this process's environment without settings of the site, and these variables."""
    kept = {
        name: value
        for name, value in os.environ.items()
        if not name.startswith(("CAIR_", "DATABASE_", "DJANGO_"))
    }
    return kept | variables


@contextmanager
def process(
    command: list[str], variables: dict[str, str], log: Path
) -> Iterator[subprocess.Popen[bytes]]:
    """Run a command in the root of the project and end it, by its own process id."""
    with log.open("wb") as file:
        one = subprocess.Popen(
            command, cwd=ROOT, env=variables, stdout=file, stderr=file, stdin=subprocess.DEVNULL
        )
    try:
        yield one
    finally:
        one.send_signal(signal.SIGTERM)
        try:
            one.wait(10)
        except subprocess.TimeoutExpired:
            one.kill()
            one.wait(5)


def wait(one: subprocess.Popen[bytes], port: int, path: str, log: Path) -> None:
    """Wait until a service answers, be it with an error. Raises RuntimeError where it ends."""
    until = time.monotonic() + 60
    while time.monotonic() < until and one.poll() is None:
        try:
            with socket.create_connection((HOST, port), 1):
                pass
            if path:
                with urlopen(f"http://{HOST}:{port}{path}", timeout=20):
                    pass
        except (URLError, OSError):
            time.sleep(0.1)
        else:
            return
    raise RuntimeError(f"A server did not start:\n{log.read_text(errors='replace')[-2000:]}")


@contextmanager
def cair(prepared: Path) -> Iterator[int]:
    """Serve the prepared content with gunicorn as configured, and yield the port."""
    with tempfile.TemporaryDirectory() as folder:
        var, log, port = Path(folder) / "var", Path(folder) / "log", free_port()
        shutil.copytree(prepared / "var", var)
        command = [sys.executable, "-m", "gunicorn", "--config", "cair_site/gunicorn_conf.py"]
        command += ["--bind", f"{HOST}:{port}", "--workers", str(WORKERS)]
        with process(command, environment(**VARIABLES, CAIR_VAR=str(var)), log) as one:
            wait(one, port, "/readyz", log)
            yield port


@contextmanager
def baseline(prepared: Path) -> Iterator[int]:
    """Serve the three services of the baseline, and yield the port of its Hub."""
    data = ["--data", str(prepared / "baseline.json")]
    plan, dialogue, hub = free_port(), free_port(), free_port()
    addresses = [f"http://{HOST}:{plan}/{PLAN}", f"http://{HOST}:{dialogue}/{DIALOGUE}"]
    where = ["--plan", addresses[0], "--dialogue", addresses[1]]
    with tempfile.TemporaryDirectory() as folder, ExitStack() as stack:
        for name, port, options in (
            ("plan", plan, data),
            ("dialogue", dialogue, data),
            ("hub", hub, where),
        ):
            log = Path(folder) / name
            command = [sys.executable, "-m", "benchmarks.baseline", name, str(port), *options]
            one = stack.enter_context(process(command, environment(), log))
            wait(one, port, f"/{HUB}" if name == "hub" else "", log)
        yield hub
