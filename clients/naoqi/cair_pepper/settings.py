# -*- coding: utf-8 -*-
"""The settings file: JSON, each name with a default, wrong ones refused by name."""

from __future__ import unicode_literals

import json
import os

_text = type("")

LANGUAGES = ("en", "it", "ja")
EARS = ("event", "words", "dialog")

#: Behaviours: factory animations, and names under which one may install one's own.
BEHAVIOURS = {
    "hello": "animations/Stand/Gestures/Hey_1",
    "attention": "animations/Stand/Gestures/Hey_6",
    "konnichiwa": "animations/Stand/Gestures/BowShort_1",
    "namaste": "cair/namaste",
    "hug": "cair/hug",
    "handshake": "cair/handshake",
    "followme": "cair/followme",
    "privacy": "cair/cover_eyes",
    "playsong": "cair/playsong",
    "playkaraoke": "cair/playkaraoke",
    "playmovie": "cair/playmovie",
    "showinstructions": "cair/showinstructions",
    "showexercise": "cair/showexercise",
    "dance": "cair/dance",
    "quiz": "cair/quiz",
    "light": "cair/light",
    "call": "cair/call",
}

DEFAULTS = {
    "server": "http://127.0.0.1:8000",
    "key": "",
    "ca_file": "",
    "language": "en",
    "culture": "",
    "seed": 0,
    "patience": 6.0,
    "robot_name": "Pepper",
    "person": "",
    "folder": "~/cair",
    "voice_speed": 85,
    "volume": 60,
    "body_language": "contextual",
    "ears": "event",
    "heard_event": "CAIR/Heard",
    "vocabulary": [],
    "confidence": 0.4,
    "echo": 0.3,
    "answer_seconds": 15.0,
    "tablet_pages": "http://198.18.0.1/apps/cair/",
    "autonomous_life": "disabled",
    "behaviours": {},
    "media": {},
    "lookups": {},
    "alert": {"event": "", "url": ""},
}

CHOICES = {
    "language": LANGUAGES,
    "culture": ("", "EN", "IT", "JP", "IN"),
    "ears": EARS,
    "body_language": ("contextual", "random", "disabled"),
}


class SettingsError(Exception):
    """A setting is wrong; the text names it."""


def read_settings(text=""):
    """Return all settings of a file's text. Raises SettingsError."""
    try:
        given = json.loads(text or "{}")
    except ValueError as error:
        raise SettingsError("The settings are no JSON: %s" % error)
    if not isinstance(given, dict):
        raise SettingsError('The settings are no JSON object: {"server": …}')
    for name, value in given.items():
        _check(name, value)
    settings = dict(DEFAULTS, **dict((str(name), value) for name, value in given.items()))
    settings["behaviours"] = dict(BEHAVIOURS, **_named(settings["behaviours"]))
    settings["alert"] = dict(DEFAULTS["alert"], **_named(settings["alert"]))
    settings["folder"] = os.path.expanduser(settings["folder"])
    return settings


def _named(values):
    return dict((str(name), value) for name, value in values.items())


def _check(name, value):
    if name not in DEFAULTS:
        known = ", ".join(sorted(DEFAULTS))
        raise SettingsError('There is no setting "%s". There are: %s.' % (name, known))
    wanted = type(DEFAULTS[name])
    kinds = (int, float) if wanted in (int, float) else wanted
    if not isinstance(value, kinds) or isinstance(value, bool):
        raise SettingsError('"%s" is not as it should be. Example: %r' % (name, DEFAULTS[name]))
    if name in CHOICES and value not in CHOICES[name]:
        raise SettingsError('"%s" is one of: %s.' % (name, ", ".join(CHOICES[name])))
    if name in ("behaviours", "alert", "lookups"):
        for one in value.values():
            if not isinstance(one, _text):
                raise SettingsError('Each value of "%s" is a text.' % name)
    if name == "media" and not all(isinstance(one, dict) for one in value.values()):
        raise SettingsError('Each value of "media" is an object: {"playsong": {"Volare": "…"}}')
