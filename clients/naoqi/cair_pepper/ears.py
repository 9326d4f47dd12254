# -*- coding: utf-8 -*-
"""How the robot hears sentences. Whoever recognises speech raises an event of ALMemory."""

from __future__ import unicode_literals

import contextlib
import logging
import re
import threading
import time

from cair_pepper.words import VOCABULARY

_log = logging.getLogger(__name__)
_now = getattr(time, "monotonic", time.time)
_text = type("")

SUBSCRIBER = "CAIR"
LISTENING_EVENT = "CAIR/Listening"
TOPIC = "topic: ~cair()\nlanguage: %s\nu:(_*) $CAIR/DialogHeard=$1\n"
DIALOG_LANGUAGES = {"en": "enu", "it": "iti", "ja": "jpj"}
NAOQI_LANGUAGES = {"en": "English", "it": "Italian", "ja": "Japanese"}


class EventEars(object):
    """A recogniser outside NAOqi: it raises `heard_event` with a sentence.

    The value is the sentence or [sentence, confidence]. `CAIR/Listening` is raised with 1 when it
    should listen, with 0 while the robot speaks.
    """

    def __init__(self, services, settings):
        self.services = services
        self.settings = settings
        self.event = settings["heard_event"]
        self._forget = None

    def open(self, heard):
        """Begin; heard(value) gets what the event holds. Raises UnableError."""
        self._forget = self.services.listen(self.event, heard)
        self.begin()

    def begin(self):
        """Prepare the recogniser."""

    def close(self):
        """End."""
        if self._forget:
            self._forget()
            self._forget = None

    def pause(self, pausing):
        """Let the recogniser be quiet while the robot speaks."""
        self.services.quietly("ALMemory", "raiseEvent", LISTENING_EVENT, 0 if pausing else 1)


class WordEars(EventEars):
    """ALSpeechRecognition: hears the phrases of the vocabulary, on the robot, for nothing."""

    def __init__(self, services, settings):
        EventEars.__init__(self, services, settings)
        self.event = "WordRecognized"

    def begin(self):
        """Set language and vocabulary."""
        language = self.settings["language"]
        vocabulary = self.settings["vocabulary"] or VOCABULARY[language]
        recognition = "ALSpeechRecognition"
        self.services.call(recognition, "pause", True)  # the vocabulary cannot change before
        self.services.call(recognition, "setLanguage", NAOQI_LANGUAGES[language])
        self.services.call(recognition, "setVocabulary", vocabulary, False)
        self.services.call(recognition, "subscribe", SUBSCRIBER)
        self.services.call(recognition, "pause", False)

    def close(self):
        """End."""
        EventEars.close(self)
        self.services.quietly("ALSpeechRecognition", "unsubscribe", SUBSCRIBER)

    def pause(self, pausing):
        """Let the recogniser be quiet while the robot speaks."""
        self.services.quietly("ALSpeechRecognition", "pause", pausing)


class DialogEars(EventEars):
    """ALDialog with a topic that takes everything: free speech, where the robot has dictation."""

    def __init__(self, services, settings):
        EventEars.__init__(self, services, settings)
        self.event = "Dialog/LastInput"
        self._topic = ""

    def begin(self):
        """Load and start the topic."""
        language = self.settings["language"]
        self.services.quietly("ALDialog", "setLanguage", NAOQI_LANGUAGES[language])
        content = TOPIC % DIALOG_LANGUAGES[language]
        self._topic = self.services.call("ALDialog", "loadTopicContent", content)
        self.services.call("ALDialog", "activateTopic", self._topic)
        self.services.call("ALDialog", "subscribe", SUBSCRIBER)

    def close(self):
        """End."""
        EventEars.close(self)
        self.services.quietly("ALDialog", "unsubscribe", SUBSCRIBER)
        self.services.quietly("ALDialog", "deactivateTopic", self._topic)
        self.services.quietly("ALDialog", "unloadTopic", self._topic)

    def pause(self, pausing):
        """Let the recogniser be quiet while the robot speaks."""
        self.services.quietly("ALSpeechRecognition", "pause", pausing)


EARS = {"event": EventEars, "words": WordEars, "dialog": DialogEars}


class Hearing(object):
    """Sentences, but none of the robot's own: it is deaf while it speaks and a moment after.

    hears(sentence) is called on a thread of NAOqi's.
    """

    def __init__(self, services, settings, hears):
        self._ears = EARS[settings["ears"]](services, settings)
        self._settings = settings
        self._hears = hears
        self._lock = threading.RLock()
        self._deaf = 0
        self._open_since = 0.0

    def open(self):
        """Begin to listen. Raises UnableError."""
        self._ears.open(self._heard)
        self._ears.pause(self._deaf > 0)

    def close(self):
        """Listen no more."""
        self._ears.close()

    @contextlib.contextmanager
    def deaf(self):
        """Hear nothing as long as the context lasts."""
        self._count(self._deaf + 1)
        try:
            yield
        finally:
            self._count(self._deaf - 1)

    @contextlib.contextmanager
    def listening(self):
        """Hear, as long as the context lasts, inside a context of deafness."""
        before = self._deaf
        self._count(0)
        try:
            yield
        finally:
            self._count(before)

    def _count(self, deaf):
        with self._lock:
            changed = (deaf > 0) != (self._deaf > 0)
            self._deaf = deaf
            if changed:
                self._open_since = _now()
        if changed:
            self._ears.pause(deaf > 0)

    def _heard(self, value):
        sentence = understood(value, self._settings["confidence"])
        with self._lock:
            too_early = self._deaf or _now() - self._open_since < self._settings["echo"]
        if not sentence or too_early:
            _log.debug("not heard: %r", value)
            return
        self._hears(without_name(sentence, self._settings["robot_name"]))


def understood(value, confidence):
    """Return the sentence in the value of an event, "" where there is none that is sure enough.

    The value is "a sentence", or ["first guess", 0.8, "second guess", 0.3, …].
    """
    if isinstance(value, list):
        if not value or (len(value) > 1 and value[1] < confidence):
            return ""
        value = value[0]
    if not isinstance(value, _text):
        return ""
    return re.sub(r"<\.\.\.>", " ", value).strip()


def without_name(sentence, name):
    """Return a sentence without the robot's name it begins or ends with: "Pepper, play a song"."""
    if not name:
        return sentence
    called = re.escape(name)
    inner = re.sub(
        r"(?iu)^%s(?:\s*[,、!！]\s*|\s+)|\s*[,、]\s*%s\s*$" % (called, called), "", sentence
    )
    return inner.strip() or sentence
