"""The ledger content/numbers.tsv: which stable number each topic, frame and intent has.

Numbers are given once and never again, also when a row is gone: the states of people refer to
them. The lines `last topic 412` say up to which number they are taken.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from ontology_io.files.nodes import Problems

KINDS = ("topic", "frame", "intent")
LAST = "last"


@dataclass(slots=True)
class Ledger:
    """Numbers by kind and key; `slots` of frames; `last` number given by kind."""

    numbers: dict[str, dict[str, int]] = field(default_factory=lambda: {kind: {} for kind in KINDS})
    slots: dict[str, int] = field(default_factory=dict)
    last: dict[str, int] = field(default_factory=lambda: dict.fromkeys(KINDS, 0))


def read_ledger(text: str, problems: Problems) -> Ledger:
    """Return the ledger of a file; a line that cannot be read is a problem."""
    ledger = Ledger()
    for line, row in enumerate(text.splitlines(), 1):
        cells = row.split("\t")
        if not _read_row(ledger, cells):
            problems.add(line, f"{row!r} must be kind, key and number (and slot), apart by tabs.")
    return ledger


def _read_row(ledger: Ledger, cells: list[str]) -> bool:
    if len(cells) not in (3, 4) or not all(cell.isdecimal() for cell in cells[2:]):
        return False
    kind, key, number = cells[0], cells[1], int(cells[2])
    if kind == LAST and key in KINDS:
        ledger.last[key] = number
    elif kind in KINDS:
        ledger.numbers[kind][key] = number
        ledger.last[kind] = max(ledger.last[kind], number)
    else:
        return False
    if len(cells) == 4:
        ledger.slots[key] = int(cells[3])
    return True


def write_ledger(
    numbers: Mapping[str, Iterable[tuple[str, int, int]]], last: Mapping[str, int]
) -> str:
    """Return the text of a ledger: for each kind rows of key, number and slot (-1: none)."""
    rows = [f"{LAST}\t{kind}\t{last[kind]}" for kind in KINDS]
    for kind in KINDS:
        for key, number, slot in sorted(numbers[kind], key=lambda row: row[1]):
            rows.append(f"{kind}\t{key}\t{number}" + (f"\t{slot}" if slot >= 0 else ""))
    return "\n".join(rows) + "\n"
