"""Numbers, lengths, clock times and days in English."""

import re

from languages.spoken.items import Clocks, Lengths, clock_of, length_of, part_of_day, shape_of
from languages.spoken.shape import (
    WEEKDAYS,
    Spoken,
    SpokenKind,
    Units,
    before,
    clock,
    day_of_year,
    days_ahead,
    digits_value,
    in_part_of_day,
    listed,
    numbered,
    words,
    written_day,
)

_SMALL = numbered(
    "zero one two three four five six seven eight nine ten eleven twelve thirteen fourteen "
    "fifteen sixteen seventeen eighteen nineteen"
)
_TENS = numbered("twenty thirty forty fifty sixty seventy eighty ninety", 20, 10)
_ORDINALS = {"thirtieth": 30} | numbered(
    "first second third fourth fifth sixth seventh eighth ninth tenth eleventh twelfth thirteenth "
    "fourteenth fifteenth sixteenth seventeenth eighteenth nineteenth twentieth",
    1,
)
_MONTHS = numbered(
    "january february march april may june july august september october november december", 1
)
_LENGTH_NAMES = {
    word: letter
    for letter, text in {
        "S": "s sec secs second seconds",
        "M": "min mins minute minutes",
        "H": "h hr hrs hour hours",
        "D": "day days",
        "W": "week weeks",
    }.items()
    for word in text.split()
}


def _below_hundred(units: Units, place: int) -> tuple[int, int] | None:
    """Return a number up to 99 in words, or of any size in digits, and where it ends."""
    word = units[place] if place < len(units) else ""
    if word.isdecimal():
        end = place + 1
        while end < len(units) and digits_value(units[place : end + 1]) is not None:
            end += 1
        value = digits_value(units[place:end])
        return None if value is None else (value, end)
    if word in _TENS:
        one = _SMALL.get(units[place + 1], 0) if place + 1 < len(units) else 0
        return (_TENS[word] + one, place + 2) if 0 < one < 10 else (_TENS[word], place + 1)
    return (_SMALL[word], place + 1) if word in _SMALL else None


def _and_rest(
    units: Units, total: int, place: int, below: int, words_only: bool
) -> tuple[int, int]:
    """Add what follows a hundred or a thousand: "and five", "forty"."""
    start = place + 1 if units[place : place + 1] == ("and",) else place
    if words_only and start < len(units) and units[start].isdecimal():
        return total, place
    rest = _below_thousand(units, start) if below > 100 else _below_hundred(units, start)
    return (total + rest[0], rest[1]) if rest and 0 < rest[0] < below else (total, place)


def _times(units: Units, place: int, word: str) -> bool:
    return units[place : place + 1] == (word,)


def _below_thousand(units: Units, place: int) -> tuple[int, int] | None:
    first = (1, place + 1) if _times(units, place, "a") else _below_hundred(units, place)
    if first is None:
        return None
    value, end = first
    if _times(units, end, "hundred") and 0 < value < 100:
        return _and_rest(units, value * 100, end + 1, 100, True)
    return None if _times(units, place, "a") else first


def _number_at(units: Units, place: int) -> tuple[int, int] | None:
    """Return the longest number at a place and where it ends."""
    article = _times(units, place, "a") and _times(units, place + 1, "thousand")
    first = (1, place + 1) if article else _below_thousand(units, place)
    if first and _times(units, first[1], "thousand") and 0 < first[0] < 1_000:
        return _and_rest(units, first[0] * 1_000, first[1] + 1, 1_000, True)
    return first


def _number(units: Units) -> str | None:
    found = _number_at(units, 0)
    return str(found[0]) if found and found[1] == len(units) else None


_UNIT = r"(?P<unit>[SMHDW])\b"
_A = r"(?:an? )?"
_LENGTH_RULES: Lengths = [
    (re.compile(rf"# and a half {_UNIT}"), lambda n, u: (n[0] + 0.5) * u),
    (re.compile(rf"# {_UNIT} and a half\b"), lambda n, u: (n[0] + 0.5) * u),
    (re.compile(rf"# {_UNIT} and a quarter\b"), lambda n, u: (n[0] + 0.25) * u),
    (re.compile(rf"# quarters? of an? {_UNIT}"), lambda n, u: n[0] * u / 4),
    (re.compile(rf"# # {_UNIT}"), lambda n, u: (n[0] + n[1] / 10 ** len(str(n[1]))) * u),
    (re.compile(rf"# {_UNIT}"), lambda n, u: n[0] * u),
    (re.compile(rf"an? {_UNIT} and a half\b"), lambda n, u: 1.5 * u),
    (re.compile(rf"an? {_UNIT} and a quarter\b"), lambda n, u: 1.25 * u),
    (re.compile(rf"{_A}half (?:an? |of an? )?{_UNIT}"), lambda n, u: u / 2),
    (re.compile(rf"{_A}quarter (?:of )?(?:an? )?{_UNIT}"), lambda n, u: u / 4),
    (re.compile(rf"{_A}couple (?:of )?{_UNIT}"), lambda n, u: 2 * u),
    (re.compile(rf"{_A}dozen {_UNIT}"), lambda n, u: 12 * u),
    (re.compile(rf"an? {_UNIT}"), lambda n, u: u),
]
_JOINT = re.compile(" and | ")


def _length(units: Units) -> str | None:
    shape = shape_of(units, _number_at, _LENGTH_NAMES)
    return length_of(shape, _LENGTH_RULES, _JOINT)


_OPENERS = "at|about|around|by|for"
_PARTS_OF_DAY = {
    "am": "am|a m|in the morning|this morning|morning",
    "pm": "pm|p m|in the afternoon|this afternoon|afternoon",
    "evening": "in the evening|this evening|evening|tonight",
    "night": "at night",
}
_OPENING = re.compile(rf"^(?:(?:{_OPENERS}) )+")
_CLOCK_RULES: Clocks = [
    (re.compile("#(?: o clock)?(?: sharp)?"), lambda n: clock(n[0], 0)),
    (re.compile("# (?:oh? )?#"), lambda n: clock(n[0], n[1])),
    (re.compile("half (?:past |after )?#"), lambda n: clock(n[0], 30)),
    (re.compile("(?:a )?quarter (?:past|after) #"), lambda n: clock(n[0], 15)),
    (re.compile("(?:a )?quarter (?:to|before|of|till) #"), lambda n: before(n[0], 15)),
    (re.compile("# (?:minutes? )?(?:past|after) #"), lambda n: clock(n[1], n[0])),
    (re.compile("# (?:minutes? )?(?:to|before|till) #"), lambda n: before(n[1], n[0])),
    (re.compile("noon|midday"), lambda n: "1200"),
    (re.compile("midnight"), lambda n: "0000"),
]


def _spoken_time(units: Units) -> str | None:
    shape = shape_of(units, _number_at, {})
    text, part = part_of_day(_OPENING.sub("", shape.text), _PARTS_OF_DAY)
    time = clock_of(_OPENING.sub("", text), shape.numbers, _CLOCK_RULES)
    return in_part_of_day(time, part)


def _day_number(units: Units, place: int) -> tuple[int, int] | None:
    """Read cardinal and ordinal numbers: "25", "25th", "twenty-fifth", "first"."""
    word, after = units[place], units[place + 1] if place + 1 < len(units) else ""
    if word in _TENS and _ORDINALS.get(after, 10) < 10:
        return _TENS[word] + _ORDINALS[after], place + 2
    if word in _ORDINALS:
        return _ORDINALS[word], place + 1
    found = _below_hundred(units, place)
    if found and word.isdecimal() and after in ("st", "nd", "rd", "th"):
        return found[0], place + 2
    return found


_DAYS_AHEAD = {
    "today": 0,
    "tonight": 0,
    "tomorrow": 1,
    "the day after tomorrow": 2,
    "day after tomorrow": 2,
}
_WEEKDAY = re.compile(rf"(?:on |next |this |coming )*({'|'.join(WEEKDAYS)})")
_MONTH = "|".join(_MONTHS)
_MONTH_FIRST = re.compile(rf"(?:on )?({_MONTH}) (?:the )?#")
_DAY_FIRST = re.compile(rf"(?:on )?(?:the )?# (?:of )?({_MONTH})")

_WRITTEN = re.compile("(?:on )?# #")
_AHEAD = re.compile("in (?:#|a) (?:days?|(?P<weeks>weeks?))")


def _day(units: Units) -> str | None:
    shape = shape_of(units, _day_number, {})
    text, numbers = shape.text, shape.numbers
    weekday, month = _WEEKDAY.fullmatch(text), _MONTH_FIRST.fullmatch(text)
    month = month or _DAY_FIRST.fullmatch(text)
    if text in _DAYS_AHEAD:
        return days_ahead(_DAYS_AHEAD[text])
    if weekday:
        return weekday[1]
    if month:
        return day_of_year(_MONTHS[month[1]], numbers[0])
    if _WRITTEN.fullmatch(text) and all(unit.isdecimal() for unit in units[-2:]):
        return written_day(numbers[0], numbers[1])
    ahead = _AHEAD.fullmatch(text)
    number = numbers[0] if numbers else 1
    return days_ahead(number * (7 if ahead["weeks"] else 1)) if ahead else None


_NUMBER_WORDS = frozenset({*_SMALL, *_TENS, "hundred", "thousand", "and"})
_LENGTH_WORDS = words("a an half quarter quarters of couple dozen") | _LENGTH_NAMES.keys()
_CLOCK_WORDS = words(
    "a half quarter past after to before of till o oh clock sharp noon midday midnight minutes "
    "minute am pm p m in the morning afternoon evening night tonight this"
)
_PART_WORDS = words("this morning afternoon evening tonight")
_DAY_WORDS = words(
    "today tonight tomorrow the day after next this coming of st nd rd th days a week weeks"
)

ENGLISH = Spoken(
    kinds={
        "number": SpokenKind(_number, _NUMBER_WORDS, words("a")),
        "duration": SpokenKind(_length, _NUMBER_WORDS | _LENGTH_WORDS),
        "time": SpokenKind(
            _spoken_time,
            _CLOCK_WORDS | {*_SMALL, *_TENS},
            frozenset(_OPENERS.split("|")) | _PART_WORDS,
        ),
        "date": SpokenKind(
            _day,
            _DAY_WORDS | {*WEEKDAYS, *_MONTHS, *_ORDINALS, *_TENS, *_SMALL},
            words("on in"),
        ),
    },
    most_units=14,
    examples={
        "number": ("three", "20", "forty-two", "a hundred"),
        "duration": ("twenty minutes", "an hour and a half", "half an hour", "90 seconds"),
        "time": ("seven", "half past eight", "7:30 pm", "nine in the morning"),
        "date": ("tomorrow", "on Monday", "the 25th of December", "today"),
        "yes_no": ("yes", "no", "of course", "not really"),
    },
    leads=listed("it is|it s|that is|that s|i said|i mean|let s say|i d say"),
)
