"""The words triggers know, and which of them a wrongly spelt word may stand for."""

from collections import defaultdict
from collections.abc import Iterable, Iterator

from languages.language import Language

SHORTEST_SPELT = 3
LONGEST_SPELT = 24
_SHORTEST_FOLDED = 3
_SHORTEST_ALONE = 4


class Vocabulary:
    """The words that triggers know; accents match exactly first, then folded."""

    __slots__ = ("_deletions", "_folded", "_language", "_twins", "words")

    def __init__(self, language: Language, words: Iterable[str]) -> None:
        self._language = language
        self.words = frozenset(words)
        self._folded = {language.fold(word): word for word in sorted(self.words)}
        self._twins = self._told_apart_by_accents()
        # Made with the rest, not in the turn that first needs it: that one person would wait.
        self._deletions = self._without_a_letter()

    def known(self, word: str) -> str:
        """Return the word triggers use for this one ("perche" -> "perché"), or the word itself."""
        # Accents tell short words apart: "tè" is not "te".
        if word in self.words or len(word) < _SHORTEST_FOLDED:
            return word
        return self._folded.get(word if word.isascii() else self._language.fold(word), word)

    def has_twin(self, word: str) -> bool:
        """Say whether a word can be another one whose accents were lost."""
        return word in self._twins

    def twins(self, word: str) -> tuple[str, ...]:
        """Return the other words that differ in accents only: "è" for "e"."""
        folded = word if word.isascii() else self._language.fold(word)
        return tuple([twin for twin in self._twins.get(folded, ()) if twin != word])

    def _told_apart_by_accents(self) -> dict[str, tuple[str, ...]]:
        found: defaultdict[str, set[str]] = defaultdict(set)
        for word in self.words:
            if not word.isascii():
                folded = self._language.fold(word)
                found[folded].update({word, folded} if folded in self.words else {word})
        return {key: tuple(sorted(words)) for key, words in found.items()}

    def spelt(self, word: str) -> tuple[str, ...]:
        """Return the words one letter away: wrong, missing, too much, or two that changed places.

        Accents do not count. Empty for very short and very long words.
        """
        if not SHORTEST_SPELT <= len(word) <= LONGEST_SPELT:
            return ()
        index = self._deletions
        folded = word if word.isascii() else self._language.fold(word)
        near: dict[str, None] = dict.fromkeys(index.get(folded, ()))
        for place in range(len(folded)):
            shorter = folded[:place] + folded[place + 1 :]
            if shorter in index:
                near.update(dict.fromkeys(index[shorter]))
        return tuple([each for each in near if self._one_away(folded, each)])

    def _one_away(self, folded: str, word: str) -> bool:
        other = word if word.isascii() else self._language.fold(word)
        return len(word) >= SHORTEST_SPELT and one_edit_apart(folded, other)

    def halves(self, word: str) -> Iterator[tuple[str, str]]:
        """Yield the two words a lost blank may have joined; one of them may be unknown."""
        if len(word) > LONGEST_SPELT:
            return
        for place in range(1, len(word)):
            left, right = word[:place], word[place:]
            left_known, right_known = left in self.words, right in self.words
            if (left_known and right_known) or (
                (left_known and place >= _SHORTEST_ALONE and len(right) >= SHORTEST_SPELT)
                or (right_known and len(right) >= _SHORTEST_ALONE and place >= SHORTEST_SPELT)
            ):
                yield left, right

    def _without_a_letter(self) -> dict[str, tuple[str, ...]]:
        """Return each word and each word without one letter, with the words it comes from."""
        found: defaultdict[str, set[str]] = defaultdict(set)
        for folded, word in self._folded.items():
            if SHORTEST_SPELT <= len(folded) <= LONGEST_SPELT and not folded.isdecimal():
                found[folded].add(word)
                for place in range(len(folded)):
                    found[folded[:place] + folded[place + 1 :]].add(word)
        return {key: tuple(sorted(words)) for key, words in found.items()}


def one_edit_apart(one: str, two: str) -> bool:
    """Say whether one letter is wrong, missing or too much, or two neighbours changed places."""
    if abs(len(one) - len(two)) > 1:
        return False
    short, long = sorted((one, two), key=len)
    start = 0
    while start < len(short) and short[start] == long[start]:
        start += 1
    if len(short) < len(long):
        return short[start:] == long[start + 1 :]
    swapped = short[start + 1 : start + 2] + short[start : start + 1]
    return short[start + 1 :] == long[start + 1 :] or (swapped + short[start + 2 :] == long[start:])
