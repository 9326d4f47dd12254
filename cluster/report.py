"""The table of a trial, as Markdown and as CSV."""

import csv
from dataclasses import dataclass, field
from pathlib import Path

from cluster.load import Counted

HEADINGS = (
    "what happened",
    "seconds",
    "turns",
    "failed",
    "states that did not go on",
    "median (ms)",
    "99 % (ms)",
    "slowest (ms)",
    "new release served (s)",
    "seen",
)


@dataclass
class Seen:
    """What else was seen in a step."""

    text: str = ""
    served: list[tuple[float | None, str]] = field(default_factory=list)

    def add(self, text: str) -> None:
        """Note something."""
        self.text = f"{self.text}; {text}" if self.text else text

    def take_over(self, seconds: float | None, who: str) -> None:
        """Note after how long a publication was served, None where it was not, and by whom."""
        self.served.append((seconds, who))

    def served_text(self) -> str:
        """Return the seconds until the publication was served."""
        return "; ".join(
            f"{'never' if seconds is None else f'{seconds:.1f}'} ({who})"
            for seconds, who in self.served
        )

    def too_slow(self, most: float) -> list[str]:
        """Return which publications were served too late."""
        return [
            f"a publication was served by {who} after {seconds} s, {most} s are promised"
            for seconds, who in self.served
            if seconds is None or seconds > most
        ]


@dataclass(frozen=True, slots=True)
class Row:
    """One step of the trial."""

    what: str
    seconds: float
    counted: Counted
    seen: Seen

    def cells(self) -> tuple[str, ...]:
        """Return the row of the table, in the order of HEADINGS."""
        counted = self.counted
        times = (counted.median, counted.p99, counted.slowest)
        return (
            self.what,
            f"{self.seconds:.1f}",
            str(counted.turns),
            str(counted.failed),
            str(counted.not_continued),
            *(f"{1000 * one:.0f}" for one in times),
            self.seen.served_text(),
            self.seen.text,
        )

    def line(self) -> str:
        """Return the row for a terminal."""
        pairs = zip(HEADINGS[1:], self.cells()[1:], strict=True)
        return f"{self.what}: " + ", ".join(f"{name} {cell}" for name, cell in pairs if cell)


def markdown(rows: list[Row], how: str) -> str:
    """Return the page of a trial."""
    lines = [
        "# A cluster under steady load, broken in every way",
        "",
        f"Made by `make test-cluster`. {how} A turn is sent once: what the load balancer does not "
        "mend counts as failed. States are looked into after every fifth turn of a talk and at "
        "its end: the number of turns, the seed and the language must be those of the talk.",
        "",
        f"| {' | '.join(HEADINGS)} |",
        f"| --- |{' ---: |' * (len(HEADINGS) - 3)} --- | --- |",
        *(f"| {' | '.join(row.cells())} |" for row in rows),
        "",
    ]
    return "\n".join(lines)


def write_report(rows: list[Row], how: str, folder: Path) -> str:
    """Write cluster-trial.md and cluster-trial.csv into a folder; return the page."""
    folder.mkdir(parents=True, exist_ok=True)
    page = markdown(rows, how)
    (folder / "cluster-trial.md").write_text(page, encoding="utf-8")
    with (folder / "cluster-trial.csv").open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(HEADINGS)
        writer.writerows(row.cells() for row in rows)
    return page
