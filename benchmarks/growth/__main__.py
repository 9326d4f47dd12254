"""python -m benchmarks.growth [--only topics,intents] [--out docs/performance] [--draw]."""

import argparse
import tempfile
from pathlib import Path

from benchmarks.growth import rows
from benchmarks.growth.rows import Row
from benchmarks.growth.size import ROOT

LIMIT = 1.3


def measured(only: list[str]) -> list[Row]:
    """Return the rows of the sections, printed as they come."""
    from benchmarks.growth.sections import MEASURES
    from benchmarks.growth.turns import Site

    found: list[Row] = []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        site = Site(folder / "var")
        for section in only:
            here = list(MEASURES[section](site, folder))
            print(rows.table(here, section), flush=True)
            found += here
    return found


def verdicts(found: list[Row]) -> list[str]:
    """Return how the cost of a turn at the most topics stands to that at ten times fewer."""
    lines = []
    for case, points in rows.series(found, rows.TOPICS, rows.TURN).items():
        if len(points) > 1 and not case.startswith("all"):
            times = rows.ratio(points)
            verdict = "met" if times <= LIMIT else "MISSED"
            sizes = f"{points[-1][0]:,.0f} topics / {points[-2][0]:,.0f}"
            lines.append(f"{sizes}, {case}: {times:.2f} × (at most {LIMIT}): {verdict}")
    return lines


def main() -> None:
    """Measure what was asked for; write CSV and the figure."""
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--only", default=",".join(rows.SECTIONS), help="comma between")
    arguments.add_argument("--out", type=Path, default=ROOT / "docs" / "performance")
    arguments.add_argument("--draw", action="store_true", help="draw what was measured before")
    chosen = arguments.parse_args()
    file = chosen.out / "growth.csv"
    if not chosen.draw:
        only = chosen.only.split(",")
        old = [row for row in rows.read(file) if row.section not in only] if file.exists() else []
        found = measured(only)
        rows.write(file, [*old, *found])
    everything = rows.read(file)
    print(*verdicts(everything), sep="\n")
    from benchmarks.growth.figures import draw

    print(*draw(chosen.out, everything), sep="\n")


if __name__ == "__main__":
    main()
