"""What a trigger must keep besides its grammar: known names, literal words, free text, size."""

from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from plans.engine.intents import Slot
from plans.engine.patterns import (
    Choice,
    Part,
    PhraseUse,
    Sequence,
    SlotUse,
    always_literal,
    expansions,
    parts_of,
)

MOST_EXPANSIONS = 10_000
MOST_FREE_SLOTS = 2


@dataclass(frozen=True, slots=True)
class Breach:
    """One broken rule; `near` is the piece of the trigger it is about."""

    message: str
    near: str = ""


@dataclass(frozen=True, slots=True)
class _Edges:
    """What free slots a piece may begin and end with, and whether two of them may meet."""

    begins: bool
    ends: bool
    empty: bool
    meet: bool


_NOTHING = _Edges(begins=False, ends=False, empty=True, meet=False)
_LITERAL = _Edges(begins=False, ends=False, empty=False, meet=False)
_FREE = _Edges(begins=True, ends=True, empty=False, meet=False)


def breaches(
    sequence: Sequence, slots: Mapping[str, Slot], phrases: Mapping[str, Sequence]
) -> Iterator[Breach]:
    """Yield every rule a trigger breaks."""
    unknown = tuple(_unknown(sequence, slots, phrases))
    yield from unknown
    if unknown:
        return
    listed = {name for name, slot in slots.items() if slot.list_key}
    if not always_literal(sequence, phrases, listed):
        yield Breach("A wording without any word of its own")
    size = expansions(sequence, phrases)
    if size > MOST_EXPANSIONS:
        yield Breach(f"{size} wordings, more than {MOST_EXPANSIONS}")
    if sum(isinstance(part, SlotUse) for part in parts_of(sequence)) > 1:
        yield from _slots_together(sequence, slots)


def _slots_together(sequence: Sequence, slots: Mapping[str, Slot]) -> Iterator[Breach]:
    """Yield the rules that only several slots in one trigger can break."""
    if _edges_of(sequence, slots).meet:
        yield Breach("Two free slots without a word between them")
    uses = _uses(sequence)
    if sum(number for name, number in uses.items() if slots[name].unbounded) > MOST_FREE_SLOTS:
        yield Breach(f"More than {MOST_FREE_SLOTS} free slots in one wording")
    for name, number in uses.items():
        if number > 1:
            yield Breach(f"Slot {name!r} twice in one wording", f"{{{name}")


def phrase_breaches(sequence: Sequence) -> Iterator[Breach]:
    """Yield every rule a phrase breaks: it holds neither slots nor other phrases."""
    for part in parts_of(sequence):
        if isinstance(part, SlotUse):
            yield Breach("A slot inside a phrase", f"{{{part.name}")
        elif isinstance(part, PhraseUse):
            yield Breach("A phrase inside a phrase", f"<{part.name}")
    size = expansions(sequence, {}) if not _references(sequence) else 0
    if size > MOST_EXPANSIONS:
        yield Breach(f"{size} wordings, more than {MOST_EXPANSIONS}")


def _references(sequence: Sequence) -> bool:
    return any(isinstance(part, PhraseUse) for part in parts_of(sequence))


def _unknown(
    sequence: Sequence, slots: Mapping[str, Slot], phrases: Mapping[str, Sequence]
) -> Iterator[Breach]:
    for part in parts_of(sequence):
        if isinstance(part, SlotUse) and part.name not in slots:
            yield Breach(f"Slot {part.name!r} is not declared", f"{{{part.name}")
        elif isinstance(part, PhraseUse) and part.name not in phrases:
            yield Breach(f"There is no phrase {part.name!r}", f"<{part.name}")


def _edges_of(sequence: Sequence, slots: Mapping[str, Slot]) -> _Edges:
    total = _NOTHING
    for part in sequence.parts:
        right = _part_edges(part, slots)
        total = _Edges(
            begins=total.begins or (total.empty and right.begins),
            ends=right.ends or (right.empty and total.ends),
            empty=total.empty and right.empty,
            meet=total.meet or right.meet or (total.ends and right.begins),
        )
    return total


def _part_edges(part: Part, slots: Mapping[str, Slot]) -> _Edges:
    if isinstance(part, SlotUse):
        return _FREE if slots[part.name].unbounded else _LITERAL
    if not isinstance(part, Choice):
        return _LITERAL
    options = [_edges_of(option, slots) for option in part.options]
    return _Edges(
        begins=any(option.begins for option in options),
        ends=any(option.ends for option in options),
        empty=part.optional or any(option.empty for option in options),
        meet=any(option.meet for option in options),
    )


def _uses(sequence: Sequence) -> Counter[str]:
    """Return how often each slot can stand in one wording, at most."""
    total: Counter[str] = Counter()
    for part in sequence.parts:
        if isinstance(part, SlotUse):
            total[part.name] += 1
        elif isinstance(part, Choice):
            most: Counter[str] = Counter()
            for option in part.options:
                most |= _uses(option)
            total += most
    return total
