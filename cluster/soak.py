"""`python -m cluster.soak`: whether memory grows, or answers slow down, where people talk for long.

The rate is a share of what the cluster can do, which is measured first. Every minute the memory of
each process and the times of the turns are written to soak.csv; at the end soak.png and a verdict.
A leak is looked for in all memory that a process has (RSS). What is its own (USS) grows for a while
without one: the first write to a page of the shared content copies it, for which the content is the
bound.
"""

import argparse
import csv
import itertools
import sys
import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

from cluster.load import Counted, Load
from cluster.memory import Memory, family, memory_of
from cluster.processes import NotPossibleError, end_when_told
from cluster.running import Cluster, Wish, running
from cluster.trend import trend

MEASURING_SECONDS = 8.0
MOST_TALKERS = 30
MEGA = 1e6
COLUMNS = ("seconds", "turns", "failed", "states_broken", "p50_ms", "p99_ms", "max_ms")


@dataclass
class Minute:
    """What was seen in one stretch of time, by default a minute; `at` seconds after the start."""

    at: float
    counted: Counted
    memory: dict[str, Memory]


@dataclass
class Soak:
    """A cluster that is watched."""

    cluster: Cluster
    a_second: float
    every: float
    seen: list[Minute] = field(default_factory=list)

    def run(self, minutes: float) -> None:
        """Let people talk for so long."""
        talkers = max(1, min(MOST_TALKERS, int(self.a_second)))
        with Load(self.cluster.balancer.port, talkers, self.a_second) as load:
            began = since = time.monotonic()
            for number in itertools.count(1):
                due = began + number * self.every
                if due > began + 60 * minutes + 0.5:
                    break
                time.sleep(max(0.0, due - time.monotonic()))
                until = time.monotonic()
                counted = load.counted(since, until)
                load.forget(until)
                self.seen.append(Minute(until - began, counted, self._memory()))
                since = until
                print(self._line(), flush=True)

    def _memory(self) -> dict[str, Memory]:
        return {
            name: memory
            for name, process in self._processes()
            if (memory := memory_of(process)) is not None
        }

    def _processes(self) -> Iterator[tuple[str, int]]:
        for node in self.cluster.nodes:
            if node.process:
                first, *workers = family(node.process.pid)
                yield f"{node.name}.master", first
                for number, worker in enumerate(workers, 1):
                    yield f"{node.name}.worker{number}", worker
        if self.cluster.balancer.process:
            yield "haproxy", self.cluster.balancer.process.pid

    def _line(self) -> str:
        last = self.seen[-1]
        whole = sum(one.pss for one in last.memory.values())
        counted = last.counted
        return (
            f"{last.at:7.0f} s  {counted.turns} turns, {counted.failed} failed, "
            f"{counted.not_continued} broken, median {1000 * counted.median:.1f} ms, "
            f"99 % {1000 * counted.p99:.1f} ms, memory {whole / MEGA:.1f} MB"
        )


def capacity(cluster: Cluster) -> float:
    """Return how many turns a second the cluster takes when people do not wait between them."""
    port = cluster.balancer.port
    with Load(port, 8, 100_000) as warming:
        time.sleep(MEASURING_SECONDS / 4)
        warming.end()
    with Load(port, 8, 100_000) as load:
        began = time.monotonic()
        time.sleep(MEASURING_SECONDS)
        counted = load.counted(began, time.monotonic())
    return counted.turns / MEASURING_SECONDS


def write_csv(seen: list[Minute], path: Path) -> None:
    """Write a row for each stretch of time; memory in bytes, PSS, USS and RSS of each process."""
    names = list(dict.fromkeys(name for one in seen for name in one.memory))
    kinds = ("pss", "uss", "rss")
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow([*COLUMNS, *(f"{name}_{kind}" for name in names for kind in kinds)])
        for one in seen:
            counted = one.counted
            times = (counted.median, counted.p99, counted.slowest)
            row = [f"{one.at:.1f}", counted.turns, counted.failed, counted.not_continued]
            row += [f"{1000 * value:.2f}" for value in times]
            for name in names:
                memory = one.memory.get(name)
                row += [memory.pss, memory.uss, memory.rss] if memory else ["", "", ""]
            writer.writerow(row)


def verdicts(seen: list[Minute]) -> list[str]:
    """Return what grew: the memory of each process, the times of the turns; and what failed."""
    seconds = [one.at for one in seen]
    lines = []
    for name in dict.fromkeys(name for one in seen for name in one.memory):
        there = [one for one in seen if name in one.memory]
        found = trend([one.at for one in there], [float(one.memory[name].rss) for one in there])
        own = there[-1].memory[name].uss / MEGA
        told = found.text("MB", MEGA) if found else "too short"
        lines.append(f"memory of {name} (RSS): {told}; {own:.1f} MB of its own at the end")
    for share, values in (
        ("median", [1000 * one.counted.median for one in seen]),
        ("99 %", [1000 * one.counted.p99 for one in seen]),
    ):
        found = trend(seconds, values)
        lines.append(f"time of a turn ({share}): {found.text('ms') if found else 'too short'}")
    turns, failed = sum(one.counted.turns for one in seen), sum(one.counted.failed for one in seen)
    broken = sum(one.counted.not_continued for one in seen)
    lines.append(f"{turns} turns, {failed} failed, {broken} states did not go on")
    return lines


def plot(seen: list[Minute], path: Path) -> str:
    """Draw memory and times over time; return what was drawn, or why nothing was."""
    try:
        import matplotlib as mpl
    except ImportError:
        return "No picture: matplotlib is not installed (requirements-bench.txt)."
    mpl.use("agg")
    from matplotlib import pyplot

    figure, (upper, lower) = pyplot.subplots(2, 1, sharex=True, figsize=(9, 7))
    minutes = [one.at / 60 for one in seen]
    for name in dict.fromkeys(name for one in seen for name in one.memory):
        there = [one.memory.get(name) for one in seen]
        (line,) = upper.plot(minutes, [one and one.rss / MEGA for one in there], label=name)
        own = [one and one.uss / MEGA for one in there]
        upper.plot(minutes, own, color=line.get_color(), linestyle=":")
    upper.set_ylabel("memory (MB): all, RSS; dotted its own, USS")
    upper.set_ylim(bottom=0)
    upper.legend(fontsize="small")
    lower.plot(minutes, [1000 * one.counted.median for one in seen], label="median")
    lower.plot(minutes, [1000 * one.counted.p99 for one in seen], label="99 %")
    lower.set_ylabel("time of a turn (ms)")
    lower.set_yscale("log")
    lower.set_xlabel("minutes")
    lower.legend(fontsize="small")
    figure.tight_layout()
    figure.savefig(path, dpi=120)
    pyplot.close(figure)
    return f"Drawn: {path}"


def main() -> int:
    """Soak a cluster; 0 where nothing failed and nothing grew."""
    end_when_told()
    asked = _arguments()
    try:
        with running(Wish(asked.nodes, asked.workers, namespaces=not asked.loopback)) as cluster:
            most = capacity(cluster)
            print(f"It can take {most:.0f} turns a second (with the clients on this machine).")
            soak = Soak(cluster, asked.rate * most, asked.every)
            soak.run(asked.minutes)
    except NotPossibleError as error:
        print(f"No cluster here: {error}", file=sys.stderr)
        return 2
    asked.out.mkdir(parents=True, exist_ok=True)
    write_csv(soak.seen, asked.out / "soak.csv")
    print(plot(soak.seen, asked.out / "soak.png"))
    lines = verdicts(soak.seen)
    text = f"{soak.a_second:.0f} turns a second for {asked.minutes:g} minutes\n" + "\n".join(lines)
    (asked.out / "soak.txt").write_text(f"{text}\n", encoding="utf-8")
    print(text)
    bad = any(one.counted.failed or one.counted.not_continued for one in soak.seen)
    return 1 if bad or "GROWS" in text else 0


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m cluster.soak", description=__doc__)
    parser.add_argument("--minutes", type=float, default=30)
    parser.add_argument("--rate", type=float, default=0.5, help="share of the measured capacity")
    parser.add_argument("--every", type=float, default=60, help="seconds between two rows")
    parser.add_argument("--nodes", type=int, default=2)
    parser.add_argument("--workers", type=int, default=1, help="of each node")
    parser.add_argument("--loopback", action="store_true", help="no network namespaces")
    parser.add_argument("--out", type=Path, default=Path("docs/operations"), help="a folder")
    return parser.parse_args()


if __name__ == "__main__":
    sys.exit(main())
