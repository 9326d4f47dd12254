# -*- coding: utf-8 -*-
"""Dates and times as one says them."""

from __future__ import unicode_literals

DAYS = {
    "en": ["Monday", "Tuesday", "Wednesday", "Thursday", "Friday", "Saturday", "Sunday"],
    "it": ["lunedì", "martedì", "mercoledì", "giovedì", "venerdì", "sabato", "domenica"],
    "ja": [day + "曜日" for day in "月火水木金土日"],
}
MONTHS = {
    "en": "January February March April May June July August September October November December",
    "it": "gennaio febbraio marzo aprile maggio giugno luglio agosto settembre ottobre novembre "
    "dicembre",
}


def spoken_date(moment, language):
    """Return the date: "Today is Saturday, the 21st of November"."""
    day = DAYS[language][moment.weekday()]
    if language == "ja":
        return "今日は%d月%d日、%sです。" % (moment.month, moment.day, day)
    month = MONTHS[language].split()[moment.month - 1]
    if language == "it":
        return "Oggi è %s %s %s." % (day, "il primo" if moment.day == 1 else moment.day, month)
    return "Today is %s, the %s of %s." % (day, _ordinal(moment.day), month)


def _ordinal(number):
    ending = (
        "th" if 10 <= number % 100 <= 20 else {1: "st", 2: "nd", 3: "rd"}.get(number % 10, "th")
    )
    return "%d%s" % (number, ending)


def spoken_time(moment, language):
    """Return the time: "It is 20 past 3 in the afternoon"."""
    return {"en": _english, "it": _italian, "ja": _japanese}[language](moment.hour, moment.minute)


def _english(hour, minute):
    if minute > 30:
        hour, minutes, word = (hour + 1) % 24, 60 - minute, "to"
    else:
        minutes, word = minute, "past"
    shown = {0: "midnight", 12: "noon"}.get(hour) or "%d" % (hour % 12 or 12)
    part = "" if hour in (0, 12) else _part_of_day(hour)
    if minutes == 0:
        return "It is %s%s." % (shown if hour in (0, 12) else shown + " o'clock", part)
    amount = {15: "a quarter", 30: "half"}.get(minutes)
    if amount is None:
        amount = "%d%s" % (minutes, "" if minutes % 5 == 0 else " minute" + "s" * (minutes > 1))
    return "It is %s %s %s%s." % (amount, word, shown, part)


def _part_of_day(hour):
    if hour < 12:
        return " in the morning"
    return " in the afternoon" if hour < 18 else " in the evening"


def _italian(hour, minute):
    hours = {0: "È mezzanotte", 1: "È l'una", 12: "È mezzogiorno"}.get(hour, "Sono le %d" % hour)
    if minute == 0:
        return hours + "."
    return "%s e %s." % (hours, {15: "un quarto", 30: "mezza", 1: "un minuto"}.get(minute, minute))


def _japanese(hour, minute):
    half = "午前" if hour < 12 else "午後"
    minutes = "%d分" % minute if minute else ""
    return "今は%s%d時%sです。" % (half, hour % 12, minutes)
