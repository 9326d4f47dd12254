"""Numbers, lengths, clock times and days in Italian."""

import re

from languages.spoken.italian_numbers import LISTED_NUMBERS, folded, is_number, number_at
from languages.spoken.items import (
    SECONDS,
    Clocks,
    Lengths,
    clock_of,
    length_of,
    part_of_day,
    shape_of,
)
from languages.spoken.shape import (
    WEEKDAYS,
    Spoken,
    SpokenKind,
    Units,
    before,
    clock,
    day_of_year,
    days_ahead,
    in_part_of_day,
    listed,
    numbered,
    words,
    written_day,
)

_WEEKDAYS = {
    word: WEEKDAYS[place]
    for word, place in numbered("lunedi martedi mercoledi giovedi venerdi sabato domenica").items()
}
_MONTHS = numbered(
    "gennaio febbraio marzo aprile maggio giugno luglio agosto settembre ottobre novembre dicembre",
    1,
)
_LENGTH_NAMES = {
    word: letter
    for letter, text in {
        "S": "s sec secondo secondi",
        "M": "min minuto minuti minutino minutini",
        "H": "h ora ore oretta orette",
        "D": "giorno giorni",
        "W": "settimana settimane",
    }.items()
    for word in text.split()
}
_DOZENS = {"decina": 10, "dozzina": 12, "quindicina": 15, "ventina": 20, "trentina": 30}


def _number(units: Units) -> str | None:
    found = number_at(folded(units), 0)
    return str(found[0]) if found and found[1] == len(units) else None


_UNIT = r"(?P<unit>[SMHDW])\b"
_LENGTH_RULES: Lengths = [
    (re.compile(rf"# {_UNIT} e mezz[ao]\b"), lambda n, u: (n[0] + 0.5) * u),
    (re.compile(rf"# {_UNIT} e # quart[oi]\b"), lambda n, u: (n[0] + n[1] / 4) * u),
    (re.compile(rf"# e mezz[ao] {_UNIT}"), lambda n, u: (n[0] + 0.5) * u),
    (re.compile(rf"# quart[oi] d {_UNIT}"), lambda n, u: n[0] * u / 4),
    (re.compile(rf"# paio (?:di |d ){_UNIT}"), lambda n, u: 2 * u),
    (re.compile(rf"# # {_UNIT}"), lambda n, u: (n[0] + n[1] / 10 ** len(str(n[1]))) * u),
    (re.compile(rf"# {_UNIT}"), lambda n, u: n[0] * u),
    (re.compile(rf"(?:# )?mezz[ao]? {_UNIT}"), lambda n, u: u / 2),
]
_JOINT = re.compile(" e | ")
_DOZEN = re.compile(rf"# (?P<dozen>{'|'.join(_DOZENS)}) di {_UNIT}")
_HALF_HOUR = {"mezzora": ("mezz", "ora"), "mezzoretta": ("mezz", "ora")}


def _length(units: Units) -> str | None:
    apart = tuple(word for unit in folded(units) for word in _HALF_HOUR.get(unit, (unit,)))
    shape = shape_of(apart, number_at, _LENGTH_NAMES)
    dozen = _DOZEN.fullmatch(shape.text)
    if dozen and shape.numbers == [1]:
        return str(_DOZENS[dozen["dozen"]] * SECONDS[dozen["unit"]])
    return length_of(shape, _LENGTH_RULES, _JOINT)


_OPENERS = "le|l|alle|all|verso|per|ore|a|ad|circa"
_PARTS_OF_DAY = {
    "am": "di mattina|del mattino|della mattina|di mattino|stamattina|mattina|am|a m",
    "pm": "di pomeriggio|del pomeriggio|pomeriggio|pm|p m",
    "evening": "di sera|della sera|di stasera|stasera|sera",
    "night": "di notte|della notte|stanotte|notte",
}
_OPENING = re.compile(rf"^(?:(?:{_OPENERS}) )+")
_SHARP = re.compile(" in punto$")
_CLOCK_RULES: Clocks = [
    (re.compile("#"), lambda n: clock(n[0], 0)),
    (re.compile("# (?:e )?#(?: minuti)?"), lambda n: clock(n[0], n[1])),
    (re.compile("# e mezz[ao]"), lambda n: clock(n[0], 30)),
    (re.compile("# e # quart[oi]"), lambda n: clock(n[0], 15 * n[1])),
    (re.compile("# meno #(?: minuti)?"), lambda n: before(n[0], n[1])),
    (re.compile("# meno # quarto"), lambda n: before(n[0], 15 * n[1])),
    (re.compile("mezzogiorno"), lambda n: "1200"),
    (re.compile("mezzogiorno e mezz[ao]"), lambda n: "1230"),
    (re.compile("mezzogiorno e # quarto"), lambda n: "1215"),
    (re.compile("mezzogiorno e #"), lambda n: clock(12, n[0])),
    (re.compile("mezzanotte"), lambda n: "0000"),
    (re.compile("mezzanotte e mezz[ao]"), lambda n: "0030"),
    (re.compile("mezzanotte e # quarto"), lambda n: "0015"),
    (re.compile("mezzanotte e #"), lambda n: clock(0, n[0])),
]


def _spoken_time(units: Units) -> str | None:
    shape = shape_of(folded(units), number_at, {})
    text, part = part_of_day(_OPENING.sub("", shape.text), _PARTS_OF_DAY)
    core = _SHARP.sub("", _OPENING.sub("", text))
    return in_part_of_day(clock_of(core, shape.numbers, _CLOCK_RULES), part)


_DAYS_AHEAD = {
    "oggi": 0,
    "stasera": 0,
    "stanotte": 0,
    "domani": 1,
    "dopodomani": 2,
    "dopo domani": 2,
}
_NAMES = "|".join(_WEEKDAYS)
_WEEKDAY = re.compile(
    rf"(?:di |il |la |per |questo |questa |prossimo |prossima )*({_NAMES})(?: prossim[oa])?"
)
_MONTH = re.compile(
    rf"(?:per )?(?:il |l |lo )?(?:giorno )?(?:#|primo) (?:di )?({'|'.join(_MONTHS)})"
)
_AHEAD = re.compile("(?:fra|tra) # (?:giorn[io]|(?P<weeks>settiman[ae]))")
_WRITTEN = re.compile("(?:per )?(?:il |l )?# #")


def _day(units: Units) -> str | None:
    shape = shape_of(folded(units), number_at, {})
    text, numbers = shape.text, shape.numbers
    weekday, month = _WEEKDAY.fullmatch(text), _MONTH.fullmatch(text)
    if text in _DAYS_AHEAD:
        return days_ahead(_DAYS_AHEAD[text])
    if weekday:
        return _WEEKDAYS[weekday[1]]
    if month:
        return day_of_year(_MONTHS[month[1]], numbers[0] if numbers else 1)
    if _WRITTEN.fullmatch(text) and all(unit.isdecimal() for unit in units[-2:]):
        return written_day(numbers[0], numbers[1])
    ahead = _AHEAD.fullmatch(text)
    return days_ahead(numbers[0] * (7 if ahead["weeks"] else 1)) if ahead else None


_ACCENTED = frozenset(name[:-1] + "ì" for name in _WEEKDAYS if name.endswith("i"))
_LENGTH_WORDS = words("e mezz mezza mezzo mezzora mezzoretta quarto quarti d di paio")
_CLOCK_WORDS = words(
    "e mezza mezzo un quarto quarti meno mezzogiorno mezzanotte di mattina mattino della del "
    "pomeriggio sera notte in punto minuti am pm p m stamattina stasera stanotte"
)
_PART_WORDS = words("mattina pomeriggio sera notte stamattina stasera stanotte")
_DAY_WORDS = words(
    "oggi stasera stanotte domani dopodomani dopo prossimo prossima di primo giorno giorni "
    "settimana settimane"
)

ITALIAN = Spoken(
    kinds={
        "number": SpokenKind(_number, LISTED_NUMBERS | words("e mila"), unlisted=is_number),
        "duration": SpokenKind(
            _length,
            LISTED_NUMBERS | _LENGTH_WORDS | {*_LENGTH_NAMES, *_DOZENS},
            unlisted=is_number,
        ),
        "time": SpokenKind(
            _spoken_time,
            LISTED_NUMBERS | _CLOCK_WORDS,
            frozenset(_OPENERS.split("|")) | _PART_WORDS,
        ),
        "date": SpokenKind(
            _day,
            LISTED_NUMBERS | _DAY_WORDS | _ACCENTED | {*_WEEKDAYS, *_MONTHS},
            words("il l la lo per questo questa fra tra"),
        ),
    },
    most_units=14,
    examples={
        "number": ("tre", "20", "quarantadue", "cento"),
        "duration": ("venti minuti", "un'ora e mezza", "mezz'ora", "90 secondi"),
        "time": ("le sette", "le otto e mezza", "le 19:30", "le nove di mattina"),
        "date": ("domani", "lunedì", "il 25 dicembre", "oggi"),
        "yes_no": ("sì", "no", "certo", "non molto"),
    },
    leads=listed("è|sono|direi|diciamo|ho detto|facciamo|magari"),
)
