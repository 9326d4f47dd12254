"""Words with their numbers read: ("ten", "past", "six") is the shape "# past #" with 10 and 6."""

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from languages.spoken.shape import DAY, HOUR, MINUTE, WEEK, Units

#: The letters of units of time in shapes, with their seconds.
SECONDS = {"S": 1, "M": MINUTE, "H": HOUR, "D": DAY, "W": WEEK}
_BELOW = {"W": DAY, "D": HOUR, "H": MINUTE, "M": 1}

#: Reads the longest number that begins at a place: its value and where it ends.
NumberReader = Callable[[Units, int], tuple[int, int] | None]
Lengths = Sequence[tuple[re.Pattern[str], Callable[[list[int], int], float]]]
Clocks = Sequence[tuple[re.Pattern[str], Callable[[list[int]], str | None]]]


@dataclass(frozen=True, slots=True)
class Shape:
    """Words with # for each number; `numbers` holds their values in order."""

    text: str
    numbers: list[int]


def shape_of(units: Units, number: NumberReader, names: Mapping[str, str]) -> Shape:
    """Return the shape of units; `names` gives the common name of words: {"minutes": "M"}."""
    words: list[str] = []
    numbers: list[int] = []
    place = 0
    while place < len(units):
        found = number(units, place)
        if found is None:
            word = units[place]
            words.append(names.get(word, word) if word.isalnum() else "?")
            place += 1
        else:
            words.append("#")
            numbers.append(found[0])
            place = found[1]
    return Shape(" ".join(words), numbers)


def length_of(shape: Shape, rules: Lengths, joint: re.Pattern[str]) -> str | None:
    """Return the seconds of parts in falling order: "two hours and ten minutes" is 7800.

    A rule reads one part, its unit of time in the group `unit`. A number alone at the end counts
    the next smaller unit ("two hours and ten").
    """
    total, place, counted, last = 0.0, 0, 0, ""
    while place < len(shape.text):
        gap = joint.match(shape.text, place) if place else None
        place = gap.end() if gap else place
        found, seconds, used = _part(shape, place, counted, rules)
        if found is None:
            rest = shape.numbers[counted:]
            alone = last in _BELOW and len(rest) == 1 and shape.text[place:] == "#"
            return _written(total + rest[0] * _BELOW[last]) if alone and rest[0] < 60 else None
        unit = found["unit"]
        if last and SECONDS[unit] >= SECONDS[last]:
            return None
        total, place, counted, last = total + seconds, found.end(), counted + used, unit
    return _written(total)


def _part(
    shape: Shape, place: int, counted: int, rules: Lengths
) -> tuple[re.Match[str] | None, float, int]:
    for rule, seconds in rules:
        found = rule.match(shape.text, place)
        if found:
            used = found.group().count("#")
            numbers = shape.numbers[counted : counted + used]
            return found, seconds(numbers, SECONDS[found["unit"]]), used
    return None, 0, 0


def _written(seconds: float) -> str | None:
    whole = round(seconds)
    return str(whole) if 0 < whole <= 366 * DAY else None


def part_of_day(text: str, parts: Mapping[str, str]) -> tuple[str, str]:
    """Return a time without the part of the day at its end or its beginning, and that part.

    `parts` gives the wordings of each part, parted by |; "" where none is said.
    """
    for part, wordings in parts.items():
        for wording in wordings.split("|"):
            if text.endswith(" " + wording):
                return text[: -len(wording) - 1], part
            if text.startswith(wording + " "):
                return text[len(wording) + 1 :], part
    return text, ""


def clock_of(text: str, numbers: list[int], rules: Clocks) -> str | None:
    """Return HHMM by the first rule that reads the whole text."""
    for rule, read in rules:
        if rule.fullmatch(text):
            return read(numbers)
    return None
