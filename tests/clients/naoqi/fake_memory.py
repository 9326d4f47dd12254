# -*- coding: utf-8 -*-
"""ALMemory: events with signals, and whether the robot listens."""

# ruff: noqa: N802, UP004, UP009, UP010

from __future__ import unicode_literals

import threading
import time


def text(value):
    return value.decode("utf-8") if isinstance(value, bytes) else value


class Subscriber(object):
    def __init__(self, signal):
        self.signal = signal


class Memory(object):
    def __init__(self, notes, make_signal):
        self._notes = notes
        self._make_signal = make_signal
        self._subscribers = {}
        self._opened = threading.Condition()
        self.listening = False
        self.times_opened = 0

    def wait_until_it_listens(self, times=0, seconds=20.0):
        """Wait until it listens, and has begun to do so more than so many times."""
        until = time.time() + seconds
        with self._opened:
            while not self.listening or self.times_opened <= times:
                self._opened.wait(0.5)
                if time.time() > until:
                    raise AssertionError(
                        "It does not listen:\n" + "\n".join(self._notes.lines[-30:])
                    )

    def subscriber(self, event):
        event = text(event)
        if event not in self._subscribers:
            self._subscribers[event] = Subscriber(self._make_signal("(m)"))
        return self._subscribers[event]

    def raiseEvent(self, event, value):
        if text(event) == "CAIR/Listening":
            self._listens(bool(value))
        else:
            self._notes.add("event: %s %s", event, value)
        self.subscriber(event).signal(value)

    def _listens(self, listening):
        with self._opened:
            self.times_opened += listening and not self.listening
            self.listening = listening
            self._opened.notify_all()

    def insertData(self, name, value):
        if text(value) != "{}":
            self._notes.add("memory: %s = %s", name, value)
