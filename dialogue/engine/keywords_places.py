"""Where keywords stand in a sentence: at whole words, or in Japanese at runs of characters."""

import re
from bisect import bisect_left
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import accumulate
from typing import NamedTuple

from languages.language import Language, Token

_KATAKANA = re.compile(r"[ァ-ヺー-ヿㇰ-ㇿ]+")
_PAUSE = re.compile(r"[、。，．！？!?,.…]")


class Place(NamedTuple):
    """One keyword at one place; `inside` says that a longer keyword covers it."""

    start: int  # in words, or in characters where words are not separated
    end: int
    form: str
    inside: bool = False


@dataclass(frozen=True, slots=True)
class Finder:
    """Finds the known forms; `lengths` says, by its beginning, how long a form may be."""

    language: Language
    forms: Collection[str]
    lengths: Mapping[str, tuple[int, ...]]

    def places(self, sentence: str, tokens: Sequence[Token]) -> list[Place]:
        """Return all places from left to right, at each start the longest first."""
        words = [token.text for token in tokens]
        if self.language.spaced:
            return _marked(self._word_places(words))
        found = self._run_places(words, tokens)
        pauses = _pauses(sentence, tokens)
        if pauses:
            found = (one for one in found if not any(one[0] < at < one[1] for at in pauses))
        return _marked(found)

    def _word_places(self, words: Sequence[str]) -> Iterable[tuple[int, int, str]]:
        lengths = self.lengths
        for start, word in enumerate(words):
            if word not in lengths:
                if word.isascii():
                    continue
                word = self.language.fold(word)
            for length in lengths.get(word, ()):
                end = start + length
                form = word if length == 1 else " ".join(words[start:end])
                if form not in self.forms and not form.isascii():
                    form = self.language.fold(form)
                if form in self.forms and end <= len(words):
                    yield start, end, form

    def _run_places(
        self, words: Sequence[str], tokens: Sequence[Token]
    ) -> Iterable[tuple[int, int, str]]:
        text = "".join(words)
        starts = [0, *accumulate(map(len, words))]
        boundaries = set(starts)
        runs = _katakana_runs(text, starts, tokens)
        within_run = {at for start, end in runs.items() for at in range(start + 1, end)}
        boundaries -= within_run
        lengths, forms = self.lengths, self.forms
        for start in starts:
            if start in within_run:
                continue
            missed = True
            for length in lengths.get(text[start : start + 2], ()):
                form = text[start : start + length]
                if form in forms and start + length in boundaries:
                    missed = False
                    yield start, start + length, form
            if text[start : start + 1] in forms and start + 1 in boundaries:
                yield start, start + 1, text[start]
            elif missed and start in runs:
                yield from self._second_chance(text, start, runs[start])

    def _second_chance(self, text: str, start: int, end: int) -> Iterable[tuple[int, int, str]]:
        """Find a whole run of katakana that authors wrote in hiragana: ネコ for ねこ."""
        form = self.language.fold(text[start:end])
        if form in self.forms:
            yield start, end, form


def build_finder(language: Language, forms: Collection[str]) -> Finder:
    """Return a finder of these forms: words joined with spaces, or in Japanese joined directly."""
    lengths: dict[str, set[int]] = {}
    for form in forms:
        if language.spaced:
            words = form.split(" ")
            lengths.setdefault(words[0], set()).add(len(words))
        elif len(form) > 1:
            # Two characters tell keywords apart so well that hardly any other is looked up.
            lengths.setdefault(form[:2], set()).add(len(form))
    longest_first = {
        beginning: tuple(sorted(some, reverse=True)) for beginning, some in lengths.items()
    }
    return Finder(language, forms, longest_first)


def _katakana_runs(text: str, starts: Sequence[int], tokens: Sequence[Token]) -> dict[int, int]:
    """Return where katakana words begin and end: パンダ is one, トム・ハンクス are two."""
    runs: dict[int, int] = {}
    for found in _KATAKANA.finditer(text):
        begin = found.start()
        first = bisect_left(starts, begin)  # each kana is a token of its own
        for at in range(1, found.end() - found.start()):
            if tokens[first + at].start != tokens[first + at - 1].end:
                runs[begin] = found.start() + at
                begin = found.start() + at
        runs[begin] = found.end()
    return runs


def _pauses(sentence: str, tokens: Sequence[Token]) -> list[int]:
    """Return where, in the joined tokens, a sign stands: たいくつ is not in 「あんた、いくつ」."""
    signs = [found.start() for found in _PAUSE.finditer(sentence)]
    if not signs:
        return []
    joined = [0, *accumulate([len(token.text) for token in tokens])]
    starts = [token.start for token in tokens]
    return [joined[bisect_left(starts, sign)] for sign in signs]


def _marked(places: Iterable[tuple[int, int, str]]) -> list[Place]:
    marked: list[Place] = []
    reach = 0  # the end of the longest place so far; longer ones at the same start come first
    for start, end, form in places:
        marked.append(Place(start, end, form, inside=end <= reach))
        reach = max(reach, end)
    return marked
