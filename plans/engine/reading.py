"""A sentence as the matcher reads it: words (spaced languages) or characters (the others)."""

from collections.abc import Iterable

import msgspec

from languages.language import Language
from plans.engine.automaton import DIGITS, OTHER
from plans.engine.vocabulary import Vocabulary

MOST_WORDS = 60
MOST_CHARACTERS = 120
MOST_EDGES = 4


class Reading(msgspec.Struct, frozen=True):
    """The normalised units of a sentence and where each stands in the original.

    `sounds` says whether hesitations ("um") were left out.
    """

    sentence: str
    units: tuple[str, ...]
    spans: tuple[tuple[int, int], ...]
    others: tuple[int, ...]
    sounds: bool = False

    def original(self, start: int, end: int) -> str:
        """Return the person's own spelling of the units from `start` up to `end`."""
        return self.sentence[self.spans[start][0] : self.spans[end - 1][1]]


def units_of(text: str, language: Language) -> tuple[str, ...]:
    """Return the units of a piece of a trigger, cut as `read` cuts a sentence."""
    return tuple([token.text for token in language.tokens(text)])


def read(
    sentence: str, language: Language, vocabulary: Vocabulary, sounds: "Fillers"
) -> Reading | None:
    """Return the reading of a sentence, or None where it is too long to be a request."""
    tokens = language.tokens(sentence)
    if len(tokens) > (MOST_WORDS if language.spaced else MOST_CHARACTERS):
        return None
    texts = [token.text for token in tokens]
    units = tuple([vocabulary.known(text) for text in texts] if language.spaced else texts)
    spans = tuple([(token.start, token.end) for token in tokens])
    others = tuple([DIGITS if unit.isdecimal() else OTHER for unit in units])
    reading = Reading(sentence, units, spans, others)
    heard = sounds.runs(units)
    if not heard:
        return reading
    return without(reading, [place for run in heard for place in run], sounds=True)


def without(reading: Reading, places: Iterable[int], *, sounds: bool) -> Reading:
    """Return the reading without some units; `original` still gives one piece of the sentence."""
    dropped = frozenset(places)
    kept = [place for place in range(len(reading.units)) if place not in dropped]
    return Reading(
        reading.sentence,
        tuple([reading.units[place] for place in kept]),
        tuple([reading.spans[place] for place in kept]),
        tuple([reading.others[place] for place in kept]),
        sounds,
    )


class Fillers:
    """Words that say nothing ("um", "you know"), wherever they stand."""

    __slots__ = ("_first", "_last", "_listed", "_longest")

    def __init__(self, listed: Iterable[tuple[str, ...]]) -> None:
        self._listed = frozenset(filter(None, listed))
        self._first = frozenset(units[0] for units in self._listed)
        self._last = frozenset(units[-1] for units in self._listed)
        self._longest = max(map(len, self._listed), default=0)

    def runs(self, units: tuple[str, ...]) -> list[range]:
        """Return the places of each filler; where several begin, the longest counts."""
        found: list[range] = []
        if self._first.isdisjoint(units):
            return found
        place = 0
        while place < len(units):
            length = self._length_at(units, place) if units[place] in self._first else 0
            if length:
                found.append(range(place, place + length))
            place += length or 1
        return found

    def trimmed(self, units: tuple[str, ...], start: int, end: int) -> tuple[int, int]:
        """Cut fillers off both edges of a range; something always stays."""
        while units[start] in self._first:
            length = self._length_at(units[: end - 1], start)
            if not length:
                break
            start += length
        while units[end - 1] in self._last:
            lengths = range(min(self._longest, end - start - 1), 0, -1)
            length = next((size for size in lengths if units[end - size : end] in self._listed), 0)
            if not length:
                break
            end -= length
        return start, end

    def _length_at(self, units: tuple[str, ...], place: int) -> int:
        lengths = range(min(self._longest, len(units) - place), 0, -1)
        return next((size for size in lengths if units[place : place + size] in self._listed), 0)


class Edges:
    """The skip words: "please", "could you", "hey robot" at the edges of a sentence."""

    __slots__ = ("_after", "_before", "_before_first", "_ends", "_longest", "words")

    def __init__(self, before: Iterable[tuple[str, ...]], after: Iterable[tuple[str, ...]]) -> None:
        self._before = frozenset(filter(None, before))
        self._after = frozenset(filter(None, after))
        self._before_first = frozenset(words[0] for words in self._before)
        self._ends = frozenset(words[-1] for words in self._after)
        self.words = frozenset(word for words in self._before | self._after for word in words)
        lengths = [len(words) for words in self._before | self._after]
        self._longest = max(lengths, default=0)

    def ranges(self, units: tuple[str, ...]) -> list[tuple[int, int]]:
        """Return the ranges that may be the request itself, with and without skip words."""
        starts, ends = self.starts(units), self.ends(units)
        return [(start, end) for start in starts for end in ends if start < end]

    def widest_and_shortest(self, units: tuple[str, ...]) -> list[tuple[int, int]]:
        """Return the whole sentence and what is left of it without any skip words."""
        start, end = max(self.starts(units)), min(self.ends(units))
        whole = (0, len(units))
        return [whole, (start, end)] if start < end and (start, end) != whole else [whole]

    def starts(self, units: tuple[str, ...]) -> list[int]:
        """Return where the request can begin."""
        places = [0]
        for place in places:
            if len(places) > MOST_EDGES or place >= len(units):
                break
            if units[place] not in self._before_first:
                continue
            for length in range(1, self._longest + 1):
                after = place + length
                if units[place:after] in self._before and after not in places:
                    places.append(after)
        return places

    def ends(self, units: tuple[str, ...]) -> list[int]:
        """Return where the request can end."""
        places = [len(units)]
        for place in places:
            if len(places) > MOST_EDGES or place == 0:
                break
            if units[place - 1] not in self._ends:
                continue
            for length in range(1, min(self._longest, place) + 1):
                before = place - length
                if units[before:place] in self._after and before not in places:
                    places.append(before)
        return places
