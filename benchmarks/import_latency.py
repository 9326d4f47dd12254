"""How much longer a turn takes while an ontology is brought in: the shipped content's own export.

python benchmarks/import_latency.py [--rounds 3] [--robots 2] [--workers 2]

gunicorn runs in a folder of its own that is thrown away; the import comes over the API, as a
program of researchers brings it, and is written into the draft.
"""

import argparse
import json
import os
import re
import shutil
import sys
import tempfile
import threading
import time
from pathlib import Path
from statistics import median, quantiles

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from tests.server.conftest import Server, manage, start_server  # noqa: E402

MAKE_KEY = "from authoring.keys import make_key; print(make_key('bench', None, None, 'write')[1])"
SENTENCES = ("I love music", "Yes, a lot", "What about tea?", "No", "Tell me something else")


class Robots:
    """Clients that talk without a pause, each on a connection of its own."""

    def __init__(self, server: Server, count: int) -> None:
        self.server = server
        self.times: list[float] = []
        self.stopped = threading.Event()
        self.threads = [threading.Thread(target=self._talk) for _ in range(count)]

    def __enter__(self) -> "Robots":
        for thread in self.threads:
            thread.start()
        return self

    def __exit__(self, *_error: object) -> None:
        self.stopped.set()
        for thread in self.threads:
            thread.join()

    def _talk(self) -> None:
        state = self.server.ask("GET", "/api/v1/hub/").json()["dialogue_state"]
        turn = 0
        while not self.stopped.is_set():
            said = {"client_sentence": SENTENCES[turn % len(SENTENCES)], "dialogue_state": state}
            before = time.perf_counter()
            answer = self.server.ask("POST", "/api/v1/hub/", json.dumps(said).encode())
            self.times.append(time.perf_counter() - before)
            assert answer.status == 200, answer.body
            state, turn = answer.json()["dialogue_state"], turn + 1


def main() -> None:
    """Print a table: turns a second, median and 95th percentile, without and with an import."""
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--rounds", type=int, default=3)
    arguments.add_argument("--robots", type=int, default=2)
    arguments.add_argument("--seconds", type=float, default=8)
    chosen = arguments.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        manage(folder / "var", "prepare", "--content", str(ROOT / "content"))
        shown = manage(folder / "var", "shell", "-c", MAKE_KEY)
        key = re.findall(r"cair_[\w-]{20,}", shown)[-1]
        server = start_server(folder / "var", folder / "log")
        try:
            measure(server, key, chosen)
        finally:
            server.stop()
            shutil.rmtree(folder / "var", ignore_errors=True)


def measure(server: Server, key: str, chosen: argparse.Namespace) -> None:
    """Talk for some seconds, then while the export comes back in; some rounds of both."""
    file = server.ask("GET", "/api/v1/ontology/", **{"X-Api-Key": key})
    assert file.status == 200, file.body[:300]
    print(
        f"{len(file.body) / 1e6:.1f} MB of ontology, {chosen.robots} robots, {os.cpu_count()} CPUs"
    )
    alone: list[float] = []
    beside: list[float] = []
    print("| | turns/s | median ms | p95 ms |\n| --- | --- | --- | --- |")
    for number in range(chosen.rounds):
        with Robots(server, chosen.robots) as robots:
            time.sleep(chosen.seconds)
        alone += row(f"alone {number + 1}", robots.times, chosen.seconds)
        data = changed(file.body, number)
        with Robots(server, chosen.robots) as robots:
            before = time.perf_counter()
            bring_in(server, key, data)
            seconds = time.perf_counter() - before
        beside += row(f"import {number + 1}, {seconds:.1f} s", robots.times, seconds)
    print(f"ratio of the medians: {median(beside) / median(alone):.2f} (target <= 2)")


def changed(data: bytes, number: int) -> bytes:
    """Return the file with one likeliness changed, so that there is something to write."""
    found = re.compile(rb"(hasLikeliness[^>]*>)0?\.\d+").sub(rb"\g<1>0.%d" % (11 + number), data, 1)
    assert found != data
    return found


def bring_in(server: Server, key: str, data: bytes) -> None:
    """Send the file and wait until it is in the draft."""
    headers = {"X-Api-Key": key, "Content-Type": "application/rdf+xml"}
    answer = server.ask("POST", "/api/v1/ontology/?apply=true", data, **headers)
    assert answer.status == 202, answer.body
    address = answer.json()["address"]
    while True:
        told = server.ask("GET", address, **{"X-Api-Key": key}).json()
        if told["ended"]:
            break
        time.sleep(0.5)
    assert told["step"] == "done", told


def row(what: str, times: list[float], seconds: float) -> list[float]:
    """Print one row of the table and return its times."""
    late = quantiles(times, n=20)[-1]
    speed = len(times) / seconds
    print(f"| {what} | {speed:.0f} | {median(times) * 1e3:.1f} | {late * 1e3:.1f} |", flush=True)
    return times


if __name__ == "__main__":
    main()
