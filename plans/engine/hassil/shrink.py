"""Brings converted triggers into the limits of the grammar: depth, length, number of wordings."""

from collections.abc import Callable, Mapping
from itertools import product

from plans.engine.patterns import (
    DEEPEST,
    LONGEST,
    Choice,
    Part,
    PhraseUse,
    Sequence,
    Word,
    always_literal,
    expansions,
    print_pattern,
)

MOST_TRIGGERS = 400
_MOST_OPTIONS = 1_000
_NOTHING = Sequence(())


class TooLargeError(ValueError):
    """A template that cannot be brought into the limits."""


def simplified(sequence: Sequence, has_words: Callable[[str], bool]) -> Sequence:
    """Return the same sentences said shorter; signs that are never heard are left out."""
    parts: list[Part] = []
    for part in sequence.parts:
        if isinstance(part, Choice):
            parts += _simple_choice(part, has_words)
        elif not isinstance(part, Word) or has_words(part.text):
            parts.append(part)
    return Sequence(tuple(parts))


def _simple_choice(choice: Choice, has_words: Callable[[str], bool]) -> tuple[Part, ...]:
    optional = choice.optional
    options: dict[Sequence, None] = {}
    for option in (simplified(option, has_words) for option in choice.options):
        inner = option.parts[0] if len(option.parts) == 1 else None
        if isinstance(inner, Choice):
            optional = optional or inner.optional
            options |= dict.fromkeys(inner.options)
        elif option.parts:
            options[option] = None
        else:
            optional = True
    kept = tuple(options)
    if not kept:
        return ()
    return kept[0].parts if len(kept) == 1 and not optional else (Choice(kept, optional),)


def flattened(sequence: Sequence, deepest: int = DEEPEST) -> Sequence:
    """Return the same sentences with brackets at most so deep: inner choices are multiplied out."""
    return Sequence(tuple(_flat_part(part, deepest) for part in sequence.parts))


def _flat_part(part: Part, deepest: int) -> Part:
    if not isinstance(part, Choice):
        return part
    if deepest > 1:
        return Choice(
            tuple(flattened(option, deepest - 1) for option in part.options), part.optional
        )
    options: dict[Sequence, None] = {}
    optional = part.optional
    for option in part.options:
        for form in _multiplied(option):
            optional = optional or form == _NOTHING
            options[form] = None
    options.pop(_NOTHING, None)
    return Choice(tuple(options), optional)


def _multiplied(sequence: Sequence) -> list[Sequence]:
    ways: list[list[tuple[Part, ...]]] = []
    total = 1
    for part in sequence.parts:
        ways.append(_part_ways(part))
        total *= len(ways[-1])
        if total > _MOST_OPTIONS:
            raise TooLargeError(f"Brackets deeper than {DEEPEST} with too many choices")
    return [Sequence(tuple(p for way in form for p in way)) for form in product(*ways)]


def _part_ways(part: Part) -> list[tuple[Part, ...]]:
    if not isinstance(part, Choice):
        return [(part,)]
    ways = [form.parts for option in part.options for form in _multiplied(option)]
    return [*ways, ()] if part.optional else ways


def split(
    sequence: Sequence, phrases: Mapping[str, Sequence], most_wordings: int
) -> list[Sequence]:
    """Return triggers that together say the same, each within the limits of a trigger."""
    waiting, done = [sequence], []
    while waiting:
        one = waiting.pop()
        halves = () if _fits(one, phrases, most_wordings) else _halves(one, phrases)
        if halves:
            waiting += halves
        else:
            done.append(one)
        if len(waiting) + len(done) > MOST_TRIGGERS:
            raise TooLargeError(f"More than {MOST_TRIGGERS} triggers would be needed")
    return [one for one in reversed(done) if one.parts]


def _fits(sequence: Sequence, phrases: Mapping[str, Sequence], most_wordings: int) -> bool:
    return (
        expansions(sequence, phrases) <= most_wordings and len(print_pattern(sequence)) <= LONGEST
    )


def _halves(sequence: Sequence, phrases: Mapping[str, Sequence]) -> tuple[Sequence, ...]:
    """Return two sequences for one: its largest choice is cut in two."""
    long = len(print_pattern(sequence)) > LONGEST
    kinds = (Choice,) if long else (Choice, PhraseUse)
    places = [place for place, part in enumerate(sequence.parts) if isinstance(part, kinds)]
    places = [place for place in places if _size(sequence.parts[place], phrases, long=long) > 1]
    if not places:
        return ()
    place = max(places, key=lambda place: _size(sequence.parts[place], phrases, long=long))
    before, after = sequence.parts[:place], sequence.parts[place + 1 :]
    return tuple(
        Sequence((*before, *middle, *after)) for middle in _cut(sequence.parts[place], phrases)
    )


def _size(part: Part, phrases: Mapping[str, Sequence], *, long: bool) -> int:
    alone = Sequence((part,))
    return len(print_pattern(alone)) if long else expansions(alone, phrases)


def _cut(part: Part, phrases: Mapping[str, Sequence]) -> tuple[tuple[Part, ...], ...]:
    if isinstance(part, PhraseUse):
        return (phrases[part.name].parts,)
    if not isinstance(part, Choice):
        return ((part,),)
    if part.optional:
        return (_chosen(part.options), ())
    middle = len(part.options) // 2
    return (_chosen(part.options[:middle]), _chosen(part.options[middle:]))


def _chosen(options: tuple[Sequence, ...]) -> tuple[Part, ...]:
    return options[0].parts if len(options) == 1 else (Choice(options, optional=False),)


def with_a_word(sequence: Sequence, phrases: Mapping[str, Sequence]) -> list[Sequence]:
    """Return triggers for all wordings but those of slots alone, which our grammar refuses."""
    if always_literal(sequence, phrases):
        return [sequence]
    found = [
        Sequence((*sequence.parts[:place], *_required(part), *sequence.parts[place + 1 :]))
        for place, part in enumerate(sequence.parts)
        if isinstance(part, Choice)
    ]
    kept = [one for one in found if always_literal(one, phrases)]
    return kept or [sequence]


def _required(choice: Choice) -> tuple[Part, ...]:
    return _chosen(choice.options)
