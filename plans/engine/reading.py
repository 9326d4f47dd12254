"""A sentence as the matcher reads it: words (spaced languages) or characters (the others)."""

from collections.abc import Iterable
from dataclasses import dataclass

from languages.language import Language
from plans.engine.automaton import DIGITS, OTHER

MOST_WORDS = 60
MOST_CHARACTERS = 120
MOST_EDGES = 4
_SHORTEST_FOLDED = 3


@dataclass(frozen=True, slots=True)
class Reading:
    """The normalised units of a sentence and where each stands in the original."""

    sentence: str
    units: tuple[str, ...]
    spans: tuple[tuple[int, int], ...]
    others: tuple[int, ...]

    def original(self, start: int, end: int) -> str:
        """Return the person's own spelling of the units from `start` up to `end`."""
        return self.sentence[self.spans[start][0] : self.spans[end - 1][1]]


class Vocabulary:
    """The words that triggers know; accents match exactly first, then folded."""

    __slots__ = ("_folded", "_language", "_words")

    def __init__(self, language: Language, words: Iterable[str]) -> None:
        self._language = language
        self._words = frozenset(words)
        self._folded = {language.fold(word): word for word in sorted(self._words)}

    def known(self, word: str) -> str:
        """Return the word triggers use for this one ("perche" -> "perché"), or the word itself."""
        # Accents tell short words apart: "tè" is not "te".
        if word in self._words or len(word) < _SHORTEST_FOLDED:
            return word
        return self._folded.get(word if word.isascii() else self._language.fold(word), word)


def units_of(text: str, language: Language) -> tuple[str, ...]:
    """Return the units of a piece of a trigger, cut as `read` cuts a sentence."""
    return tuple([token.text for token in language.tokens(text)])


def read(sentence: str, language: Language, vocabulary: Vocabulary) -> Reading | None:
    """Return the reading of a sentence, or None where it is too long to be a request."""
    tokens = language.tokens(sentence)
    if len(tokens) > (MOST_WORDS if language.spaced else MOST_CHARACTERS):
        return None
    texts = [token.text for token in tokens]
    units = tuple([vocabulary.known(text) for text in texts] if language.spaced else texts)
    spans = tuple([(token.start, token.end) for token in tokens])
    others = tuple([DIGITS if unit.isdecimal() else OTHER for unit in units])
    return Reading(sentence, units, spans, others)


class Edges:
    """The skip words: "please", "could you", "hey robot" at the edges of a sentence."""

    __slots__ = ("_after", "_before", "_before_first", "_ends", "_longest")

    def __init__(self, before: Iterable[tuple[str, ...]], after: Iterable[tuple[str, ...]]) -> None:
        self._before = frozenset(filter(None, before))
        self._after = frozenset(filter(None, after))
        self._before_first = frozenset(words[0] for words in self._before)
        self._ends = frozenset(words[-1] for words in self._after)
        lengths = [len(words) for words in self._before | self._after]
        self._longest = max(lengths, default=0)

    def ranges(self, units: tuple[str, ...]) -> list[tuple[int, int]]:
        """Return the ranges that may be the request itself, with and without skip words."""
        starts, ends = self.starts(units), self.ends(units)
        return [(start, end) for start in starts for end in ends if start < end]

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
