"""The same application on different servers: turns a second, with and without stalled clients.

python -m benchmarks.servers [--rounds 5] [--requests 400]

All run with two workers, the largest state, the load generator on the same two cores, 32 requests
always on their way; the rounds go through all of them in turn, so that a slow minute of the machine
hits each. Where `hey` (a load generator in Go, Debian's package) is installed, it says in the same
rounds how many turns a second it saw, so that ours need not be believed.
"""

import argparse
import json
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from importlib.util import find_spec
from pathlib import Path
from statistics import median
from typing import NamedTuple

from tqdm import tqdm

from benchmarks.paper.__main__ import prepared
from benchmarks.paper.load import Load, Target, allow_many_sockets, request
from benchmarks.paper.prepare import VARIABLES
from benchmarks.paper.servers import HOST, environment, free_port, process, wait

GUNICORN = "gunicorn --config cair_site/gunicorn_conf.py --bind {host}:{port} --workers 2"
GRANIAN = (
    "granian --interface wsgi --host {host} --port {port} --workers 2 --blocking-threads 1 "
    "--backlog 4096 --log-level warning cair_site.wsgi:application"
)
STALLED = 40
AT_ONCE = 32
UNLOADED = 30


class Server(NamedTuple):
    """A way to serve: its command, and the module it needs."""

    name: str
    command: str
    needs: str = "gunicorn"


SERVERS = (
    Server("gunicorn, 16 threads (the default)", GUNICORN),
    Server("gunicorn, 4 threads", f"{GUNICORN} --threads 4"),
    Server("gunicorn, 64 threads", f"{GUNICORN} --threads 64"),
    Server("gunicorn, sync", f"{GUNICORN} --worker-class sync --threads 1"),
    Server("gunicorn, sync, 4 workers", f"{GUNICORN} --worker-class sync --threads 1 --workers 4"),
    Server("granian, WSGI", GRANIAN, "granian"),
)


class Figures(NamedTuple):
    """What one server did in all rounds."""

    closing: list[float]
    keeping: list[float]
    alone: list[float]
    stalled: list[float]
    hey: dict[bool, list[float]]


@contextmanager
def serving(server: Server, folder: Path) -> Iterator[int]:
    """Serve the prepared content, and yield the port."""
    with tempfile.TemporaryDirectory() as temporary:
        var, log, port = Path(temporary) / "var", Path(temporary) / "log", free_port()
        shutil.copytree(folder / "var", var)
        words = server.command.format(host=HOST, port=port).split()
        command = [sys.executable, "-m", *words]
        with process(command, environment(**VARIABLES, CAIR_VAR=str(var)), log) as one:
            wait(one, port, "/readyz", log)
            yield port


@contextmanager
def half_sent(port: int, count: int) -> Iterator[None]:
    """Hold so many connections that began a body and never end it."""
    with ExitStack() as stack:
        for _ in range(count):
            one = stack.enter_context(socket.create_connection((HOST, port), 5))
            one.sendall(b"POST /api/v1/hub/ HTTP/1.1\r\nHost: x\r\nContent-Length: 900\r\n\r\n{")
        time.sleep(0.2)
        yield


def turns_a_second(port: int, bodies: list[bytes], count: int, *, keep: bool) -> float:
    """Return how many turns a second were answered, `count` of them sent over 32 connections."""
    load = Load(Target(HOST, port, keep_alive=keep))
    began = time.perf_counter()
    answered = sum(not one.error for one in load.saturate(bodies, count, AT_ONCE))
    seconds = time.perf_counter() - began
    load.close()
    return answered / seconds


def by_hey(port: int, asked: bytes, count: int, *, keep: bool) -> float:
    """Return what hey says of the same. Raises RuntimeError where a turn was not answered."""
    body = asked.partition(b"\r\n\r\n")[2].decode()
    command = ["hey", "-n", str(count), "-c", str(AT_ONCE), "-m", "POST", "-d", body]
    command += ["-T", "application/json", *([] if keep else ["-disable-keepalive"])]
    command.append(f"http://{HOST}:{port}/api/v1/hub/")
    said = subprocess.run(command, capture_output=True, text=True, timeout=120, check=True).stdout
    answered, rate = re.search(r"\[200\]\s+(\d+)", said), re.search(r"Requests/sec:\s+(\S+)", said)
    if not answered or not rate or int(answered[1]) < count // AT_ONCE * AT_ONCE:
        raise RuntimeError(f"hey was not answered each time:\n{said}")
    return float(rate[1])


def milliseconds(port: int, bodies: list[bytes]) -> float:
    """Return the median response to one request at a time; those that fail count as 2 s."""
    load = Load(Target(HOST, port), timeout=2.0)
    results = [load.run([bodies[at % len(bodies)]], [0.0])[0] for at in range(UNLOADED)]
    return 1000 * median(2.0 if one.error else one.seconds for one in results)


def measured(servers: list[tuple[Server, int]], state: str, options: argparse.Namespace) -> None:
    """Go through all servers in turn, and print the table."""
    figures = {
        server.name: Figures([], [], [], [], {False: [], True: []}) for server, _port in servers
    }
    bodies = {keep: _requests(state, keep=keep) for keep in (False, True)}
    hey = shutil.which("hey")
    for _ in tqdm(range(options.rounds), desc="rounds"):
        for server, port in servers:
            one = figures[server.name]
            for keep, into in ((False, one.closing), (True, one.keeping)):
                into.append(turns_a_second(port, bodies[keep], options.requests, keep=keep))
                if hey:
                    asked = bodies[keep][0]
                    one.hey[keep].append(by_hey(port, asked, options.requests, keep=keep))
            one.alone.append(milliseconds(port, bodies[False]))
    for server, port in servers:
        with half_sent(port, STALLED):
            figures[server.name].stalled.append(milliseconds(port, bodies[False]))
    _print(figures)


def _requests(state: str, *, keep: bool) -> list[bytes]:
    said = ("yes", "no", "I do not know", "my sister liked it", "I love dogs")
    messages = ({"client_sentence": one, "dialogue_state": state} for one in said)
    return [
        request(
            "POST",
            "/api/v1/hub/",
            json.dumps(message).encode(),
            "application/json",
            keep_alive=keep,
        )
        for message in messages
    ]


def _print(figures: dict[str, Figures]) -> None:
    print(
        f"| server | turns/s, a connection each | turns/s, kept connections "
        f"| by hey, each | by hey, kept | one alone, ms | beside {STALLED} stalled clients, ms |\n"
        "| --- | ---: | ---: | ---: | ---: | ---: | ---: |"
    )
    first = next(iter(figures.values()))
    for name, one in figures.items():
        closing, keeping = median(one.closing), median(one.keeping)
        print(
            f"| {name} | {closing:,.0f} ({closing / median(first.closing):.2f} ×) "
            f"| {keeping:,.0f} ({keeping / median(first.keeping):.2f} ×) "
            f"| {_said(one.hey[False])} | {_said(one.hey[True])} "
            f"| {median(one.alone):.1f} | {median(one.stalled):,.1f} |"
        )


def _said(rates: list[float]) -> str:
    return f"{median(rates):,.0f}" if rates else "–"


def main() -> None:
    """Start every server there is, and measure."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--requests", type=int, default=640)
    options = parser.parse_args()
    allow_many_sockets()
    folder = prepared()
    states = json.loads((folder / "states.json").read_text(encoding="utf-8"))
    there = [one for one in SERVERS if find_spec(one.needs)]
    for one in SERVERS:
        if one not in there:
            print(f"{one.name}: {one.needs} is not installed.")
    with ExitStack() as stack:
        servers = [(one, stack.enter_context(serving(one, folder))) for one in there]
        measured(servers, states["cair"][-1]["state"], options)


if __name__ == "__main__":
    main()
