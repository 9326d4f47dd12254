"""A change between two releases, and how rows of any kind are compared."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from difflib import SequenceMatcher
from typing import Protocol, TypeVar

#: The groups in which changes are shown, in this order.
KINDS = (
    "cultures",
    "topics",
    "names",
    "keywords",
    "likeliness",
    "sentences",
    "pools",
    "intents",
    "vocabulary",
)


@dataclass(frozen=True, slots=True)
class Change:
    """One change: `kind` is one of KINDS, `where` the key of the row, `what` what became of it.

    `old` and `new` are texts as experts wrote them; `detail` is the language, culture or part that
    changed, `number` the stable number of the topic, sentence or intent. `release_words` says it
    in words by `kind` and `what`.
    """

    kind: str
    where: str
    what: str
    old: str = ""
    new: str = ""
    detail: str = ""
    number: int = 0


class Numbered(Protocol):
    """What has a stable number: topics, sentences, intents."""

    @property
    def number(self) -> int:
        """Return the number that stays when the key changes."""


Row = TypeVar("Row", bound=Numbered)
Value = TypeVar("Value")


@dataclass(frozen=True, slots=True)
class Make:
    """Makes the changes of one row: `make("text", "old", "new", "it")`."""

    kind: str
    where: str
    number: int = 0

    def __call__(self, what: str, old: str = "", new: str = "", detail: str = "") -> Change:
        """Return a change of this row."""
        return Change(self.kind, self.where, what, old, new, detail, self.number)


def by_number(rows: Iterable[Row]) -> dict[int, Row]:
    """Return rows by their stable number."""
    return {row.number: row for row in rows}


def field_changes(make: Make, old: object, new: object, names: Sequence[str]) -> Iterator[Change]:
    """Yield a change for each of these fields that differs, its values as text."""
    for name in names:
        before, after = getattr(old, name), getattr(new, name)
        if before != after:
            yield make(name, _text(before), _text(after))


def _text(value: object) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    return " | ".join(map(str, value)) if isinstance(value, tuple) else str(value)


def mapping_changes(
    make: Make,
    what: str,
    old: Mapping[str, Value],
    new: Mapping[str, Value],
    text: Callable[[Value], str] = str,
) -> Iterator[Change]:
    """Yield a change for each key (a language, a culture) whose value differs; "" where none is."""
    for key in {**old, **new}:
        before, after = old.get(key), new.get(key)
        if before != after:
            yield make(
                what,
                "" if before is None else text(before),
                "" if after is None else text(after),
                key,
            )


def list_changes(
    make: Make, what: str, old: Sequence[str], new: Sequence[str], detail: str = ""
) -> Iterator[Change]:
    """Yield what was added to a list, taken out of it, and changed at its place.

    `what` becomes "trigger_added", "trigger_removed", "trigger_changed", "trigger_order".
    """
    if old == new:
        return
    if sorted(old) == sorted(new):
        yield make(f"{what}_order", detail=detail)
        return
    matcher = SequenceMatcher(None, old, new, autojunk=False)
    for tag, i, j, k, m in matcher.get_opcodes():
        if tag == "equal":
            continue
        gone, come = old[i:j], new[k:m]
        pairs = min(len(gone), len(come))
        for before, after in zip(gone[:pairs], come[:pairs], strict=True):
            yield make(f"{what}_changed", before, after, detail)
        for before in gone[pairs:]:
            yield make(f"{what}_removed", before, "", detail)
        for after in come[pairs:]:
            yield make(f"{what}_added", "", after, detail)


def order_changes(make: Make, old: Sequence[int], new: Sequence[int]) -> Iterator[Change]:
    """Yield one change where rows that are in both come in another order."""
    both = set(old) & set(new)
    if [one for one in old if one in both] != [one for one in new if one in both]:
        yield make("order")
