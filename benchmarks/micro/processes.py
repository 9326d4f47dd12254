"""A real gunicorn: how long until it answers, and whose memory is whose after many turns."""

import http.client
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

from benchmarks.micro.site import VARIABLES
from benchmarks.paper.content import ROOT
from benchmarks.paper.servers import HOST, WORKERS, environment, free_port

HUB = "/api/v1/hub/"
PATIENCE = 60.0
PAUSE = 0.005
#: A full collection of garbage, which touches all content, has then come to every worker.
TURNS_EACH = 600
BATCH, MOST_BATCHES = 200, 30
_TICKS = os.sysconf("SC_CLK_TCK")


class Server(NamedTuple):
    """A gunicorn that was started; it may not answer yet."""

    process: subprocess.Popen[bytes]
    port: int
    folder: Path

    def workers(self) -> list[int]:
        """Return the process ids of its workers."""
        pid = self.process.pid
        children = Path(f"/proc/{pid}/task/{pid}/children").read_text(encoding="ascii")
        return [int(one) for one in children.split()]


class Memory(NamedTuple):
    """Megabytes of one process: its own, its share of everything, what others have too."""

    own: float
    proportional: float
    shared: float


def start(published: Path, folder: Path) -> Server:
    """Start gunicorn as configured, over a copy of a published folder."""
    shutil.copytree(published, folder / "var")
    port = free_port()
    command = [sys.executable, "-m", "gunicorn", "--config", "cair_site/gunicorn_conf.py"]
    command += ["--bind", f"{HOST}:{port}", "--workers", str(WORKERS)]
    with (folder / "log").open("wb") as log:
        process = subprocess.Popen(
            command,
            cwd=ROOT,
            env=environment(
                **VARIABLES | {"CAIR_VAR": str(folder / "var"), "CAIR_POLL_SECONDS": "1"}
            ),
            stdout=log,
            stderr=log,
            stdin=subprocess.DEVNULL,
        )
    return Server(process, port, folder)


def stop(server: Server) -> None:
    """End a server by its process id."""
    server.process.send_signal(signal.SIGTERM)
    try:
        server.process.wait(10)
    except subprocess.TimeoutExpired:
        server.process.kill()
        server.process.wait(5)


def first_answer(server: Server, body: bytes) -> None:
    """Wait until it is ready and has answered one turn. Raises RuntimeError where it never is."""
    until = time.monotonic() + PATIENCE
    while not _is_ready(server):
        if server.process.poll() is not None or time.monotonic() > until:
            log = (server.folder / "log").read_text(errors="replace")
            raise RuntimeError(f"The server did not start:\n{log[-2000:]}")
        time.sleep(PAUSE)
    _turn(server, body)


def _is_ready(server: Server) -> bool:
    try:
        return _ask(server, "GET", "/readyz", b"") == http.client.OK
    except OSError:
        return False


def _turn(server: Server, body: bytes) -> None:
    status = _ask(server, "POST", HUB, body)
    if status != http.client.OK:
        raise RuntimeError(f"A turn was answered with {status}.")


def _ask(server: Server, method: str, path: str, body: bytes) -> int:
    connection = http.client.HTTPConnection(HOST, server.port, timeout=20)
    try:
        connection.request(method, path, body or None, {"Content-Type": "application/json"})
        answer = connection.getresponse()
        answer.read()
    finally:
        connection.close()
    return answer.status


def _cpu(pid: int) -> float:
    """Return the seconds of CPU time a process has taken."""
    fields = Path(f"/proc/{pid}/stat").read_text(encoding="ascii").rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / _TICKS


def spent(server: Server) -> float:
    """Return the seconds of CPU time of a server, its workers included."""
    return sum(map(_cpu, (server.process.pid, *server.workers())))


def talk(server: Server, bodies: list[bytes]) -> None:
    """Take turns until each worker has answered 600: who answered shows in its CPU time."""
    workers = server.workers()
    before = {pid: _cpu(pid) for pid in workers}
    for batch in range(1, MOST_BATCHES + 1):
        for number in range(BATCH):
            _turn(server, bodies[number % len(bodies)])
        taken = [_cpu(pid) - before[pid] for pid in workers]
        if min(taken) / sum(taken) * batch * BATCH >= TURNS_EACH:
            return
    raise RuntimeError("One worker answers nearly everything.")


def memory(pid: int) -> Memory:
    """Return what the kernel says of the memory of a process."""
    kilobytes = dict.fromkeys(("Pss", "Private_Clean", "Private_Dirty"), 0)
    shared = 0
    for line in Path(f"/proc/{pid}/smaps_rollup").read_text(encoding="ascii").splitlines()[1:]:
        name, value = line.split(":")
        if name in kilobytes:
            kilobytes[name] = int(value.split()[0])
        shared += (
            int(value.split()[0]) if name.startswith("Shared_C") or name == "Shared_Dirty" else 0
        )
    own = kilobytes["Private_Clean"] + kilobytes["Private_Dirty"]
    return Memory(own / 1_024, kilobytes["Pss"] / 1_024, shared / 1_024)


@contextmanager
def served(published: Path, body: bytes) -> Iterator[Server]:
    """Serve a published folder, yield when the first turn is answered."""
    with tempfile.TemporaryDirectory() as folder:
        server = start(published, Path(folder))
        try:
            first_answer(server, body)
            yield server
        finally:
            stop(server)
