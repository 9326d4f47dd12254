"""The shape of what a language knows of numbers and times, and how their meanings are written.

Every meaning is one word of ASCII: a number and a length (seconds) in digits, a time as HHMM, a
day as today, tomorrow, in_2_days, monday or MMDD, an answer as yes or no.
"""

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from languages.language import Attitude

Units = tuple[str, ...]

MINUTE, HOUR, DAY, WEEK = 60, 3_600, 86_400, 604_800
MOST_DIGITS = 15
WEEKDAYS = ("monday", "tuesday", "wednesday", "thursday", "friday", "saturday", "sunday")
_DAYS = (31, 29, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31)
_THOUSANDS = re.compile(r"\d{3}")
_POSITIVE = frozenset({Attitude.YES_STRONG, Attitude.YES, Attitude.A_LITTLE})
_NEGATIVE = frozenset({Attitude.NO_STRONG, Attitude.NO, Attitude.NOT_REALLY})


@dataclass(frozen=True, slots=True)
class SpokenKind:
    """One kind of slot whose words are parsed as a whole.

    `words` are all units that can stand in it, digits aside; `openers` those that can stand only
    before all others ("at"). `unlisted` knows the units that are too many to be listed: long
    numbers in one word. `parse` returns the meaning of units, or None where they have none.
    """

    parse: Callable[[Units], str | None]
    words: frozenset[str]
    openers: frozenset[str] = frozenset()
    unlisted: Callable[[str], bool] | None = None

    def may_read(self, unit: str) -> bool:
        """Say whether this unit can stand in such a slot."""
        known = unit.isdecimal() or unit in self.words or unit in self.openers
        return known or (self.unlisted is not None and self.unlisted(unit))


@dataclass(frozen=True, slots=True)
class Spoken:
    """What one language knows: its kinds by name, and the most units such a slot may have.

    `examples` are phrases each kind reads, those of yes_no too, for samples and tests. `leads` and
    `tails` are put around a bare answer and are no part of it: "it is", "です".
    """

    kinds: Mapping[str, SpokenKind]
    most_units: int
    examples: Mapping[str, tuple[str, ...]]
    leads: frozenset[Units] = frozenset()
    tails: frozenset[Units] = frozenset()


def words(text: str) -> frozenset[str]:
    """Return the words of a table written in one string."""
    return frozenset(text.split())


def listed(text: str) -> frozenset[Units]:
    """Return the phrases of a table, parted by |, in words."""
    return frozenset(tuple(phrase.split()) for phrase in text.split("|"))


def numbered(text: str, start: int = 0, step: int = 1) -> dict[str, int]:
    """Return the words of a table with their numbers: {"one": 1, "two": 2}."""
    return {word: start + step * place for place, word in enumerate(text.split())}


def yes_or_no(attitude: Attitude) -> str | None:
    """Return yes or no for an attitude that says either."""
    if attitude in _POSITIVE:
        return "yes"
    return "no" if attitude in _NEGATIVE else None


def digits_value(units: Units) -> int | None:
    """Return the number written in digits: ("20",), ("1", "000"); None where it is none."""
    if not units or not all(unit.isdecimal() for unit in units):
        return None
    grouped = len(units[0]) <= 3 and all(_THOUSANDS.fullmatch(unit) for unit in units[1:])
    text = "".join(units)
    return int(text) if len(text) <= MOST_DIGITS and (grouped or len(units) == 1) else None


def clock(hour: int, minute: int) -> str | None:
    """Return HHMM, or None where there is no such time; 24 is 0."""
    return f"{hour % 24:02}{minute:02}" if 0 <= hour <= 24 and 0 <= minute < 60 else None


def before(hour: int, minute: int) -> str | None:
    """Return the time some minutes before a full hour: 15 before 8 is 0745."""
    if not (0 <= hour <= 24 and 0 < minute < 60):
        return None
    # On the clock people read, the hour before one is twelve.
    return clock(12 if hour == 1 else (hour - 1) % 24, 60 - minute)


def in_part_of_day(time: str | None, part: str) -> str | None:
    """Return a time as the part of the day tells: 0700 in the "evening" is 1900.

    Parts: am (or morning), pm (or afternoon), noon (the hours around it), evening, night.
    """
    if time is None:
        return None
    hour, minute = int(time[:2]), time[2:]
    return f"{_PARTS[part][hour]:02}{minute}" if hour <= 12 else time


def _hours(later: Sequence[int], twelve: int) -> tuple[int, ...]:
    return (*(hour + 12 if hour in later else hour for hour in range(12)), twelve)


_PARTS: Mapping[str, tuple[int, ...]] = {
    "": _hours((), 12),
    "am": _hours((), 0),
    "pm": _hours(range(12), 12),
    "noon": _hours(range(6), 12),
    "evening": _hours(range(4, 12), 0),
    "night": _hours(range(6, 12), 0),
}


def day_of_year(month: int, day: int) -> str | None:
    """Return MMDD, or None where there is no such day."""
    return f"{month:02}{day:02}" if 1 <= month <= 12 and 1 <= day <= _DAYS[month - 1] else None


def written_day(first: int, second: int) -> str | None:
    """Return MMDD of "25/12": the day comes first where both orders are possible."""
    return day_of_year(second, first) or day_of_year(first, second)


def days_ahead(days: int) -> str | None:
    """Return today, tomorrow, in_2_days and so on; None beyond a year."""
    if not 0 <= days <= 366:
        return None
    return ("today", "tomorrow")[days] if days < 2 else f"in_{days}_days"
