"""What is measured, as rows: how they are printed, written, and read back."""

import csv
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import NamedTuple

TURN, STATE = "turn", "state"
PUBLISH, LOAD, MEMORY = "publish", "load", "memory"
UNITS = {TURN: "µs", STATE: "characters", PUBLISH: "s", LOAD: "s", MEMORY: "MB"}
TOPICS, SENTENCES, INTENTS, TALK = "topics", "sentences a topic", "intents", "turns of a talk"
SECTIONS = (TOPICS, SENTENCES, INTENTS, TALK)


class Row(NamedTuple):
    """A figure: of what, at which size (`x` of `section`), in which case ("" where only one)."""

    section: str
    x: float
    what: str
    case: str
    value: float


def series(rows: Iterable[Row], section: str, what: str) -> dict[str, list[tuple[float, float]]]:
    """Return the points of each case, ascending."""
    found: dict[str, list[tuple[float, float]]] = {}
    for row in rows:
        if (row.section, row.what) == (section, what):
            found.setdefault(row.case, []).append((row.x, row.value))
    return {case: sorted(points) for case, points in found.items()}


def ratio(points: Sequence[tuple[float, float]]) -> float:
    """Return how many times the last figure is the one before it."""
    return points[-1][1] / points[-2][1]


def table(rows: Sequence[Row], section: str) -> str:
    """Return a table of one section: a row for each figure and case, a column for each size."""
    sizes = sorted({row.x for row in rows if row.section == section})
    heads = [f"{size:,.0f}" for size in sizes]
    lines = [
        f"\n| {section} | {' | '.join(heads)} | last / before |",
        f"|{' --- |' * (len(heads) + 2)}",
    ]
    for what, unit in UNITS.items():
        for case, points in series(rows, section, what).items():
            values = dict(points)
            cells = [_cell(values.get(size)) for size in sizes]
            last = f"{ratio(points):.2f} ×" if len(points) > 1 else ""
            name = f"{what}, {case}" if case else what
            lines.append(f"| {name}, {unit} | {' | '.join(cells)} | {last} |")
    return "\n".join(lines)


def _cell(value: float | None) -> str:
    if value is None:
        return ""
    return f"{value:,.0f}" if value >= 100 else f"{value:.2f}"


def write(file: Path, rows: Iterable[Row]) -> None:
    """Write all rows as CSV."""
    file.parent.mkdir(parents=True, exist_ok=True)
    with file.open("w", encoding="utf-8", newline="") as out:
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow([*Row._fields, "unit"])
        writer.writerows([*row[:-1], f"{row.value:.6g}", UNITS[row.what]] for row in rows)


def read(file: Path) -> list[Row]:
    """Return the rows of a CSV file."""
    with file.open(encoding="utf-8", newline="") as lines:
        return [
            Row(one["section"], float(one["x"]), one["what"], one["case"], float(one["value"]))
            for one in csv.DictReader(lines)
        ]
