"""Numbers, lengths, clock times and days in Japanese."""

import re

from languages.spoken.shape import (
    DAY,
    HOUR,
    MINUTE,
    MOST_DIGITS,
    WEEK,
    WEEKDAYS,
    Spoken,
    SpokenKind,
    Units,
    before,
    clock,
    day_of_year,
    days_ahead,
    in_part_of_day,
    written_day,
)

_KANA = {
    "ゼロ": "0",
    "れい": "0",
    **dict.fromkeys(("いち", "いっ"), "1"),
    "に": "2",
    "さん": "3",
    **dict.fromkeys(("よん", "よ", "し"), "4"),
    "ご": "5",
    **dict.fromkeys(("ろく", "ろっ"), "6"),
    **dict.fromkeys(("なな", "しち"), "7"),
    **dict.fromkeys(("はち", "はっ"), "8"),
    **dict.fromkeys(("きゅう", "く"), "9"),
    **dict.fromkeys(("じゅう", "じゅっ", "じっ"), "十"),
    **dict.fromkeys(("ひゃく", "びゃく", "ぴゃく"), "百"),
    **dict.fromkeys(("せん", "ぜん"), "千"),
    "まん": "万",
}
_DIGITS = {kanji: str(value) for value, kanji in enumerate("〇一二三四五六七八九")} | {"零": "0"}
_SCALES = {"十": 10, "百": 100, "千": 1_000}
_WORDS = sorted([*_KANA, *_DIGITS, *_SCALES, "万"], key=len, reverse=True)
_NUMERAL = re.compile("|".join(_WORDS))
_WHOLE = re.compile(r"(?:(?P<myriads>[\d十百千]+)万)?(?P<rest>[\d十百千]*)")
_GROUP = re.compile(r"(\d*)([十百千]?)")
# One digit at a time: a repeated \d+ would take exponential time.
_N = rf"(?:\d|{'|'.join(_WORDS)})+"


def _read(text: str) -> int | None:
    """Return the number text says: 二十一, 3千, にじゅう, 二〇二六."""
    plain = _NUMERAL.sub(lambda found: _KANA.get(found[0], _DIGITS.get(found[0], found[0])), text)
    parts = _WHOLE.fullmatch(plain) if len(plain) <= MOST_DIGITS else None
    if not plain or parts is None:
        return None
    myriads = _below_myriad(parts["myriads"]) if parts["myriads"] else 0
    rest = _below_myriad(parts["rest"]) if parts["rest"] else 0
    if myriads is None or rest is None or (parts["myriads"] and rest >= 10_000):
        return None
    return myriads * 10_000 + rest


def _below_myriad(text: str) -> int | None:
    """Return a number whose scales fall: 三千二百十五; digits alone are read as they stand."""
    total, smallest = 0, 10_000
    for found in _GROUP.finditer(text):
        digits, scale = found.groups()
        if not found.group():
            continue
        size = _SCALES.get(scale, 1)
        several = len(digits) > 1 and (scale or total)
        if size >= smallest or several or (digits == "0" and scale):
            return None
        total, smallest = total + int(digits or 1) * size, size
    return total


def _number(units: Units) -> str | None:
    value = _read("".join(units))
    return None if value is None else str(value)


def _value(text: str | None) -> int:
    """Return the number of a group, 0 where it was not said, -1 where it is none."""
    value = _read(text) if text else 0
    return -1 if value is None else value


_LENGTH = re.compile(
    rf"(?:(?P<weeks>{_N})(?:週間?|しゅうかん))?"
    rf"(?:(?P<days>{_N})(?:日間?|にち))?"
    rf"(?:(?P<hours>{_N})(?:時間|じかん)(?P<half_hour>半|はん)?と?)?"
    rf"(?:(?P<minutes>{_N})(?:分間?|ふん|ぷん)(?P<half_minute>半|はん)?)?"
    rf"(?:(?P<seconds>{_N})(?:秒間?|びょう))?"
    "(?:くらい|ぐらい|ほど)?"
)
_SIZES = {"weeks": WEEK, "days": DAY, "hours": HOUR, "minutes": MINUTE, "seconds": 1}
_HALVES = {"半時間": HOUR // 2, "半日": DAY // 2, "はんにち": DAY // 2}


def _length(units: Units) -> str | None:
    text = "".join(units)
    if text in _HALVES:
        return str(_HALVES[text])
    found = _LENGTH.fullmatch(text)
    if found is None:
        return None
    numbers = {name: _value(found[name]) for name in _SIZES}
    total = sum(numbers[name] * size for name, size in _SIZES.items())
    total += HOUR // 2 if found["half_hour"] else 0
    total += MINUTE // 2 if found["half_minute"] else 0
    return str(total) if min(numbers.values()) >= 0 and 0 < total <= 366 * DAY else None


_PARTS = {
    "午前": "am",
    "早朝": "am",
    "今朝": "am",
    "朝": "am",
    "あさ": "am",
    "午後": "pm",
    "昼": "noon",
    "お昼": "noon",
    "夕方": "pm",
    "今夜": "night",
    "今晩": "night",
    "夜中": "night",
    "深夜": "night",
    "夜": "night",
    "よる": "night",
    "晩": "night",
}
_TIME = re.compile(
    rf"(?:(?P<part>{'|'.join(_PARTS)})の?)?(?P<hour>{_N})(?:時|じ)"
    rf"(?:(?P<half>半|はん)|(?P<minute>{_N})(?:分|ふん|ぷん)(?P<before>前)?)?"
    "(?:ちょうど|ごろ|頃)?"
)
_COLON = re.compile(rf"(?:(?P<part>{'|'.join(_PARTS)})の?)?(\d\d?) (\d\d)")
_FIXED = {"正午": "1200", "お昼": "1200", "真夜中": "0000"}


def _spoken_time(units: Units) -> str | None:
    text = "".join(units)
    colon, found = _COLON.fullmatch(_apart(units)), _TIME.fullmatch(text)
    if colon:
        part, time = colon["part"], clock(int(colon[2]), int(colon[3]))
    elif found:
        minute = 30 if found["half"] else _value(found["minute"])
        part, time = found["part"], clock(_value(found["hour"]), minute)
        time = _minutes_before(found) if found["before"] else time
    else:
        return _FIXED.get(text)
    return in_part_of_day(time, _PARTS[part]) if part else time


def _minutes_before(found: re.Match[str]) -> str | None:
    from_hour = _value(found["hour"])
    return before(from_hour, _value(found["minute"]))


def _apart(units: Units) -> str:
    """Join units with a blank between two of digits: 12/25 is "12 25"."""
    text = ""
    for unit in units:
        text += f" {unit}" if unit.isdecimal() and text[-1:].isdecimal() else unit
    return text


_DAYS_AHEAD = {
    **dict.fromkeys(("今日", "きょう", "本日", "今夜", "今晩"), 0),
    **dict.fromkeys(("明日", "あした", "あす", "みょうにち"), 1),
    **dict.fromkeys(("明後日", "あさって"), 2),
    **dict.fromkeys(("明々後日", "しあさって"), 3),
}
_WEEKDAYS = dict(zip("月火水木金土日", WEEKDAYS, strict=True))
_WEEKDAY = re.compile(r"(?:(?:次|今度|来週|今週|こんど|つぎ)の?)?([月火水木金土日])曜日?")
_MONTH_DAY = re.compile(rf"(?P<month>{_N})月(?:の)?(?P<day>{_N})日")
_AHEAD = re.compile(rf"({_N})(?:日|(?P<weeks>週間))後")


def _day(units: Units) -> str | None:
    text = "".join(units)
    weekday, month = _WEEKDAY.fullmatch(text), _MONTH_DAY.fullmatch(text)
    written, ahead = re.fullmatch(r"(\d\d?) (\d\d?)", _apart(units)), _AHEAD.fullmatch(text)
    if text in _DAYS_AHEAD:
        return days_ahead(_DAYS_AHEAD[text])
    if weekday:
        return _WEEKDAYS[weekday[1]]
    if month:
        return day_of_year(_value(month["month"]), _value(month["day"]))
    if written:
        # The month comes first.
        return written_day(int(written[2]), int(written[1]))
    return days_ahead(_value(ahead[1]) * (7 if ahead["weeks"] else 1)) if ahead else None


_NUMERALS = frozenset("".join(_WORDS))


def _characters(*texts: str) -> frozenset[str]:
    return frozenset("".join(texts))


JAPANESE = Spoken(
    kinds={
        "number": SpokenKind(_number, _NUMERALS),
        "duration": SpokenKind(
            _length,
            _NUMERALS
            | _characters("週間しゅうかん日にち時じかん半はん分ふんぷん秒びょうくらいぐほどと"),
        ),
        "time": SpokenKind(
            _spoken_time,
            _NUMERALS | _characters("の時じ半はん分ふんぷん前ちょうどごろ頃", *_PARTS, *_FIXED),
        ),
        "date": SpokenKind(
            _day,
            _NUMERALS | _characters(*_DAYS_AHEAD, *_WEEKDAYS, "次今度来週間今こんどつぎの曜日月後"),
        ),
    },
    most_units=28,
    examples={
        "number": ("三", "20", "四十二", "百"),
        "duration": ("二十分", "1時間半", "半時間", "90秒"),
        "time": ("7時", "八時半", "午後3時", "朝の九時"),
        "date": ("明日", "月曜日", "12月25日", "今日"),
        "yes_no": ("はい", "いいえ", "もちろん", "あまり"),
    },
    tails=frozenset(
        tuple(tail)
        for tail in (
            "です",
            "だ",
            "だよ",
            "ですね",
            "がいい",
            "がいいです",
            "でお願いします",
            "にして",
            "を",
        )
    ),
)
