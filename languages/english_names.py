"""English names: `$hasName` is what fits after "I like"; `.one` is "a dog", "an owl"."""

import re
from collections.abc import Mapping

from languages.language import NameForms
from languages.name_fields import COUNTED, PLURAL, check_fields, pick
from languages.tokens import without_accents

FORMS = frozenset({"bare", "one"})
FIELDS = frozenset({"name", "n", "bare", "one", "count"})

_FIRST = re.compile(r"[^A-Za-zÀ-ɏ0-9]*([A-Za-zÀ-ɏ]+|[0-9][0-9,.]*)(.?)")
_LETTERS_WITH_AN = frozenset("AEFHILMNORSX")
_DETERMINED = re.compile(
    r"(?:a|an|the|some|my|your|his|her|its|our|their|this|that|these|those)\b", re.IGNORECASE
)
#: Spelt with a consonant, said with a vowel. "hono": honour, honorary; not honey.
_SILENT = re.compile(r"(?:hour(?!i)|honest|hono|heir|hors\b)")
#: Spelt with a vowel, said "yoo", "w" or "y".
_CONSONANT_SOUND = re.compile(
    r"""eu | ewe | once\b | ones?\b | oneness | one(?:self|time) | oui
    | u (?: bi[^t] | fo | gand | i[gs] | k | lysses | r[aeiou] | s[ae] | sua | sur
          | t(?:e|i|op|ah) | v )
    | u nanim | uni (?: [cfoqstv] | l(?!l) | dir | $ ) | uni\b
    """,
    re.VERBOSE,
)


def name_forms(fields: Mapping[str, str]) -> NameForms:
    """Return the forms of an English name: {name: dogs, n: p, bare: dog} gives "a dog" as `.one`.

    `.one` is absent for plurals without `bare` and for `count: no` (tennis, London, tea).
    """
    check_fields(fields, FIELDS)
    plural = pick(fields, "n", PLURAL, "s")
    counted = pick(fields, "count", COUNTED, "yes")
    bare = fields.get("bare", fields["name"])
    forms = {"": fields["name"], "bare": bare}
    if "one" in fields:
        forms["one"] = fields["one"]
    elif counted and not (plural and "bare" not in fields) and not _DETERMINED.match(bare):
        forms["one"] = with_article(bare)
    return NameForms(forms, plural=plural)


def with_article(words: str) -> str:
    """Return the words with "a" or "an" as they sound: an hour, a university, an X-ray."""
    return f"{'an' if sounds_like_a_vowel(words) else 'a'} {words}"


def sounds_like_a_vowel(words: str) -> bool:
    """Say whether speech starts with a vowel: hour, owl, MP, 8-year-old; not ukulele, one-way."""
    found = _FIRST.match(words)
    if not found:
        return False
    first, following = found.groups()
    if first[0].isdigit():
        return _number_sounds_like_a_vowel(first)
    if _is_spelt_out(first, following):
        return first[0].upper() in _LETTERS_WITH_AN
    return _word_sounds_like_a_vowel(first)


def _word_sounds_like_a_vowel(first: str) -> bool:
    if first.startswith("U") and first.isupper():
        return False  # UNESCO, UNICEF: said as words that begin with "yoo".
    word = first.lower()
    if without_accents(word)[0] in "aeiou":
        return not _CONSONANT_SOUND.match(word)
    return bool(_SILENT.match(word))


def _number_sounds_like_a_vowel(number: str) -> bool:
    whole = number.split(".")[0].replace(",", "")
    # Eight, eighty, eight hundred; eleven and eighteen, also as thousands or millions.
    return whole.startswith("8") or (whole[:2] in ("11", "18") and len(whole) % 3 == 2)


def _is_spelt_out(word: str, following: str) -> bool:
    """Say whether the letters are said one by one: MP, X-ray, e-mail; not NATO."""
    if len(word) == 1:
        return word != "a" and (word.isupper() or following == "-")
    if not word.isupper():
        return False
    return len(word) <= 3 or not re.search("[AEIOU]", word)
