"""One trigger as a machine that reads words: linear time whatever the trigger and the sentence.

A position automaton (Glushkov) whose sets of positions are the bits of an int. The sets met are
kept as rows of a deterministic machine, built on first use, so a known word costs one look-up.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from itertools import chain
from typing import NamedTuple

OTHER = 0
DIGITS = 1
_FIRST_WORD = 2
_MOST_ROWS = 1_000


@dataclass(slots=True)
class Draft:
    """The positions of a trigger while it is put together."""

    words: list[str] = field(default_factory=list)
    slots: list[str] = field(default_factory=list)
    follow: list[int] = field(default_factory=list)
    free: int = 0
    digits: int = 0
    closed: dict[int, frozenset[str]] = field(default_factory=dict)
    unlisted: int = 0

    def add(self, word: str, slot: str) -> int:
        """Add a position that reads `word` ("" where free or digits); return its bit."""
        self.words.append(word)
        self.slots.append(slot)
        self.follow.append(0)
        return 1 << (len(self.words) - 1)

    def add_free(self, slot: str) -> "Piece":
        """Add a position that reads one or more words of any kind."""
        bit = self.add("", slot)
        self.free |= bit
        self.follow[-1] |= bit
        return Piece(bit, bit, empty=False)

    def add_digits(self, slot: str) -> "Piece":
        """Add a position that reads a word of digits."""
        bit = self.add("", slot)
        self.digits |= bit
        return Piece(bit, bit, empty=False)

    def add_any(self, words: frozenset[str], slot: str) -> "Piece":
        """Add a position that reads one word of a set; of none: any one word, as a last resort."""
        bit = self.add("", slot)
        if words:
            self.closed[len(self.words) - 1] = words
        else:
            self.unlisted |= bit
        return Piece(bit, bit, empty=False)

    def chain(self, words: tuple[str, ...], slot: str = "") -> "Piece":
        """Add words one after another."""
        if not words:
            return EMPTY
        first, last = len(self.words), len(self.words) + len(words) - 1
        self.words += words
        self.slots += [slot] * len(words)
        self.follow += [1 << position + 1 for position in range(first, last)]
        self.follow.append(0)
        return Piece(1 << first, 1 << last, empty=False)

    def join(self, left: "Piece", right: "Piece") -> "Piece":
        """Return the piece that reads `left`, then `right`."""
        for position in bits(left.last):
            self.follow[position] |= right.first
        return Piece(
            left.first | (right.first if left.empty else 0),
            right.last | (left.last if right.empty else 0),
            empty=left.empty and right.empty,
        )


class Piece(NamedTuple):
    """A part of a trigger: where it can begin and end, and whether it can be left out."""

    first: int
    last: int
    empty: bool


EMPTY = Piece(0, 0, empty=True)


def either(pieces: list[Piece]) -> Piece:
    """Return the piece that reads any one of `pieces`."""
    first = last = 0
    for piece in pieces:
        first |= piece.first
        last |= piece.last
    return Piece(first, last, empty=any(piece.empty for piece in pieces))


def bits(mask: int) -> Iterator[int]:
    """Yield the numbers of the bits that are set, lowest first."""
    while mask:
        lowest = mask & -mask
        yield lowest.bit_length() - 1
        mask ^= lowest


class _Row(dict[int, "_Row"]):
    """A set of positions; its items are the next sets by kind of word, found when needed."""

    __slots__ = ("machine", "mask")

    def __init__(self, machine: "Automaton", mask: int) -> None:
        super().__init__()
        self.machine = machine
        self.mask = mask

    def __missing__(self, kind: int) -> "_Row":
        row = self.machine.row_after(self.mask, kind)
        if not self.machine.full:
            self[kind] = row
        return row


class _Ahead(dict[int, int]):
    """The positions that can come right after one of a set, found when first asked for."""

    __slots__ = ("_follow",)

    def __init__(self, follow: tuple[int, ...]) -> None:
        super().__init__()
        self._follow = follow

    def __missing__(self, mask: int) -> int:
        reached = _following(self._follow, mask)
        if len(self) < _MOST_ROWS:
            self[mask] = reached
        return reached


class Automaton:
    """Reads the words of a sentence; what it learns about rows is its only change.

    `start` is the bit of the place before the first word; `ahead[bits]` are the positions that can
    come right after these; `literal` are the positions of words outside slots;
    `reads[kinds.get(word, other)]` are the positions that read a word, `other` being its kind where
    the trigger does not know it.
    """

    __slots__ = (
        "_before",
        "_dead",
        "_first",
        "_follow",
        "_order",
        "_rows",
        "_start",
        "accept",
        "ahead",
        "free",
        "kinds",
        "literal",
        "reads",
        "slots",
        "start",
        "words",
    )

    def __init__(self, draft: Draft, whole: Piece) -> None:
        self.slots = tuple(draft.slots)
        self.words = tuple(draft.words)
        self.start = 1 << len(draft.words)
        self.accept = whole.last
        self.free = draft.free
        self._follow = (*draft.follow, whole.first)
        self._first = whole.first
        self.ahead = _Ahead(self._follow)
        self.kinds = {
            word: _FIRST_WORD + number
            for number, word in enumerate(
                dict.fromkeys(filter(None, chain(draft.words, *draft.closed.values())))
            )
        }
        self.reads = _reads(draft, self.kinds)
        self._before: tuple[int, ...] = ()
        self._order = _order(draft)
        self.literal = self._order[0]
        self._dead = _Row(self, 0)
        self._start = _Row(self, 0)
        self._rows: dict[int, _Row] = {0: self._dead}

    @property
    def full(self) -> bool:
        """Say whether no more rows are kept (the time stays linear without them)."""
        return len(self._rows) >= _MOST_ROWS

    @property
    def before(self) -> tuple[int, ...]:
        """Return the bits that can come right before each position; only what fits asks for it."""
        if not self._before:
            self._before = _before(self._follow)
        return self._before

    def row_after(self, mask: int, kind: int) -> _Row:
        """Return the row reached from a set of positions by a kind of word."""
        reached = _following(self._follow, mask) if mask else self._first
        reached &= self.reads[kind]
        row = self._rows.get(reached)
        if row is None:
            row = _Row(self, reached)
            if not self.full:
                self._rows[reached] = row
        return row

    def read(self, words: tuple[str, ...], others: tuple[int, ...]) -> list[int] | None:
        """Return the position that reads each word, or None where the sentence does not fit.

        `others` holds OTHER or DIGITS for each word: what it is if the trigger does not know it.
        """
        row, dead, kinds = self._start, self._dead, self.kinds
        masks: list[int] = []
        for word, other in zip(words, others, strict=True):
            row = row[kinds.get(word, other)]
            if row is dead:
                return None
            masks.append(row.mask)
        if not row.mask & self.accept:
            return None
        return self._trace(masks)

    def _trace(self, masks: list[int]) -> list[int]:
        """Walk back from the end; a literal word is preferred to a slot, so slots stay short."""
        path: list[int] = []
        allowed = self.accept
        for mask in reversed(masks):
            position = self.pick(mask & allowed)
            path.append(position)
            allowed = self.before[position]
        path.reverse()
        return path

    def pick(self, mask: int) -> int:
        """Return the latest position of the best kind: of equal words the one nearer to the end."""
        best = next((mask & preferred for preferred in self._order if mask & preferred), mask)
        return best.bit_length() - 1


def _following(follow: tuple[int, ...], mask: int) -> int:
    reached = 0
    for position in bits(mask):
        reached |= follow[position]
    return reached


def _reads(draft: Draft, kinds: Mapping[str, int]) -> dict[int, int]:
    """Return which positions read each kind of word."""
    anything = draft.free | draft.unlisted
    reads = {OTHER: anything, DIGITS: anything | draft.digits}
    for position, listed in enumerate(draft.words):
        for word in (listed,) if listed else draft.closed.get(position, ()):
            kind = kinds[word]
            usual = reads[DIGITS if word.isdecimal() else OTHER]
            reads[kind] = reads.get(kind, usual) | 1 << position
    return reads


def _before(followers: tuple[int, ...]) -> tuple[int, ...]:
    """Return what can stand before each position; the last entry of `followers` is the start."""
    before = [0] * len(followers)
    for position, follow in enumerate(followers):
        for after in bits(follow):
            before[after] |= 1 << position
    return tuple(before)


def _order(draft: Draft) -> tuple[int, ...]:
    """Return the masks in order of preference: literal words, listed values, digits, free text."""
    literal = values = 0
    for position, (word, slot) in enumerate(zip(draft.words, draft.slots, strict=True)):
        literal |= 0 if slot else 1 << position
        values |= 1 << position if slot and (word or position in draft.closed) else 0
    return (literal, values, draft.digits, draft.free)
