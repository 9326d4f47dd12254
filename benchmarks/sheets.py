"""Spreadsheets at the full size: out, the preview of 2,000 rows, saving them.

python benchmarks/sheets.py [--topics 3000] [--sentences-per-leaf 8] [--rows 2000] [--kinds topics]

It works in a database of its own that is thrown away.
"""

import argparse
import os
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

if TYPE_CHECKING:
    from authoring.sheets.sheet import Sheet
    from authoring.sheets.tables import Table

Result = TypeVar("Result")
ROOT = Path(__file__).resolve().parent.parent


def timed(what: str, target: str, work: Callable[[], Result]) -> Result:
    """Print how long a step took, and return what it gave."""
    before, worked = time.perf_counter(), time.process_time()
    result = work()
    cpu = time.process_time() - worked
    print(f"| {what} | {time.perf_counter() - before:.2f} s | {cpu:.2f} s | {target} |")
    return result


def main() -> None:
    """Print a table."""
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--topics", type=int, default=3000)
    arguments.add_argument("--sentences-per-leaf", type=int, default=8)
    arguments.add_argument("--rows", type=int, default=2000)
    arguments.add_argument("--kinds", nargs="*", help="only these kinds of sheets")
    chosen = arguments.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        os.environ |= {"CAIR_VAR": folder, "DJANGO_SETTINGS_MODULE": "cair_site.settings"}
        os.environ.pop("DATABASE_URL", None)
        sys.path.insert(0, str(ROOT))
        import django

        django.setup()
        from django.core.management import call_command

        call_command("migrate", verbosity=0)
        measure(chosen.topics, chosen.sentences_per_leaf, chosen.rows, chosen.kinds)


def measure(topics: int, sentences_per_leaf: int, rows: int, kinds: list[str]) -> None:
    """Load a draft of this size; take every kind out, change it, look at it, save it."""
    from authoring.sheets.table import SHEETS
    from benchmarks.publish import world
    from ontology_io.store import write_base

    base = world(topics, sentences_per_leaf)
    frames = sum(len(topic.frames) for topic in base.knowledge.topics)
    print("| what | time | CPU | target |\n| --- | --- | --- | --- |")
    size = f"{len(base.knowledge.topics)} topics, {frames} sentences a language"
    timed(f"load {size}", "", lambda: write_base(base))
    for name, kind in SHEETS.items():
        if not kinds or name in kinds:
            one_kind(name, kind, rows)


def one_kind(name: str, kind: "type[Sheet]", rows: int) -> None:
    """Measure one kind of sheet."""
    from authoring.sheets.preview import preview, sealed
    from authoring.sheets.saving import changing, save, seen
    from authoring.sheets.writing import CSV, XLSX, written
    from plans.recording import recorded_for

    sheet = kind()
    lines = timed(f"{name}: read all for a sheet", "", lambda: list(sheet.lines({})))
    for form in (CSV, XLSX):
        timed(
            f"{name}: {len(lines)} rows as {form}",
            "",
            lambda: written(form, sheet.tab, sheet.headers(), lines),  # noqa: B023
        )
    for what, changed in (("unchanged", False), ("all changed", True)):
        table = read(sheet, lines[:: max(1, len(lines) // rows)][:rows], changed=changed)

        def look(table: "Table" = table) -> None:
            one = kind()
            records = one.judge(table)
            preview(one, table, records)
            sealed(one, table, records, 1)

        timed(f"{name}: preview of {len(table.rows)} rows, {what}", "<= 15 s", look)
    one = kind()
    wanted = changing(one.judge(table))
    with recorded_for(Writer()):
        timed(
            f"{name}: save {len(wanted)} rows, with history",
            "<= 30 s",
            lambda: save(kind(), kept(table, {record.number for record in wanted}), seen(wanted)),
        )


class Writer:
    """Stands for a request: rows that are saved are recorded."""

    user = None


def kept(table: "Table", numbers: set[int]) -> "Table":
    """Return a table with these lines alone."""
    from dataclasses import replace

    return replace(table, rows=tuple(row for row in table.rows if row.number in numbers))


def read(sheet: "Sheet", lines: list[list[str]], *, changed: bool) -> "Table":
    """Return lines as they are read from a file, each with something changed if asked."""
    from authoring.sheets.reading import read_table
    from authoring.sheets.writing import XLSX, written

    headers = sheet.headers()
    if changed:
        lines = [
            [new(name, text) for name, text in zip(headers, one, strict=True)] for one in lines
        ]
    data = written(XLSX, sheet.tab, headers, lines)
    words = f"{sheet.name}: read an .xlsx of {len(lines)} rows"
    return timed(words, "", lambda: read_table("a.xlsx", data, headers, sheet.tab))


def new(column: str, text: str) -> str:
    """Return a text that differs and is still right."""
    if column in ("EN", "IT", "JP", "IN"):
        return "0.25" if text != "0.25" else "0.75"
    more = {
        "English": " Indeed.",
        "Italian": " Davvero.",
        "Japanese": "そうです。",
        "note": " Seen.",
    }
    if column in ("trigger", "sentence", "English name"):
        return f"{text} indeed"
    return text + more.get(column, "")


if __name__ == "__main__":
    main()
