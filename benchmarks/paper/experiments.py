"""The three experiments of the paper: Baseline, Scalability with all at once and over 10 s."""

import time
from collections.abc import Iterator, Sequence
from statistics import fmean, median, pstdev, quantiles
from typing import NamedTuple

from tqdm import tqdm

from benchmarks.paper.load import Load, Result, Target, spread
from benchmarks.paper.systems import System

THRESHOLD = 1_000.0  # ms: what the paper calls acceptable
BASELINE, BURST, SPREAD = "baseline", "simultaneous", "over 10 s"
PERIOD = 10.0


class Plan(NamedTuple):
    """How long to measure: repetitions are cut where a step has used up its seconds."""

    requests: int
    spacing: float
    bursts: int
    spreads: int
    pause: float
    growth: float
    step_seconds: float
    most_steps: int
    refined: int


QUICK = Plan(12, 0.1, 2, 1, 0.3, 1.8, 8.0, 3, 1)
FULL = Plan(30, 0.5, 30, 5, 1.0, 1.35, 40.0, 6, 1)
#: The first N of each system: well below what it is expected to stand.
FIRST = {
    ("baseline", BURST): 20,
    ("baseline", SPREAD): 150,
    ("cair", BURST): 700,
    ("cair", SPREAD): 4_000,
}


class Row(NamedTuple):
    """One point of a figure; times in ms, `server` as the answers say."""

    experiment: str
    system: str
    n: int
    topics: int
    payload: int
    repetitions: int
    mean: float
    sd: float
    median: float
    p95: float
    server_mean: float
    server_sd: float
    errors: int

    @property
    def acceptable(self) -> bool:
        """Say whether the mean is within a second and everything was answered."""
        return self.mean <= THRESHOLD and not self.errors


class Point(NamedTuple):
    """What a row is about."""

    experiment: str
    n: int
    stage: int
    repetitions: int


def summary(system: System, point: Point, results: Sequence[Result]) -> Row:
    """Return the row of all results of a point; failed requests count with the time they took."""
    times = [1_000 * one.seconds for one in results]
    server = [one.server for one in results if one.server is not None] or [float("nan")]
    cuts = quantiles(times, n=20, method="inclusive") if len(times) > 1 else times * 19
    return Row(
        point.experiment,
        system.name,
        point.n,
        system.topics[point.stage],
        system.payloads[point.stage],
        point.repetitions,
        fmean(times),
        pstdev(times),
        median(times),
        cuts[18],
        fmean(server),
        pstdev(server) if len(server) > 1 else 0.0,
        sum(bool(one.error) for one in results),
    )


class Experiments:
    """Measures one system that is already serving."""

    def __init__(self, system: System, port: int, plan: Plan) -> None:
        self.system, self.plan = system, plan
        self.load = Load(Target("127.0.0.1", port))

    def all(self) -> Iterator[Row]:
        """Yield the rows of the three experiments."""
        self.load.run(self.system.requests[-1], spread(20, 2.0))
        stages = range(len(self.system.requests))
        for stage in tqdm(stages, desc=f"{self.system.name}, baseline", leave=False):
            yield self._baseline(stage)
        yield from self._grow(BURST, self.plan.bursts)
        yield from self._grow(SPREAD, self.plan.spreads)

    def largest(self) -> Row:
        """Return the row of the Baseline with the largest state alone."""
        self.load.run(self.system.requests[-1], spread(20, 2.0))
        return self._baseline(len(self.system.requests) - 1)

    def _baseline(self, stage: int) -> Row:
        """Send requests one after another, never two at once."""
        results: list[Result] = []
        for number in range(self.plan.requests):
            bodies = self.system.requests[stage]
            results += self.load.run([bodies[number % len(bodies)]], [0.0])
            time.sleep(self.plan.spacing)
        return summary(self.system, Point(BASELINE, 1, stage, self.plan.requests), results)

    def _grow(self, experiment: str, repetitions: int) -> Iterator[Row]:
        """Measure with more and more requests until the mean passes a second or one fails.

        Then measure again where the line seems to cross: it is bent there.
        """
        n, rows = FIRST[self.system.name, experiment], []
        for _ in range(self.plan.most_steps):
            rows.append(self._step(experiment, n, repetitions))
            yield rows[-1]
            if not rows[-1].acceptable:
                break
            n = round(n * self.plan.growth)
        for _ in range(self.plan.refined if crossing(rows)[1] else 0):
            n = max(1, crossing(rows)[0])
            measured = {row.n for row in rows}
            n = round((n * min(m for m in measured if m > n)) ** 0.5) if n in measured else n
            rows.append(self._step(experiment, n, repetitions))
            yield rows[-1]

    def _step(self, experiment: str, n: int, repetitions: int) -> Row:
        results: list[Result] = []
        dues = [0.0] * n if experiment == BURST else spread(n, PERIOD)
        until, done = time.monotonic() + self.plan.step_seconds, 0
        title = f"{self.system.name}, {experiment}, N = {n}"
        for _ in tqdm(range(repetitions), desc=title, leave=False):
            results += self.load.run(self.system.requests[-1], dues)
            done += 1
            if time.monotonic() > until:
                break
            time.sleep(self.plan.pause)
        return summary(self.system, Point(experiment, n, -1, done), results)


def crossing(rows: Sequence[Row]) -> tuple[int, bool]:
    """Return the N at which the mean is a second, and whether it was reached at all.

    Between the last acceptable step and the next it is where the line crosses; where requests
    failed it is the last acceptable step.
    """
    rows = sorted(rows, key=lambda row: row.n)
    first = next((row for row in rows if not row.acceptable), None)
    below = [row for row in rows if row.acceptable and (first is None or row.n < first.n)]
    if first is None or first.errors or not below:
        return (below[-1].n if below else 0, first is not None)
    last = below[-1]
    part = (THRESHOLD - last.mean) / (first.mean - last.mean)
    return (round(last.n + part * (first.n - last.n)), True)
