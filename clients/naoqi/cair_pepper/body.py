# -*- coding: utf-8 -*-
"""What skills work with: the robot's services, its words, its ears and its patience."""

from __future__ import unicode_literals

import json
import logging
import threading

from cair_pepper.words import text

_log = logging.getLogger(__name__)


class Body(object):
    """A robot as skills see it.

    say, ask -- say(text); ask(text) returns the answer of the person, None where none came.
    now, chance -- the clock and the dice: datetime.now, random.Random().
    looks_away -- it waits for a touch, which then is no wish to stop.
    later -- later(seconds, name of a text, filled) says it then.
    """

    def __init__(self, services, settings, voice, tablet, places):
        self.services = services
        self.settings = settings
        self.voice = voice
        self.tablet = tablet
        self.places = places
        self.language = settings["language"]
        self.touched = threading.Event()
        self.say = self.ask = self.now = self.chance = self.later = self.meet = None
        self.looks_away = False
        self._running = None

    def text(self, name, **filled):
        """Return one of the robot's own texts."""
        return text(name, self.language, **filled)

    def asked(self, value, name, **filled):
        """Return what the person said, or what it says when asked for it; None: nothing."""
        return value or self.ask(self.text(name, **filled))

    def behaviour(self, action):
        """Return the installed behaviour of an action, "" where none is."""
        name = self.settings["behaviours"].get(action, "")
        return name if name and self.installed(name) else ""

    def installed(self, name):
        """Say whether a behaviour is installed."""
        return bool(self.services.quietly("ALBehaviorManager", "isBehaviorInstalled", name))

    def run(self, name, parameters=None):
        """Run a behaviour to its end; it finds its parameters in ALMemory. Raises UnableError."""
        told = json.dumps(parameters or {}, sort_keys=True)
        self.services.quietly("ALMemory", "insertData", "CAIR/Parameters", told)
        _log.info("behaviour: %s", name)
        self._running = name
        try:
            self.services.call("ALBehaviorManager", "runBehavior", name)
        finally:
            self._running = None

    def stop(self):
        """Stop what is going on, at once: somebody touched the head."""
        self.touched.set()
        self.voice.stop()
        running = self._running
        if running:
            self.services.quietly("ALBehaviorManager", "stopBehavior", running)
        if self.services.has("ALNavigation"):
            self.services.quietly("ALNavigation", "stopNavigateTo")
        self.services.quietly("ALMotion", "stopMove")
        if self.services.has("ALAudioPlayer"):
            self.services.quietly("ALAudioPlayer", "stopAll")
        self.tablet.stop()
