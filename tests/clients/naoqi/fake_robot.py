# -*- coding: utf-8 -*-
"""A robot that only writes down what it would do, on a qi session or without.

Every Python a robot may have reads this file and fake_services.py: no newer syntax.
"""

# ruff: noqa: UP004, UP009, UP010, UP031

from __future__ import unicode_literals

import threading
import time

try:
    from fake_memory import text
    from fake_services import services
except ImportError:  # not run as a program: walk.py
    from tests.clients.naoqi.fake_memory import text
    from tests.clients.naoqi.fake_services import services


class Signal(object):
    """A signal for sessions that are none of qi's: calls on a thread of its own, as qi does."""

    def __init__(self):
        self._connected = {}

    def connect(self, callback):
        number = len(self._connected) + 1
        self._connected[number] = callback
        return number

    def disconnect(self, number):
        del self._connected[number]

    def __call__(self, *values):
        callbacks = list(self._connected.values())
        thread = threading.Thread(target=lambda: [one(*values) for one in callbacks])
        thread.start()
        thread.join(5)


class Notes(object):
    """What the robot did, in order. `when(line, act)` lets something happen at that moment."""

    def __init__(self):
        self.lines = []
        self._news = threading.Condition()
        self._acts = []
        self._read = 0

    def add(self, line, *values):
        line = line % tuple(text(one) for one in values)
        with self._news:
            self.lines.append(line)
            self._news.notify_all()
            acts = [act for start, act in self._acts if line.startswith(start)]
            self._acts = [one for one in self._acts if not line.startswith(one[0])]
        for act in acts:
            act()

    def when(self, start, act):
        self._acts.append((start, act))

    def wait_for(self, start, seconds=20.0):
        """Return the next line that begins so, after those that were waited for before."""
        until = time.time() + seconds
        with self._news:
            while True:
                for place in range(self._read, len(self.lines)):
                    if self.lines[place].startswith(start):
                        self._read = place + 1
                        return self.lines[place]
                self._news.wait(0.5)
                if time.time() > until:
                    shown = "\n".join(self.lines[-30:])
                    raise AssertionError("No line begins with %r in\n%s" % (str(start), shown))


class Session(object):
    """A session that is none of qi's: the services are in the same program."""

    def __init__(self, offered):
        self._offered = offered

    def service(self, name):
        if name not in self._offered:
            raise RuntimeError("Cannot find service '%s' in index" % name)
        return self._offered[name]


class FakeRobot(object):
    """What a test does to a robot, and what it sees of it."""

    def __init__(self, notes, offered, session):
        self.notes = notes
        self.offered = offered
        self.session = session
        self.address = ""
        self.memory = offered["ALMemory"]
        self.behaviours = offered["ALBehaviorManager"]

    def person(self, sentence, event="CAIR/Heard", confidence=None):
        """Let the person say a sentence, as soon as the robot listens."""
        self.memory.wait_until_it_listens()
        self.notes.add("person: %s", sentence)
        value = sentence if confidence is None else [sentence, confidence]
        self.memory.subscriber(event).signal(value)

    def turn(self, sentence):
        """Let the person say a sentence; returns the lines of what the robot did then."""
        self.memory.wait_until_it_listens()
        before, begin = self.memory.times_opened, len(self.notes.lines)
        self.person(sentence)
        self.memory.wait_until_it_listens(before)
        return self.notes.lines[begin + 1 :]

    def touch(self):
        """Touch the robot's head."""
        self.notes.add("person: (touches its head)")
        self.memory.subscriber("MiddleTactilTouched").signal(1.0)
        self.memory.subscriber("MiddleTactilTouched").signal(0.0)

    def touch_soon(self):
        """Touch it from another thread: who calls this may be the robot."""
        threading.Timer(0.2, self.touch).start()


def without_qi():
    """Return a robot in the same program."""
    notes = Notes()
    offered = services(notes, lambda signature: Signal())
    return FakeRobot(notes, offered, Session(offered))
