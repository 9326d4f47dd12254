"""Italian numbers, written in one word ("duemilatrecentoquarantuno") or apart."""

from functools import lru_cache

from languages.spoken.shape import Units, digits_value, numbered
from languages.tokens import without_accents

_SMALL = {"un": 1, "una": 1} | numbered(
    "zero uno due tre quattro cinque sei sette otto nove dieci undici dodici tredici quattordici "
    "quindici sedici diciassette diciotto diciannove"
)
_TENS = numbered("venti trenta quaranta cinquanta sessanta settanta ottanta novanta", 20, 10)
_ONES = {word: value for word, value in _SMALL.items() if 0 < value < 10 and word != "una"}
_MOST_WORDS = 8
_LONGEST = 60


def _below_hundred() -> dict[str, int]:
    """Return every number up to 99 as it is written, without accents."""
    found = _SMALL | _TENS
    for ten, value in _TENS.items():
        for one, more in _ONES.items():
            found[ten + one] = value + more
            if one[0] in "uo":
                found[ten[:-1] + one] = value + more
    return found


_BELOW_HUNDRED = _below_hundred()
_ACCENTED = {ten + "tré" for ten in _TENS}
#: The number words a trigger lists; all others are made of them.
LISTED_NUMBERS = frozenset(_BELOW_HUNDRED.keys() | _ACCENTED | {"cento", "mille"})


def folded(units: Units) -> Units:
    """Return units without accents: ventitré is ventitre."""
    return tuple(unit if unit.isascii() else without_accents(unit) for unit in units)


def number_at(units: Units, place: int) -> tuple[int, int] | None:
    """Return the longest number at a place of folded units, and where it ends."""
    if units[place].isdecimal():
        return _digits_at(units, place)
    for end in range(min(len(units), place + _MOST_WORDS), place, -1):
        value = _written(_joined(units[place:end]))
        if value is not None:
            return value, end
    return None


def is_number(unit: str) -> bool:
    """Say whether a unit is a number by itself."""
    return number_at(folded((unit,)), 0) is not None


def _digits_at(units: Units, place: int) -> tuple[int, int] | None:
    end = place + 1
    while end < len(units) and digits_value(units[place : end + 1]) is not None:
        end += 1
    value = digits_value(units[place:end])
    thousands = units[end : end + 1] == ("mila",) and value is not None and 1 < value < 1_000
    if value is None:
        return None
    return (value * 1_000, end + 1) if thousands else (value, end)


def _joined(units: Units) -> str:
    """Join the words of a number: "cento e uno" is centouno; "" where they cannot be one."""
    text = ""
    for place, unit in enumerate(units):
        if unit == "e":
            inside = 0 < place < len(units) - 1
            if not inside or not text.endswith(("cento", "mille", "mila")):
                return ""
        elif unit.isdecimal():
            return ""
        else:
            text += unit
    return text if len(text) <= _LONGEST and units[-1] != "e" else ""


@lru_cache(maxsize=4_096)
def _written(text: str) -> int | None:
    """Return a number below a million, written in one word."""
    before, found, after = text.partition("mila")
    if found:
        thousands = _below_thousand(before)
        rest = _below_thousand(after) if after else 0
        return None if not thousands or thousands == 1 or rest is None else thousands * 1_000 + rest
    if text.startswith("mille"):
        rest = _below_thousand(text[5:]) if len(text) > 5 else 0
        return None if rest is None else 1_000 + rest
    return _below_thousand(text)


def _below_thousand(text: str) -> int | None:
    before, found, after = text.partition("cent")
    if not found:
        return _BELOW_HUNDRED.get(text)
    hundreds = _ONES.get(before, 0) if before else 1
    if not hundreds or (before and hundreds == 1):
        return None
    rest = _BELOW_HUNDRED.get(after[1:] if after.startswith("o") else after, 0)
    if after == "o":
        return hundreds * 100
    full, elided = after.startswith("o"), after[:1] in ("o", "u")
    if full and rest:
        return hundreds * 100 + rest
    # "centotto" and "centottanta": one o stands for two.
    rest = _BELOW_HUNDRED.get(after, 0) if elided else 0
    return hundreds * 100 + rest if rest else None
