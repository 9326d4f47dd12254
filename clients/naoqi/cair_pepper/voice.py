# -*- coding: utf-8 -*-
"""The robot's voice: animated speech, its language, its speed and its volume."""

from __future__ import unicode_literals

import logging
import re

_log = logging.getLogger(__name__)

NAOQI_LANGUAGES = {"en": "English", "it": "Italian", "ja": "Japanese"}
SPEEDS = (50, 150)  # percent of the voice's own
VOLUMES = (20, 100)  # never so low that nobody hears the robot any more
STEP = 10
WIDE_STEP = 20  # between normal and high, normal and low


class Voice(object):
    """Says texts through ALAnimatedSpeech, or ALTextToSpeech where there is none."""

    def __init__(self, services, settings):
        self._services = services
        self._settings = settings
        self._speed = settings["voice_speed"]
        self._volume = settings["volume"]

    def prepare(self):
        """Set language, speed and volume; a language that is not installed is logged."""
        language = NAOQI_LANGUAGES[self._settings["language"]]
        self._services.quietly("ALTextToSpeech", "setLanguage", language)
        self._services.quietly("ALTextToSpeech", "setParameter", "speed", float(self._speed))
        self._services.quietly("ALAudioDevice", "setOutputVolume", int(self._volume))

    def say(self, text):
        """Say a text, with gestures; returns when it has been said. Raises UnableError."""
        spoken = plain(text)
        if not spoken:
            return
        _log.info("says: %s", spoken)
        if self._services.has("ALAnimatedSpeech"):
            mode = {"bodyLanguageMode": self._settings["body_language"]}
            self._services.call("ALAnimatedSpeech", "say", spoken, mode)
        else:
            self._services.call("ALTextToSpeech", "say", spoken)

    def stop(self):
        """Stop speaking in the middle of a word."""
        self._services.quietly("ALTextToSpeech", "stopAll")

    def set_speed(self, level):
        """Set the speed: high, normal, low, faster, slower. Raises UnableError."""
        speed = _stepped(level, self._speed, self._settings["voice_speed"], SPEEDS)
        self._services.call("ALTextToSpeech", "setParameter", "speed", float(speed))
        self._speed = speed

    def set_volume(self, level):
        """Set the volume: high, normal, low, or a step up or down. Raises UnableError."""
        volume = _stepped(level, self._volume, self._settings["volume"], VOLUMES)
        self._services.call("ALAudioDevice", "setOutputVolume", int(volume))
        self._volume = volume


def _stepped(level, now, normal, bounds):
    if level in ("high", "low", "normal"):
        wanted = normal + {"high": WIDE_STEP, "low": -WIDE_STEP, "normal": 0}[level]
    elif level in ("louder", "raise", "higher", "faster"):
        wanted = now + STEP
    else:
        wanted = now - STEP
    return max(bounds[0], min(bounds[1], wanted))


def plain(text):
    r"""Return a text without what the voice would take for commands: `\vct=50\`, `^start(…)`."""
    return re.sub(r"\s+", " ", re.sub(r"\\[^\\\s]*\\|[\\^#]", " ", text or "")).strip()
