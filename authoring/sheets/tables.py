"""A sheet as it was read: headers, rows of texts, the line each stood in."""

from dataclasses import dataclass


class UnreadableError(ValueError):
    """A file that cannot be read; the message says why and what to do."""


@dataclass(frozen=True, slots=True)
class Fault:
    """A cell that holds no text: in which column, and what to do."""

    column: str
    message: str


@dataclass(frozen=True, slots=True)
class Row:
    """One line of a sheet: its number as the program shows it, its texts by column."""

    number: int
    texts: dict[str, str]
    faults: tuple[Fault, ...] = ()


@dataclass(frozen=True, slots=True)
class Table:
    """A sheet: the columns it has, and its lines without the blank ones."""

    headers: tuple[str, ...]
    rows: tuple[Row, ...]
