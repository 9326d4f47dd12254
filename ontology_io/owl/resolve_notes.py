"""What is told while a file is compared with the draft, and small rules all parts share."""

import re
from collections.abc import Hashable, Iterable, Mapping
from types import MappingProxyType
from typing import TypeVar

from ontology_io.owl.file_records import Problem

T = TypeVar("T", bound=Hashable)

#: The highest numbers taken from a file: above, a robot's state would soon have no room.
HIGHEST: Mapping[str, int] = MappingProxyType(
    {"topic": 60_000, "frame": 10_000_000, "intent": 60_000}
)
_ID = re.compile(r"([tfi])([1-9][0-9]{0,8})(?:\.[a-z]{2,8})?")
_KINDS = {"t": "topic", "f": "frame", "i": "intent"}


class Notes:
    """Collects problems in the order they are found."""

    def __init__(self) -> None:
        self.problems: list[Problem] = []

    def note(self, where: str, text: str, hint: str = "") -> None:
        """Tell something that stops nothing."""
        self.problems.append(Problem(where=where, text=text, hint=hint, error=False))

    def error(self, where: str, text: str, hint: str) -> None:
        """Tell something that stops the import."""
        self.problems.append(Problem(where=where, text=text, hint=hint))


def number_in(id_: str, kind: str) -> int:
    """Return the number of an id of ours, 0 for others: t12, f7.en, i3."""
    found = _ID.fullmatch(id_)
    if not found or _KINDS[found.group(1)] != kind:
        return 0
    number = int(found.group(2))
    return number if number <= HIGHEST[kind] else 0


def agreed(values: Iterable[T], before: T | None) -> tuple[T, bool]:
    """Return the one value, or of several the first that was changed, and whether all agree."""
    distinct = list(dict.fromkeys(values))
    changed = [value for value in distinct if value != before]
    return (changed or distinct)[0], len(distinct) == 1


def same_set(new: tuple[str, ...], old: tuple[str, ...]) -> tuple[str, ...]:
    """Return the old order where both hold the same."""
    return old if set(new) == set(old) and len(new) == len(old) else new
