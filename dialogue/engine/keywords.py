"""Keywords: "I like green tea" is about GreenTea (green / tea) before Tea (tea / *)."""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import accumulate, product
from operator import itemgetter
from typing import NamedTuple

import msgspec

from dialogue.engine.keywords_places import Finder, Place, build_finder
from languages.language import Language, Token

ANYTHING = "*"
MAX_FORMS = 64  # of one phrase: "tè verde" has a form for each ending of each word
SHORTEST_FOLDED = 4  # below, a word without its accent is mostly another one: tè, te

_TWO, _WILDCARD, _COVERED = 2, 1, 0


@dataclass(frozen=True, slots=True)
class KeywordRow:
    """Two sets of phrases of one topic; "*" in a set means that the other one is enough."""

    topic: int
    first: tuple[str, ...]
    second: tuple[str, ...]


class KeywordMatch(msgspec.Struct, frozen=True):
    """A topic that a sentence is about, the words that say so as the person wrote them."""

    topic: int
    words: tuple[str, ...]
    wildcard: bool
    rank: tuple[int, int]  # two sets before one before words of a longer keyword; then characters


@dataclass(frozen=True, slots=True)
class _Row:
    """A row with its phrases as numbers."""

    topic: int
    first: tuple[int, ...]
    second: tuple[int, ...]
    wildcard: bool

    def drivers(self, usage: Mapping[int, int]) -> tuple[int, ...]:
        """Return the phrases that make a sentence look at this row: the rarer set is enough.

        "jazz" leads to jazz / music; "music" alone does not lead to the hundred kinds of it.
        """
        if self.wildcard:
            return self.first + self.second
        return min(self.first, self.second, key=lambda phrases: sum(usage[p] for p in phrases))


class _Hit(NamedTuple):
    rank: tuple[int, int]
    topic: int
    places: tuple[Place, ...]


@dataclass(frozen=True, slots=True)
class KeywordIndex:
    """All keywords of a language; a search costs by the sentence, not by the topics."""

    language: Language
    finder: Finder
    phrases: Mapping[str, tuple[int, ...]]  # form -> numbers of the phrases it is a form of
    rows: Mapping[int, tuple[_Row, ...]]  # number of a phrase -> rows it drives

    def search(self, sentence: str) -> tuple[KeywordMatch, ...]:
        """Return all topics that match, best rank first, each once; () where none does.

        Example: `index.search("green tea")[0].words == ("green", "tea")`.
        """
        tokens = self.language.tokens(sentence)
        places = self.finder.places(sentence, tokens)
        if not places:
            return ()
        best: dict[int, _Hit] = {}
        for hit in self._hits(self._found(places)):
            known = best.get(hit.topic)
            if known is None or hit.rank > known.rank:
                best[hit.topic] = hit
        numbers = range(len(tokens) + 1) if self.language.spaced else _token_numbers(tokens)
        reach = _reach(best.values()) if len(best) > 1 else []
        matches = [
            KeywordMatch(
                hit.topic,
                _words(hit, sentence, tokens, numbers),
                hit.rank[0] == _WILDCARD,
                (_COVERED, hit.rank[1]) if reach and _is_covered(hit, reach) else hit.rank,
            )
            for hit in best.values()
        ]
        matches.sort(key=lambda match: (-match.rank[0], -match.rank[1], match.topic))
        return tuple(matches)

    def _found(self, places: Iterable[Place]) -> dict[int, list[Place]]:
        """Return the places of each phrase: the first two and the last are all that matter."""
        found: dict[int, list[Place]] = {}
        for place in places:
            for phrase in self.phrases[place.form]:
                known = found.setdefault(phrase, [])
                if len(known) == 3:
                    known.pop()
                known.append(place)
        return found

    def _hits(self, found: Mapping[int, Sequence[Place]]) -> Iterator[_Hit]:
        for phrase in found:
            for row in self.rows.get(phrase, ()):
                hit = self._pair(row, found) or self._single(row, found)
                if hit:
                    yield hit

    def _pair(self, row: _Row, found: Mapping[int, Sequence[Place]]) -> _Hit | None:
        seconds = [place for phrase in row.second for place in found.get(phrase, ())]
        if not seconds:
            return None
        pairs = [
            (one, other)
            for phrase in row.first
            for one in found.get(phrase, ())
            for other in seconds
            if one.end <= other.start or other.end <= one.start
        ]
        if not pairs:
            return None
        characters, best = max(
            [(len(one.form) + len(other.form), (one, other)) for one, other in pairs],
            key=itemgetter(0),
        )
        return _Hit((_TWO, characters), row.topic, best)

    def _single(self, row: _Row, found: Mapping[int, Sequence[Place]]) -> _Hit | None:
        if not row.wildcard:
            return None
        places = [
            place
            for phrase in row.first + row.second
            for place in found.get(phrase, ())
            # Without spaces, a part of a longer word is another word: 茶 in 茶碗.
            if self.language.spaced or not place.inside
        ]
        if not places:
            return None
        best = max(places, key=_length)
        return _Hit((_WILDCARD, _length(best)), row.topic, (best,))


def build_index(language: Language, rows: Iterable[KeywordRow]) -> KeywordIndex:
    """Return the index of these rows; ValueError where a keyword has no letters or digits."""
    numbers: dict[str, int] = {}

    def numbered(row: KeywordRow, phrases: Iterable[str]) -> tuple[int, ...]:
        units = [_units(language, row, phrase) for phrase in phrases if phrase != ANYTHING]
        return tuple({numbers.setdefault(unit, len(numbers)): None for unit in units})

    known = [
        _Row(
            row.topic,
            numbered(row, row.first),
            numbered(row, row.second),
            ANYTHING in row.first or ANYTHING in row.second,
        )
        for row in rows
    ]
    usage = Counter(phrase for row in known for phrase in row.first + row.second)
    driven: dict[int, list[_Row]] = {}
    for row in known:
        for phrase in dict.fromkeys(row.drivers(usage)):
            driven.setdefault(phrase, []).append(row)
    forms = _all_forms(language, numbers)
    return KeywordIndex(
        language,
        build_finder(language, forms),
        forms,
        {phrase: tuple(rows) for phrase, rows in driven.items()},
    )


def _units(language: Language, row: KeywordRow, phrase: str) -> str:
    words = [token.text for token in language.tokens(phrase)]
    if not words:
        raise ValueError(f"Keyword {phrase!r} of topic {row.topic} has no letters or digits.")
    return (" " if language.spaced else "").join(words)


def _all_forms(language: Language, numbers: Mapping[str, int]) -> dict[str, tuple[int, ...]]:
    """Return every spelling: exact forms, and forms without accents where no exact one is."""
    exact: dict[str, tuple[int, ...]] = {}
    for phrase, number in numbers.items():
        for form in _forms(language, phrase):
            exact[form] = (*exact.get(form, ()), number)
    folded: dict[str, tuple[int, ...]] = {}
    for form, phrases in exact.items():
        plain = language.fold(form)
        if plain not in exact and len(plain) >= SHORTEST_FOLDED:
            folded[plain] = tuple({**dict.fromkeys(folded.get(plain, ()) + phrases)})
    return exact | folded


def _forms(language: Language, phrase: str) -> Iterable[str]:
    if not language.spaced:
        return language.inflections(phrase) | {phrase}
    *others, last = phrase.split(" ")
    endings = language.inflections(last) | {last}
    beginnings = [sorted(language.inflections(word) | {word}) for word in others]
    count = len(endings)
    for some in beginnings:
        count *= len(some)
    if count > MAX_FORMS:
        beginnings = [[word] for word in others]
    return [" ".join(words) for words in product(*beginnings, sorted(endings))]


def _length(place: Place) -> int:
    return len(place.form)


def _reach(hits: Iterable[_Hit]) -> list[int]:
    """Return, for each start, where the longest matched keyword from there or before ends."""
    ends: dict[int, int] = {}
    for hit in hits:
        for place in hit.places:
            ends[place.start] = max(ends.get(place.start, 0), place.end)
    reach, longest = [], 0
    for start in range(max(ends, default=-1) + 1):
        longest = max(longest, ends.get(start, 0))
        reach.append(longest)
    return reach


def _is_covered(hit: _Hit, reach: Sequence[int]) -> bool:
    """Say whether all words of a match lie inside one longer keyword of another match."""
    start = min([place.start for place in hit.places])
    end = max([place.end for place in hit.places])
    return (
        reach[start] > end
        or (start > 0 and reach[start - 1] >= end)
        or (len(hit.places) > 1 and reach[start] == end)
    )


def _words(
    hit: _Hit, sentence: str, tokens: Sequence[Token], numbers: Mapping[int, int] | range
) -> tuple[str, ...]:
    return tuple(
        [
            sentence[tokens[numbers[place.start]].start : tokens[numbers[place.end] - 1].end]
            for place in hit.places
        ]
    )


def _token_numbers(tokens: Sequence[Token]) -> Mapping[int, int] | range:
    """Return which token begins at a character of the joined tokens."""
    starts = [0, *accumulate([len(token.text) for token in tokens])]
    if starts[-1] == len(tokens):
        return range(len(tokens) + 1)
    return {start: number for number, start in enumerate(starts)}
