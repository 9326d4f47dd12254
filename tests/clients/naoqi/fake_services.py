# -*- coding: utf-8 -*-
"""NAOqi's services as they would be called: each writes down what it is told.

Each method has as many parameters as the client gives: a real qi session refuses others.
"""

# ruff: noqa: N802, RUF005, UP004, UP009, UP010

from __future__ import unicode_literals

import threading

try:
    from urllib.parse import unquote_plus  # novermin
except ImportError:  # Python 2.7
    from urllib import unquote_plus  # novermin

try:
    from fake_memory import Memory, text
except ImportError:  # not run as a program: walk.py
    from tests.clients.naoqi.fake_memory import Memory, text


def native(words):
    """Return text as this Python's own kind: bytes on 2.7, whose unquote_plus wants them."""
    return words if isinstance(words, str) else words.encode("ascii")


FACTORY = ("animations/Stand/Gestures/Hey_1", "animations/Stand/Gestures/BowShort_1")


class AnimatedSpeech(object):
    def __init__(self, notes):
        self._notes = notes

    def say(self, said, configuration):
        self._notes.add("says: %s", said)


class TextToSpeech(object):
    def __init__(self, notes):
        self._notes = notes

    def setLanguage(self, language):
        self._notes.add("voice: %s", language)

    def setParameter(self, name, value):
        self._notes.add("voice: %s %d", name, value)

    def stopAll(self):
        self._notes.add("voice: stops")


class AudioDevice(object):
    def __init__(self, notes):
        self._notes = notes

    def setOutputVolume(self, volume):
        self._notes.add("voice: volume %d", volume)


class BehaviorManager(object):
    """`installed` may be changed at any time; those of `broken` fail when they run."""

    def __init__(self, notes):
        self._notes = notes
        self._stopped = threading.Event()
        self.installed = set(FACTORY + ("cair/hug", "cair/cover_eyes", "cair/playsong"))
        self.broken = set()
        self.long = set()

    def isBehaviorInstalled(self, name):
        return text(name) in self.installed

    def runBehavior(self, name):
        if text(name) in self.broken or text(name) not in self.installed:
            raise RuntimeError("The behavior could not be run.")
        self._notes.add("behaviour: %s", name)
        if text(name) in self.long:
            self._stopped.wait(20)

    def stopBehavior(self, name):
        self._notes.add("behaviour stopped: %s", name)
        self._stopped.set()


class TabletService(object):
    def __init__(self, notes, make_signal):
        self._notes = notes
        self.videoFinished = make_signal("()")
        self.brightness = 0.6

    def showWebview(self, address):
        page, _, words = text(address).rpartition("/")[2].partition("?text=")
        shown = unquote_plus(native(words))
        self._notes.add("tablet: %s (%s)", page.replace(".html", ""), shown)
        return True

    def hideWebview(self):
        self._notes.add("tablet: nothing")

    def playVideo(self, address):
        self._notes.add("tablet: video %s", address)
        return True

    def showImage(self, address):
        self._notes.add("tablet: picture %s", address)
        return True

    def stopVideo(self):
        self._notes.add("tablet: video stops")

    def getBrightness(self):
        return self.brightness

    def setBrightness(self, brightness):
        self._notes.add("tablet: brightness %.1f", brightness)


class Motion(object):
    def __init__(self, notes):
        self._notes = notes

    def wakeUp(self):
        self._notes.add("motion: wakes up")

    def rest(self):
        self._notes.add("motion: rests")

    def moveTo(self, x, y, turn):
        self._notes.add("motion: %.1f m ahead, %.1f m left, turn %.1f", x, y, turn)
        return True

    def moveToward(self, x, y, turn):
        self._notes.add("motion: sets out %.1f %.1f", x, y)

    def moveIsActive(self):
        return True

    def stopMove(self):
        self._notes.add("motion: stops")

    def setAngles(self, names, angles, speed):
        self._notes.add("motion: head %.1f", angles[0])


class Leds(object):
    def __init__(self, notes):
        self._notes = notes

    def fadeRGB(self, name, colour, seconds):
        self._notes.add("eyes: %s", "light" if colour else "dark")


class Navigation(object):
    """A robot on a map; `blocked` ways fail so many times."""

    def __init__(self, notes):
        self._notes = notes
        self.position = [1.0, 2.0, 0.5]
        self.blocked = 0

    def getRobotPositionInMap(self):
        return [self.position, [0.1, 0.1, 0.1]]

    def navigateToInMap(self, position):
        self._notes.add("navigation: to %.1f %.1f", position[0], position[1])
        self.blocked -= 1
        return 1 if self.blocked >= 0 else 0

    def relocalizeInMap(self, position):
        self._notes.add("navigation: is at %.1f %.1f", position[0], position[1])

    def loadExploration(self, path):
        return True

    def startLocalization(self):
        return True

    def stopLocalization(self):
        self._notes.add("navigation: no map")

    def stopNavigateTo(self):
        self._notes.add("navigation: stops")

    def explore(self, metres):
        self._notes.add("navigation: explores %.0f m", metres)
        return 0

    def saveExploration(self):
        return "/home/nao/map.explo"


class Recharge(object):
    def __init__(self, notes):
        self._notes = notes
        self.there = True

    def lookForStation(self):
        self._notes.add("dock: looks for it")
        return [self.there, [1.0, 0.0, 0.0]]

    def moveInFrontOfStation(self):
        self._notes.add("dock: goes before it")
        return True

    def dockOnStation(self):
        self._notes.add("dock: docks")
        return self.there

    def leaveStation(self):
        self._notes.add("dock: leaves")


class SpeechRecognition(object):
    def __init__(self, notes):
        self._notes = notes

    def setLanguage(self, language):
        self._notes.add("ears: %s", language)

    def setVocabulary(self, vocabulary, spotting):
        self._notes.add("ears: %d phrases", len(vocabulary))

    def subscribe(self, name):
        self._notes.add("ears: begin")

    def unsubscribe(self, name):
        self._notes.add("ears: end")

    def pause(self, pausing):
        """Nothing to be written down: it is paused often."""


class Dialog(object):
    def __init__(self, notes):
        self._notes = notes

    def setLanguage(self, language):
        self._notes.add("ears: %s", language)

    def loadTopicContent(self, content):
        return text(content).split("~")[1].split("(")[0]

    def activateTopic(self, topic):
        self._notes.add("ears: topic %s", topic)

    def deactivateTopic(self, topic):
        self._notes.add("ears: no topic %s", topic)

    def unloadTopic(self, topic):
        """Nothing to be written down."""

    def subscribe(self, name):
        self._notes.add("ears: begin")

    def unsubscribe(self, name):
        self._notes.add("ears: end")


def services(notes, make_signal):
    """Return the services of a Pepper by name. make_signal(signature) makes a signal."""
    made = {"ALMemory": Memory(notes, make_signal)}
    made["ALTabletService"] = TabletService(notes, make_signal)
    noting = {
        "ALAnimatedSpeech": AnimatedSpeech,
        "ALAudioDevice": AudioDevice,
        "ALBehaviorManager": BehaviorManager,
        "ALDialog": Dialog,
        "ALLeds": Leds,
        "ALMotion": Motion,
        "ALNavigation": Navigation,
        "ALRecharge": Recharge,
        "ALSpeechRecognition": SpeechRecognition,
        "ALTextToSpeech": TextToSpeech,
    }
    made.update((name, kind(notes)) for name, kind in noting.items())
    return made
