"""Find topics by a name in any language, their key or a keyword; accents and capitals forgiven."""

import unicodedata
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import NamedTuple

from authoring.by_draft import ByDraft
from authoring.topic_page.shape import Shape
from dialogue.garbage import collected_later
from dialogue.models import KeywordSet, Topic, TopicName

MOST_HITS = 50
LONGEST = 100
_ANY = frozenset(("*", "^", ""))
_NAME, _KEYWORD = 0, 1
_HIRAGANA = {place: place - 0x60 for place in range(ord("ァ"), ord("ヶ") + 1)}


class Word(NamedTuple):
    """One text that a topic is found by; `folded` is what is compared, `shown` what is told."""

    folded: str
    topic: int
    kind: int
    shown: str


@dataclass(frozen=True, slots=True)
class Hit:
    """A topic that was found, and the word that led to it."""

    number: int
    word: str


def fold(text: str) -> str:
    """Return the text without capitals, widths and Latin accents; katakana as hiragana."""
    if text.isascii():
        return " ".join(text.lower().split())
    apart = unicodedata.normalize("NFKD", text.casefold())
    plain = "".join(letter for letter in apart if not "\u0300" <= letter <= "\u036f")
    joined = unicodedata.normalize("NFC", plain)
    return " ".join(joined.translate(_HIRAGANA).split())


def search(text: str, among: Iterable[Word] | None = None) -> tuple[list[Hit], int]:
    """Return the best hits, at most MOST_HITS, and how many there are; one query when warm."""
    needle = fold(text[:LONGEST].replace("\0", ""))
    if not needle:
        return [], 0
    best: dict[int, tuple[tuple[int, int, str], Word]] = {}
    for word in _WORDS() if among is None else among:
        if needle in word.folded:
            rank = (_rank(needle, word), len(word.folded), word.folded)
            if word.topic not in best or rank < best[word.topic][0]:
                best[word.topic] = (rank, word)
    found = sorted(best.values(), key=lambda one: one[0])
    hits = [Hit(word.topic, word.shown) for _rank_, word in found]
    return hits[:MOST_HITS], len(hits)


def _rank(needle: str, word: Word) -> int:
    if word.folded == needle:
        return word.kind
    if word.folded.startswith(needle):
        return 2 + word.kind
    return (4 if f" {needle}" in word.folded else 6) + word.kind


@collected_later()
def _words() -> tuple[Word, ...]:
    return tuple(Word(fold(shown), number, kind, shown) for shown, number, kind in _texts())


def _texts() -> Iterator[tuple[str, int, int]]:
    for key, number in Topic.objects.order_by().values_list("key", "pk"):
        yield key, number, _NAME
    names = TopicName.objects.values_list("name", "fields", "topic_id")
    for name, fields, number in names:
        yield name, number, _NAME
        for text in fields.values() if isinstance(fields, dict) else ():
            if isinstance(text, str) and len(text) > 1:
                yield text, number, _NAME
    for first, second, number in KeywordSet.objects.values_list("first", "second", "topic_id"):
        for text in (*first.split("|"), *second.split("|")):
            if text.strip() not in _ANY:
                yield text.strip(), number, _KEYWORD


_WORDS: ByDraft[tuple[Word, ...]] = ByDraft(_words)


def paths(shape: Shape, numbers: Iterable[int]) -> set[int]:
    """Return these topics with all above them: whose names a list with breadcrumbs needs."""
    return {place for number in numbers for place in (number, *shape.above(number))}
