"""One line of a sheet beside what the draft says: what it would change, and what is wrong."""

from dataclasses import dataclass, field
from typing import Any

NEW, CHANGED, DELETED, SAME, WRONG = "new", "changed", "deleted", "same", "wrong"


@dataclass(frozen=True, slots=True)
class Problem:
    """What is wrong in a line; `column` is "" where it is about the whole line."""

    column: str
    message: str


@dataclass(slots=True)
class Record:
    """One line: `old` as the draft says it (None: not there yet), `new` as the sheet wants it.

    `row` is the row of the draft it is about, and `parts` are those that belong to it; a sheet
    fills them when it looks the lines up.
    """

    key: str
    old: dict[str, str] | None = None
    new: dict[str, str] = field(default_factory=dict)
    row: Any = None
    parts: dict[str, Any] = field(default_factory=dict)
    number: int = 0
    delete: bool = False
    problems: list[Problem] = field(default_factory=list)
    note: str = ""

    @property
    def kind(self) -> str:
        """Return what becomes of the row: NEW, CHANGED, DELETED, SAME or WRONG."""
        if self.problems:
            return WRONG
        if self.delete:
            return DELETED
        if self.old is None:
            return NEW
        return SAME if self.old == self.new else CHANGED

    def again(self) -> "Record":
        """Return a record of the same row for one more line."""
        return Record(self.key, self.old, row=self.row, parts=dict(self.parts))

    def changed(self, *columns: str) -> bool:
        """Say whether one of these columns (or, of a new row, anything) is written."""
        old = self.old
        return old is None or any(old.get(one, "") != self.new.get(one, "") for one in columns)

    def refuse(self, column: str, message: str) -> None:
        """Note what is wrong; the same is told once."""
        problem = Problem(column, message)
        if problem not in self.problems:
            self.problems.append(problem)
