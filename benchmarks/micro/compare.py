"""Figures beside those of another day, and whether they moved more than noise does."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

import msgspec

from benchmarks.micro.measure import CPU_SECONDS, MEGABYTES, MICROS, SECONDS, Figure
from benchmarks.micro.names import OWN, SHARED, START
from benchmarks.micro.works import ECHO_LARGEST

RECORDED = Path(__file__).with_name("recorded.json")
#: How far a ratio moves though nothing has changed: of five runs on a busy machine 125 of 130
#: ratios of microseconds stay this near to their median. A start by the clock tells little there.
NOISE = {MICROS: 0.20, SECONDS: 0.50, CPU_SECONDS: 0.15, MEGABYTES: 0.10}
WORDS = dict.fromkeys((MICROS, SECONDS, CPU_SECONDS), ("faster", "slower")) | {
    MEGABYTES: ("less", "more")
}
HEADS = ("name", "now", "ratio", "recorded", "now/recorded", "")


class Recorded(msgspec.Struct, frozen=True):
    """A figure of another day; only the ratio can be compared."""

    ratio: float
    value: float
    unit: str


class Target(NamedTuple):
    """What is wanted: a figure made of the figures, and the most it may be."""

    text: str
    most: float
    unit: str
    of: Callable[[Mapping[str, Figure]], float]


TARGETS = (
    Target(
        "turn, largest state / echo of the same body",
        2.0,
        "×",
        lambda found: found["turn, largest state"].value / found[ECHO_LARGEST].value,
    ),
    Target(
        "turn, largest state / smallest state",
        1.5,
        "×",
        lambda found: found["turn, largest state"].ratio / found["turn, smallest state"].ratio,
    ),
    Target(
        "state of 2,780 topics, read and write",
        400,
        MICROS,
        lambda found: (
            found["state, read, 2,780 topics"].value + found["state, write, 2,780 topics"].value
        ),
    ),
    Target(START, 3.0, SECONDS, lambda found: found[START].value),
    # What is shared is content and all of Python and its libraries; the target is for content.
    Target(f"{SHARED}, libraries too", 150, MEGABYTES, lambda found: found[SHARED].value),
    Target(OWN, 60, MEGABYTES, lambda found: found[OWN].value),
)


def read(file: Path = RECORDED) -> dict[str, Recorded]:
    """Return what was recorded, nothing where there is no file."""
    if not file.exists():
        return {}
    return msgspec.json.decode(file.read_bytes(), type=dict[str, Recorded])


def write(figures: Iterable[Figure], order: Sequence[str], file: Path = RECORDED) -> None:
    """Record figures; those of other names stay as they are, unless nobody has that name now."""
    kept = read(file)
    for one in figures:
        kept[one.name] = Recorded(round(one.ratio, 4), round(one.value, 3), one.unit)
    rows = {name: kept[name] for name in order if name in kept}
    file.write_bytes(msgspec.json.format(msgspec.json.encode(rows), indent=2) + b"\n")


def word(figure: Figure, recorded: Recorded | None) -> str:
    """Return "faster" or "slower" where the figure moved more than noise does, else ""."""
    if recorded is None:
        return "new"
    change = figure.ratio / recorded.ratio
    better, worse = WORDS[figure.unit]
    limit = 1 + NOISE[figure.unit]
    if change > limit:
        return worse
    return better if change < 1 / limit else ""


def table(figures: Sequence[Figure], recorded: Mapping[str, Recorded]) -> str:
    """Return a row for each figure, in columns."""
    rows = [HEADS, *(_row(one, recorded.get(one.name)) for one in figures)]
    widths = [max(len(row[column]) for row in rows) for column in range(len(HEADS))]
    lines = []
    for name, *cells, said in rows:
        middle = "  ".join(
            cell.rjust(width) for cell, width in zip(cells, widths[1:], strict=False)
        )
        lines.append(f"{name.ljust(widths[0])}  {middle}  {said}".rstrip())
    return "\n".join(lines)


def _row(figure: Figure, recorded: Recorded | None) -> tuple[str, ...]:
    now = f"{figure.value:,.1f} {figure.unit}"
    before = (f"{recorded.ratio:.3f}", f"{figure.ratio / recorded.ratio:.2f}") if recorded else ()
    return (
        figure.name,
        now,
        f"{figure.ratio:.3f}",
        *(before or ("–", "–")),
        word(figure, recorded),
    )


def targets(figures: Iterable[Figure]) -> list[str]:
    """Return a line for each target whose figures are there."""
    found, lines = {one.name: one for one in figures}, []
    for target in TARGETS:
        try:
            value = target.of(found)
        except KeyError:
            continue
        verdict = "met" if value <= target.most else "MISSED"
        lines.append(
            f"{target.text}: {value:,.2f} {target.unit} (at most {target.most:g}): {verdict}"
        )
    return lines
