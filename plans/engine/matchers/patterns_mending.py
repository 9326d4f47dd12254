"""Ways to mend one word of a sentence: a letter, a lost blank, a blank too much."""

from collections.abc import Iterator
from dataclasses import dataclass

from plans.engine.automaton import DIGITS, OTHER
from plans.engine.reading import Reading
from plans.engine.vocabulary import Vocabulary

MOST_MENDINGS = 24
_MOST_UNKNOWN = 10


@dataclass(frozen=True, slots=True)
class Mended:
    """The `length` units from `place` on are read as `words`; `said` is how they stand there.

    `accent` says that only accents were lost.
    """

    place: int
    length: int
    words: tuple[str, ...]
    said: str
    accent: bool = False


def mendings(reading: Reading, vocabulary: Vocabulary) -> tuple[Mended, ...]:
    """Return a bounded number of ways to mend one word."""
    options = list(_joined(reading.units, vocabulary))
    unknown = 0
    for place, unit in enumerate(reading.units):
        if vocabulary.has_twin(unit):
            twins = vocabulary.twins(unit)
            options += [Mended(place, 1, (word,), unit, accent=True) for word in twins]
        if unit in vocabulary.words or unit.isdecimal():
            continue
        unknown += 1
        if unknown > _MOST_UNKNOWN:
            break
        options += [Mended(place, 1, (word,), unit) for word in vocabulary.spelt(unit)]
        options += [Mended(place, 1, halves, unit) for halves in vocabulary.halves(unit)]
    return tuple(options[:MOST_MENDINGS])


def _joined(units: tuple[str, ...], vocabulary: Vocabulary) -> Iterator[Mended]:
    for place in range(len(units) - 1):
        word = units[place] + units[place + 1]
        if word in vocabulary.words and not word.isdecimal():
            yield Mended(place, 2, (word,), f"{units[place]} {units[place + 1]}")


def mended(reading: Reading, option: Mended) -> Reading:
    """Return the reading with one word mended; each word keeps its place in the original."""
    place, after = option.place, option.place + option.length
    start, end = reading.spans[place][0], reading.spans[after - 1][1]
    if len(option.words) == 1:
        spans: tuple[tuple[int, int], ...] = ((start, end),)
    else:
        middle = min(start + len(option.words[0]), end)
        spans = ((start, middle), (middle, end))
    others = tuple([DIGITS if word.isdecimal() else OTHER for word in option.words])
    return Reading(
        reading.sentence,
        reading.units[:place] + option.words + reading.units[after:],
        reading.spans[:place] + spans + reading.spans[after:],
        reading.others[:place] + others + reading.others[after:],
        reading.sounds,
    )
