"""The ledger content/numbers.tsv: which stable number each topic, frame and intent has.

Numbers are given once and never again, also when a row is gone: the states of people refer to
them. The lines `last topic 412` say up to which number they are taken.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

from dialogue.engine.state import MAX_FRAME, MAX_SLOT, MAX_TOPIC
from ontology_io.files.nodes import Problems

KINDS = ("topic", "frame", "intent")
LAST = "last"
#: What the dialogue state has room for.
LARGEST = MappingProxyType({"topic": MAX_TOPIC, "frame": MAX_FRAME, "intent": MAX_FRAME})


@dataclass(slots=True)
class Ledger:
    """Numbers by kind and key; `slots` of frames; `last` number given by kind."""

    numbers: dict[str, dict[str, int]] = field(default_factory=lambda: {kind: {} for kind in KINDS})
    slots: dict[str, int] = field(default_factory=dict)
    last: dict[str, int] = field(default_factory=lambda: dict.fromkeys(KINDS, 0))


def read_ledger(text: str, problems: Problems) -> Ledger:
    """Return the ledger of a file; a line that cannot be read, or gives twice, is a problem."""
    ledger = Ledger()
    given: set[tuple[str, str | int]] = set()
    for line, row in enumerate(text.splitlines(), 1):
        cells = row.split("\t")
        if not _is_row(cells):
            problems.add(line, f"{row[:200]!r} must be kind, key and number, apart by tabs.")
            continue
        kind, key, number = cells[0], cells[1], int(cells[2])
        for taken in (key, number) if kind != LAST else (key,):
            if (kind, taken) in given:
                problems.add(line, f"The {kind} {taken} stands here twice.")
        given |= {(kind, key), (kind, number)}
        _add(ledger, cells)
    return ledger


def _is_row(cells: list[str]) -> bool:
    """Say whether this is `kind key number`, with a slot for frames, or `last kind number`."""
    if len(cells) not in (3, 4) or not all(
        cell.isascii() and cell.isdecimal() and len(cell) < 11 for cell in cells[2:]
    ):
        return False
    kind, key, number = cells[0], cells[1], int(cells[2])
    if kind == LAST:
        return key in KINDS and len(cells) == 3 and number <= LARGEST[key]
    slot = int(cells[3]) if len(cells) == 4 else 0
    fits = 0 < number <= LARGEST.get(kind, 0) and slot <= MAX_SLOT
    return fits and (len(cells) == 3 or kind == "frame")


def _add(ledger: Ledger, cells: list[str]) -> None:
    kind, key, number = cells[0], cells[1], int(cells[2])
    if kind == LAST:
        ledger.last[key] = max(ledger.last[key], number)
        return
    ledger.numbers[kind][key] = number
    ledger.last[kind] = max(ledger.last[kind], number)
    if len(cells) == 4:
        ledger.slots[key] = int(cells[3])


def write_ledger(
    numbers: Mapping[str, Iterable[tuple[str, int, int]]], last: Mapping[str, int]
) -> str:
    """Return the text of a ledger: for each kind rows of key, number (0: none) and slot (-1)."""
    rows = [f"{LAST}\t{kind}\t{last[kind]}" for kind in KINDS]
    for kind in KINDS:
        for key, number, slot in sorted(numbers[kind], key=lambda row: row[1]):
            if number:
                rows.append(f"{kind}\t{key}\t{number}" + (f"\t{slot}" if slot >= 0 else ""))
    return "\n".join(rows) + "\n"
