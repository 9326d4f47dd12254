"""Makes of a sentence what people and speech recognisers make of it; None where it has no effect.

`kept` are words that must stay as they are: what is heard as a value is not the matcher's to mend.
"""

import re
import string
import unicodedata
from collections.abc import Sequence
from random import Random

_WORD = re.compile(r"[^\W\d_]+")
_PUNCTUATION = re.compile(r"[^\w\s'’%°./:]|(?<!\d)[./:]|[./:](?!\d)")
_LETTERS = {
    "en": string.ascii_lowercase,
    "it": "abcdefghilmnopqrstuvz",
    "ja": "のにはをがでとるたいしんか",
}
SHORTEST_WORD = 4
SHORTEST_UNSPACED = 6


def with_filler(
    sentence: str, chance: Random, before: Sequence[str], after: Sequence[str], gap: str
) -> str | None:
    """Return the sentence with words that mean nothing in front of it or, one in four, after it."""
    if after and (not before or chance.random() < 0.25):
        return sentence.rstrip(".!?。！？") + gap + after[chance.randrange(len(after))]
    if not before:
        return None
    return before[chance.randrange(len(before))] + gap + sentence


def with_typo(sentence: str, chance: Random, code: str, kept: Sequence[str] = ()) -> str | None:
    """Return it with one letter lost, doubled, changed or swapped in a word of four or more.

    In Japanese in a sentence of six characters or more.
    """
    if code == "ja":
        places = [
            place
            for place, letter in enumerate(sentence)
            if letter.isalpha() and not _inside(sentence, place, place + 1, kept)
        ]
        if len(sentence) < SHORTEST_UNSPACED or not places:
            return None
        place = places[chance.randrange(len(places))]
        other = _other(sentence[place], chance, code)
        return sentence[:place] + chance.sample(("", other), 1)[0] + sentence[place + 1 :]
    words = [
        found
        for found in _WORD.finditer(sentence)
        if len(found[0]) >= SHORTEST_WORD
        and not _inside(sentence, found.start(), found.end(), kept)
    ]
    if not words:
        return None
    found = words[chance.randrange(len(words))]
    return sentence[: found.start()] + _mistyped(found[0], chance, code) + sentence[found.end() :]


def _mistyped(word: str, chance: Random, code: str) -> str:
    while True:
        place = chance.randrange(len(word))
        before, letter, after = word[:place], word[place], word[place + 1 :]
        ways = (
            before + after,
            before + letter + word[place:],
            before + _other(letter, chance, code) + after,
            before + after[:1] + letter + after[1:],
        )
        typed = ways[chance.randrange(len(ways))]
        if typed != word:
            return typed


def _other(letter: str, chance: Random, code: str) -> str:
    letters = _LETTERS[code].replace(letter.lower(), "")
    return letters[chance.randrange(len(letters))]


def without_accents(sentence: str, code: str) -> str | None:
    """Return it as typed on a keyboard without accents; Japanese has none to lose."""
    if code == "ja":
        return None
    bare = "".join(
        letter
        for letter in unicodedata.normalize("NFD", sentence)
        if not unicodedata.combining(letter)
    )
    return bare if bare != unicodedata.normalize("NFC", sentence) else None


def without_a_space(
    sentence: str, chance: Random, code: str, kept: Sequence[str] = ()
) -> str | None:
    """Return it with two words run together; nothing to do in Japanese."""
    places = [
        found.start()
        for found in re.finditer(r"(?<=[^\W\d_]) (?=[^\W\d_])", sentence)
        if not _inside(sentence, found.start() - 1, found.end() + 1, kept)
    ]
    if code == "ja" or not places:
        return None
    place = places[chance.randrange(len(places))]
    return sentence[:place] + sentence[place + 1 :]


def as_recognised(sentence: str) -> str | None:
    """Return it as a speech recogniser writes: small letters, no punctuation but apostrophes."""
    heard = " ".join(_PUNCTUATION.sub(" ", sentence).lower().split())
    return heard if heard != sentence else None


def _inside(sentence: str, start: int, end: int, kept: Sequence[str]) -> bool:
    """Say whether a stretch of the sentence touches one of the kept words."""
    low = sentence.lower()
    for words in filter(None, map(str.lower, kept)):
        place = low.find(words)
        while place >= 0:
            if place < end and start < place + len(words):
                return True
            place = low.find(words, place + 1)
    return False
