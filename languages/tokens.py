"""Sentences into words: one regular expression, with a map back to the person's own spelling.

Case, width, punctuation and spacing never matter. An apostrophe ends a word ("l'arte" is l, arte);
digits and letters split ("7pm" is 7, pm).
"""

import re
from unicodedata import combining, is_normalized, normalize

from languages.language import Token

_MARKS = "\u0300-\u036f"
#: U+02B0..U+02FF are "letters" that people type as apostrophes and primes.
_LETTER = r"[^\W\d_\u02b0-\u02ff]"

#: English, Italian: runs of letters, runs of digits.
WORDS = re.compile(rf"{_LETTER}+(?:[{_MARKS}]+{_LETTER}*)*|\d+")

_KANA = "\u3041-\u3096\u309d-\u309f\u30a1-\u30fa\u30fc-\u30ff\u31f0-\u31ff"
_KANJI = "\u3005-\u3007\u3400-\u9fff\uf900-\ufaff\U00020000-\U0003ffff"
_LATIN = rf"[^\W\d_\u02b0-\u02ff{_KANA}{_KANJI}]"
#: Japanese: each kanji and kana alone (the matcher finds runs), Latin words and digits whole.
#: The middle dot of foreign names is no letter: ラ・スペツィア is ラスペツィア.
CHARACTERS = re.compile(rf"[{_KANA}{_KANJI}]|{_LATIN}+(?:[{_MARKS}]+{_LATIN}*)*|\d+")

_IGNORED = "\u00ad\u200b-\u200f\u2060\ufe00-\ufe0f\ufeff"
_HAS_IGNORED = re.compile(f"[{_IGNORED}]")
#: A character with what is written on it; 30 is the bound of Unicode's stream-safe text, and
#: keeps the (quadratic) ordering of marks by `normalize` harmless.
_CLUSTER = re.compile(rf"(?s:.)[{_MARKS}\u3099\u309a\uff9e\uff9f{_IGNORED}]{{0,30}}")
#: What NFKC changes one for one in ordinary sentences, so that these keep the quick way.
_SAME_WIDTH = {code: code - 0xFEE0 for code in range(0xFF01, 0xFF5F)} | str.maketrans(
    {"\u3000": " ", "…": ".", "\u00a0": " "}
)
_LONGEST_QUICK = 2_000

_LETTERS_WITHOUT_ACCENT = str.maketrans(
    {"ø": "o", "æ": "ae", "œ": "oe", "ł": "l", "đ": "d", "ð": "d", "þ": "th", "ı": "i"}
)

#: ァ..ヶ to ぁ..ゖ, small counters ゕゖ to か, け: second-chance look-ups only.
_HIRAGANA = {katakana: katakana - 0x60 for katakana in range(0x30A1, 0x30F7)} | str.maketrans(
    {"ヵ": "か", "ヶ": "け", "ヽ": "ゝ", "ヾ": "ゞ"}
)


def find_tokens(sentence: str, words: re.Pattern[str]) -> tuple[Token, ...]:
    """Return the words `words` finds in the normalised sentence, with offsets in the original."""
    if sentence.isascii():
        return _as_they_stand(sentence.lower(), words)
    wide = sentence.translate(_SAME_WIDTH)
    text = wide.casefold()
    if len(text) == len(wide) and _is_plain(wide):
        return _as_they_stand(text, words)
    return _through_clusters(sentence, words)


def _as_they_stand(text: str, words: re.Pattern[str]) -> tuple[Token, ...]:
    return tuple(
        [Token(found.group(), found.start(), found.end()) for found in words.finditer(text)]
    )


def _is_plain(sentence: str) -> bool:
    return (
        len(sentence) <= _LONGEST_QUICK
        and is_normalized("NFKC", sentence)
        and not _HAS_IGNORED.search(sentence)
    )


def _through_clusters(sentence: str, words: re.Pattern[str]) -> tuple[Token, ...]:
    pieces: list[str] = []
    starts: list[int] = []
    ends: list[int] = []
    for cluster in _CLUSTER.finditer(sentence):
        piece = normalise(cluster.group())
        pieces.append(piece)
        starts += [cluster.start()] * len(piece)
        ends += [cluster.end()] * len(piece)
    return tuple(
        [
            Token(found.group(), starts[found.start()], ends[found.end() - 1])
            for found in words.finditer("".join(pieces))
        ]
    )


def normalise(text: str) -> str:
    """Return text as tokens are written: NFKC, casefold, without invisible characters."""
    visible = _HAS_IGNORED.sub("", text)
    return normalize("NFKC", normalize("NFKC", visible).casefold())


def without_accents(text: str) -> str:
    """Return casefolded text without accents: "Però" becomes "pero"."""
    text = text.casefold()
    if text.isascii():
        return text
    letters = (letter for letter in normalize("NFKD", text) if not combining(letter))
    return "".join(letters).translate(_LETTERS_WITHOUT_ACCENT)


def as_hiragana(text: str) -> str:
    """Return text with katakana written as hiragana, one character for one."""
    return text.translate(_HIRAGANA)
