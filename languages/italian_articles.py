"""Which Italian article a word takes by its sound, and how prepositions melt with it."""

import re
from enum import Enum

from languages.tokens import without_accents


class Onset(Enum):
    """How a word begins, as far as articles care."""

    PLAIN = "il, un, la, una"
    HARD = "lo, uno, la, una"
    VOWEL = "l', un, un'"


#: (feminine, plural) -> article by onset.
ARTICLES = {
    (False, False): {Onset.PLAIN: "il", Onset.HARD: "lo", Onset.VOWEL: "l'"},
    (False, True): {Onset.PLAIN: "i", Onset.HARD: "gli", Onset.VOWEL: "gli"},
    (True, False): {Onset.PLAIN: "la", Onset.HARD: "la", Onset.VOWEL: "l'"},
    (True, True): {Onset.PLAIN: "le", Onset.HARD: "le", Onset.VOWEL: "le"},
}

_FIRST = re.compile(r"[^A-Za-zÀ-ɏ0-9]*([A-Za-zÀ-ɏ]+|[0-9][0-9.]*)")
#: s + consonant (lo swing), z, x, and clusters Italian ears find hard: ps, pn, pt, gn, ts …
_HARD = re.compile(r"s[bcdfghjklmnpqrtvwxz]|z|x|ps|pn|pt|gn|ts|tz|cz|cn|ct|ft|mn|bd|tm|chth|phth")
#: Semivowels: lo iodio, lo yogurt, la iena.
_GLIDE = re.compile(r"[iy][aeou]|yi")
_VOWEL = re.compile(r"[aeiou]|h|y(?![aeiou])")
_LETTERS_WITH_VOWEL = frozenset("AEFHILMNORSX")


def onset_of(name: str) -> Onset:
    """Return how a name begins: zaino is HARD, hotel VOWEL, whisky PLAIN, dei HARD (gli dei)."""
    found = _FIRST.match(name)
    if not found:
        return Onset.PLAIN
    first = found.group(1)
    if first[0].isdigit():
        return Onset.VOWEL if _number_has_vowel(first) else Onset.PLAIN
    if len(first) > 1 and first.isupper() and not re.search("[AEIOU]", first):
        return Onset.VOWEL if first[0] in _LETTERS_WITH_VOWEL else Onset.PLAIN
    return _word_onset(without_accents(first))


def _number_has_vowel(number: str) -> bool:
    whole = number.replace(".", "")
    # Uno, undici; otto, ottanta, ottocento.
    return whole.startswith("8") or whole in ("1", "11") or bool(re.fullmatch(r"11\d{3}", whole))


def _word_onset(word: str) -> Onset:
    # "dei" is the one plain word that says "gli": gli dei.
    if word == "dei" or _HARD.match(word) or _GLIDE.match(word):
        return Onset.HARD
    return Onset.VOWEL if _VOWEL.match(word) else Onset.PLAIN


_MELTED = {
    "di": {"il": "del", "lo": "dello", "l'": "dell'", "la": "della"},
    "a": {"il": "al", "lo": "allo", "l'": "all'", "la": "alla"},
    "da": {"il": "dal", "lo": "dallo", "l'": "dall'", "la": "dalla"},
    "in": {"il": "nel", "lo": "nello", "l'": "nell'", "la": "nella"},
    "su": {"il": "sul", "lo": "sullo", "l'": "sull'", "la": "sulla"},
    "con": {"il": "con il", "lo": "con lo", "l'": "con l'", "la": "con la"},
}
_MELTED_PLURAL = {"di": "de", "a": "a", "da": "da", "in": "ne", "su": "su"}


def articulated(preposition: str, article: str) -> str:
    """Return the preposition with the article: di + gli is "degli", con + l' is "con l'"."""
    if article in _MELTED[preposition]:
        return _MELTED[preposition][article]
    if preposition == "con":
        return f"con {article}"
    # de + i = dei, de + gli = degli, de + le = delle.
    doubled = "l" if article == "le" else ""
    return f"{_MELTED_PLURAL[preposition]}{doubled}{article}"


def unarticulated(preposition: str, name: str) -> str:
    """Return the preposition before a name without article: di Roma, ad Ancona."""
    doubled = preposition == "a" and without_accents(name).startswith("a")
    return f"{'ad' if doubled else preposition} {name}"


def indefinite(onset: Onset, *, feminine: bool) -> str:
    """Return un, uno, una or un' as the onset asks."""
    if feminine:
        return "un'" if onset is Onset.VOWEL else "una"
    return "uno" if onset is Onset.HARD else "un"


def joined(article: str, name: str) -> str:
    """Return article and name as one writes them: "l'acqua", "il tè"."""
    return f"{article}{name}" if article.endswith("'") else f"{article} {name}"
