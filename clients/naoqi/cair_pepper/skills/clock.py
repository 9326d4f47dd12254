# -*- coding: utf-8 -*-
"""Date and time, spoken here; timers, alarms and reminders, kept as long as the program runs."""

from __future__ import unicode_literals

import datetime
import re

from cair_pepper.calendar_words import spoken_date, spoken_time
from cair_pepper.skills import Skill

WEEKDAYS = ["monday", "tuesday", "wednesday", "thursday", "friday", "saturday", "sunday"]


def skills(body):
    """Return them by action."""

    def always():
        return True

    def date(parameters):
        return spoken_date(body.now(), body.language)

    def time(parameters):
        return spoken_time(body.now(), body.language)

    return {
        "date": Skill(always, date),
        "time": Skill(always, time),
        "timer": Skill(always, lambda found: _timer(body, found)),
        "alarm": Skill(always, lambda found: _alarm(body, found)),
        "reminder": Skill(always, lambda found: _reminder(body, found)),
    }


def _timer(body, parameters):
    seconds = _digits(parameters.get("seconds"))
    if seconds is None:
        minutes = _digits(body.ask(body.text("ask_seconds")))
        seconds = None if minutes is None else 60 * minutes
    if seconds is None:
        return body.text("never_mind")
    body.later(seconds, "timer_over")
    return None


def _alarm(body, parameters):
    seconds = _seconds_until(body, parameters)
    if seconds is None:
        return body.text("never_mind")
    body.later(seconds, "alarm_rings")
    return None


def _reminder(body, parameters):
    seconds = _digits(parameters.get("seconds"))
    if seconds is None:
        seconds = _seconds_until(body, parameters)
    if seconds is None:
        return body.text("never_mind")
    what = parameters.get("what")
    if what:
        body.later(seconds, "reminder", what=what)
    else:
        body.later(seconds, "reminder_plain")
    return None


def _digits(value):
    found = re.search("[0-9]{1,6}", value or "")
    return int(found.group()) if found else None


def _seconds_until(body, parameters):
    """Return how long it is until the day and time that are meant, None where they are unclear."""
    hour, minute = _hour_and_minute(parameters.get("time") or body.ask(body.text("ask_time")))
    if hour is None:
        return None
    now = body.now()
    days = _days_ahead(parameters.get("day") or "today", now)
    if days is None:
        return None
    at = now.replace(hour=hour, minute=minute, second=0, microsecond=0)
    at += datetime.timedelta(days=days)
    if at <= now:
        at += datetime.timedelta(days=7 if parameters.get("day") in WEEKDAYS else 1)
    return int((at - now).total_seconds())


def _days_ahead(day, now):
    """Return in how many days it is: today, tomorrow, in_2_days, monday or MMDD; None: unknown."""
    if day in ("today", "tomorrow"):
        return int(day == "tomorrow")
    if day in WEEKDAYS:
        return (WEEKDAYS.index(day) - now.weekday()) % 7
    if re.match("in_[0-9]{1,4}_days$", day):
        return _digits(day)
    return _days_until_date(day, now) if re.match("[0-9]{4}$", day) else None


def _days_until_date(day, now):
    for year in range(now.year, now.year + 9):  # the 29th of February may be long in coming
        try:
            date = datetime.date(year, int(day[:2]), int(day[2:]))
        except ValueError:
            continue
        if date >= now.date():
            return (date - now.date()).days
    return None


def _hour_and_minute(said):
    """Return the time in "0730", "7:30" or "7 and 30"; (None, None) where there is none."""
    found = re.findall("[0-9]+", said or "")
    if len(found) == 1 and len(found[0]) == 4:
        found = [found[0][:2], found[0][2:]]
    if not found or int(found[0]) > 23:
        return None, None
    minute = int(found[1]) if len(found) > 1 else 0
    return (int(found[0]), minute) if minute < 60 else (None, None)
