"""A benchmark and what becomes of it: figures with the reference measured in the same rounds."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

from benchmarks.micro.reference import cpu_micros, reference

MICROS, SECONDS, CPU_SECONDS, MEGABYTES = "µs", "s", "CPU s", "MB"
ROUND_MICROS = 2_500
LEAST_REFERENCES = 60
#: The first after other work finds its caches cold, and how cold differs: it hardly ever counts.
AT_ONCE = 3


class Figure(NamedTuple):
    """What was measured; `ratio` is in units of the reference, of a megabyte for memory."""

    name: str
    value: float
    unit: str
    ratio: float


@dataclass(frozen=True)
class Work:
    """`run` does the work `calls` times; `beside` is done in the same rounds, for comparison."""

    run: Callable[[], object]
    calls: int = 1
    rounds: int = 60
    beside: "Mapping[str, Work]" = field(default_factory=dict)


def repeated(call: Callable[[], object]) -> Work:
    """Return a short piece of work, done as often as fills a round."""
    calls = max(1, round(ROUND_MICROS / max(min(cpu_micros(call) for _ in range(5)), 0.1)))

    def run() -> None:
        for _ in range(calls):
            call()

    return Work(run, calls)


class Rounds:
    """Measures what stands beside a benchmark before each of its rounds, and keeps the least."""

    def __init__(self, name: str, work: Work) -> None:
        self.name, self.work = name, work
        self.references = max(AT_ONCE, -(-LEAST_REFERENCES // work.rounds))
        self.reference = float("inf")
        self.beside = dict.fromkeys(work.beside, float("inf"))

    def before(self) -> None:
        """Measure reference and companions once more."""
        for _ in range(self.references):
            self.reference = min(self.reference, cpu_micros(reference))
        for name, one in self.work.beside.items():
            self.beside[name] = min(self.beside[name], cpu_micros(one.run) / one.calls)

    def figures(self, least: float) -> list[Figure]:
        """Return the figures, given the microseconds of the quickest round."""
        found = {self.name: least / self.work.calls} | self.beside
        return [
            Figure(name, value, MICROS, value / self.reference) for name, value in found.items()
        ]
