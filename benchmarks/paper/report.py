"""What came out: CSV, a table in Markdown with the paper's figures beside ours."""

import csv
import os
import platform
from collections.abc import Sequence
from pathlib import Path

from benchmarks.paper.experiments import BASELINE, BURST, SPREAD, THRESHOLD, Row, crossing

PAPER_PAYLOADS = (369, 6_384, 12_213, 18_166)
PAPER_MEAN, PAPER_SERVER, PAPER_BURST, PAPER_SPREAD = 189.0, 107.4, 20, 250
HEAD = "| | the paper | its design, re-created here | ours | ours to re-created |\n"
RULE = "| --- | ---: | ---: | ---: | ---: |\n"
SYSTEMS = ("baseline", "cair")


def chosen(rows: Sequence[Row], experiment: str, system: str) -> list[Row]:
    """Return the rows of one experiment and system, by N."""
    found = [row for row in rows if (row.experiment, row.system) == (experiment, system)]
    return sorted(found, key=lambda row: row.n)


def write_csv(folder: Path, rows: Sequence[Row]) -> None:
    """Write a file of CSV for each experiment."""
    folder.mkdir(parents=True, exist_ok=True)
    for experiment in (BASELINE, BURST, SPREAD):
        name = experiment.replace(" ", "-")
        with (folder / f"{name}.csv").open("w", encoding="utf-8", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(Row._fields)
            for row in rows:
                if row.experiment == experiment:
                    writer.writerow(_cell(value) for value in row)


def _cell(value: object) -> object:
    return f"{value:.3f}" if isinstance(value, float) else value


def markdown(rows: Sequence[Row], *, quick: bool) -> str:
    """Return the page: what was compared, the table, the figures."""
    lines = [_row(*one) for one in _baseline_lines(rows)]
    lines += [_capacity(rows, BURST, "requests at once at a mean of 1 s", PAPER_BURST)]
    lines += [_capacity(rows, SPREAD, "requests over 10 s at a mean of 1 s", PAPER_SPREAD)]
    lines += [_server_at_once(rows), _errors(rows)]
    lines += [_old_route(row) for row in rows if row.system == "old route"]
    return _intro(quick=quick) + "\n" + HEAD + RULE + "".join(lines) + _figures()


def _intro(*, quick: bool) -> str:
    kind = "a quick run with few repetitions" if quick else "a full run"
    return (
        "# The paper's experiments, repeated\n\n"
        "Written by `python -m benchmarks.paper`: "
        f"{kind} on {os.cpu_count()} cores, Python {platform.python_version()}, "
        f"{platform.system()}, clients on loopback and on the same cores.\n"
        "Each request has a connection of its own. A response time counts from the moment the\n"
        "request was due; server processing is what the answer's `Server-Timing` says.\n"
        "The paper's own design is re-created from its text; how its state was laid out is not\n"
        "told, so the layout was chosen by the sizes of the paper's payloads.\n"
    )


def _baseline_lines(rows: Sequence[Row]) -> list[tuple[str, str, list[float]]]:
    theirs, ours = (chosen(rows, BASELINE, name) for name in SYSTEMS)
    lines = [
        (f"payload at {own.topics:,} topics, bytes", f"{paper:,}", [one.payload, own.payload])
        for paper, one, own in zip(PAPER_PAYLOADS, theirs, ours, strict=True)
    ]
    last, own = theirs[-1], ours[-1]
    lines += [
        ("mean response, largest payload, ms", f"{PAPER_MEAN:g}", [last.mean, own.mean]),
        (
            "server processing, largest payload, ms",
            f"{PAPER_SERVER:g}",
            [last.server_mean, own.server_mean],
        ),
        ("mean response, smallest payload, ms", "–", [theirs[0].mean, ours[0].mean]),
        ("95th percentile, largest payload, ms", "–", [last.p95, own.p95]),
    ]
    return lines


def _row(what: str, paper: str, figures: Sequence[float]) -> str:
    theirs, ours = figures
    return f"| {what} | {paper} | {_text(theirs)} | {_text(ours)} | {ours / theirs:.3g} × |\n"


def _text(value: float) -> str:
    return f"{value:,.2f}" if isinstance(value, float) else f"{value:,}"


def _capacity(rows: Sequence[Row], experiment: str, what: str, paper: int) -> str:
    (theirs, reached), (ours, end) = (crossing(chosen(rows, experiment, name)) for name in SYSTEMS)
    marks = ["" if one else "≥ " for one in (reached, end)]
    ratio = f"{ours / theirs:.3g} ×" if theirs else "–"
    return f"| {what} | {paper} | {marks[0]}{theirs:,} | {marks[1]}{ours:,} | {ratio} |\n"


def _server_at_once(rows: Sequence[Row]) -> str:
    """Return the row of what the paper counted besides: N until processing takes a second."""
    cells = []
    for name in SYSTEMS:
        steps = chosen(rows, BURST, name)
        over = next((row.n for row in steps if row.server_mean > THRESHOLD), None)
        largest = max((row.server_mean for row in steps), default=0.0)
        cells.append(f"{over:,}" if over else f"never, {largest:,.0f} ms at the most")
    return f"| requests at once until processing takes 1 s | 50 | {cells[0]} | {cells[1]} | |\n"


def _old_route(row: Row) -> str:
    return (
        f"| old clients' route, largest state: bytes, mean response | 18,166, 189 | – "
        f"| {row.payload:,}, {row.mean:.2f} | |\n"
    )


def _errors(rows: Sequence[Row]) -> str:
    counts = [sum(row.errors for row in rows if row.system == name) for name in SYSTEMS]
    return f"| requests that failed | – | {counts[0]} | {counts[1]} | |\n"


def _figures() -> str:
    names = (
        ("baseline", "Baseline test"),
        ("simultaneous", "All at once"),
        ("over-10-s", "Over 10 s"),
    )
    return "".join(f"\n![{title}]({name}.svg)\n" for name, title in names)
