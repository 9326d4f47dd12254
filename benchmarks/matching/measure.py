"""CPU time of calls in this thread, and tables of what came of it."""

import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from statistics import quantiles
from typing import NamedTuple


class Spread(NamedTuple):
    """Microseconds of CPU time a call."""

    p50: float
    p95: float

    def __str__(self) -> str:
        return f"{self.p50:,.0f} / {self.p95:,.0f}"


def spread(work: Callable[[str], object], sentences: Sequence[str], rounds: int) -> Spread:
    """Return the spread over sentences; each counts with its quickest round."""
    return together({"": work}, sentences, {"": rounds})[""]


def together(
    works: Mapping[str, Callable[[str], object]],
    sentences: Sequence[str],
    rounds: Mapping[str, int],
) -> dict[str, Spread]:
    """Return the spread of several works in turn.

    A round goes through all sentences before the next begins: what a matcher remembers of the last
    few sentences does not count.
    """
    best = {name: [10**15] * len(sentences) for name in works}
    for round_ in range(max(rounds.values())):
        chosen = {name: work for name, work in works.items() if round_ < rounds[name]}
        for place, sentence in enumerate(sentences):
            for name, work in chosen.items():
                begin = time.thread_time_ns()
                work(sentence)
                spent = time.thread_time_ns() - begin
                best[name][place] = min(best[name][place], spent)
    return {name: _spread([each / 1_000 for each in times]) for name, times in best.items()}


def _spread(times: Sequence[float]) -> Spread:
    if len(times) < 2:
        return Spread(times[0], times[0])
    cuts = quantiles(times, n=20, method="inclusive")
    return Spread(cuts[9], cuts[18])


def table(title: str, note: str, heads: Sequence[str], rows: Iterable[Sequence[object]]) -> None:
    """Print a table of Markdown under a title."""
    print(f"\n### {title}\n\n{note}\n")
    print(f"| {' | '.join(heads)} |\n|{' --- |' * len(heads)}")
    for row in rows:
        print(f"| {' | '.join(map(str, row))} |")


def percent(part: float, whole: float) -> str:
    """Return a share: `98.5 %`."""
    return f"{100 * part / whole:.1f} %" if whole else "–"
