# -*- coding: utf-8 -*-
"""The robot: hears a sentence, has it answered, says and does what it was answered, and again."""

from __future__ import unicode_literals

import datetime
import logging
import random
import threading

from cair_client import CairError, Conversation, UnreachableError
from cair_pepper.body import Body
from cair_pepper.ears import Hearing
from cair_pepper.labels import label
from cair_pepper.people import People
from cair_pepper.places import Places
from cair_pepper.services import Services, UnableError
from cair_pepper.skills import all_skills
from cair_pepper.tablet import DIALOGUE, EXECUTION, Tablet
from cair_pepper.voice import Voice

try:
    from queue import Empty, Full, Queue  # novermin
except ImportError:  # Python 2.7
    from Queue import Empty, Full, Queue  # novermin

_log = logging.getLogger(__name__)

HEAD = ("FrontTactilTouched", "MiddleTactilTouched", "RearTactilTouched")
MOST_WAITING = 5  # sentences that wait for their answer
LONGEST_PAUSE = 15.0  # seconds between two attempts while the network is away


class Robot(object):
    """Pepper or NAO in a talk.

    session -- a connected qi.Session. settings -- of read_settings().
    now, chance -- the clock and the dice. talk_with -- makes the Conversation.
    """

    def __init__(self, session, settings, now=None, chance=None, talk_with=Conversation):
        self._settings = settings
        self._services = Services(session)
        self._voice = Voice(self._services, settings)
        self._tablet = Tablet(self._services, settings["tablet_pages"])
        self._hearing = Hearing(self._services, settings, self._heard)
        self._places = Places(settings["folder"], self._services)
        self._people = People(settings["folder"], settings["person"])
        self._inbox = Queue(MOST_WAITING)
        self._answers = None  # a queue, while a question of our own is open
        self._busy = False
        self._paused = False
        self._new_person = None
        self._ended = threading.Event()
        self._forget = []
        self._timers = []
        self._talk_with = talk_with
        self._body = self._made_body(now or datetime.datetime.now, chance or random.Random())
        self._skills = all_skills(self._body)
        self._talk, self._first_time = self._made_talk(self._people.present())

    def run(self):
        """Talk until end() is called."""
        try:
            with self._hearing.deaf():
                self._prepare()
                self._begin()
            while not self._ended.is_set():
                try:
                    self._next(self._inbox.get(timeout=0.5))
                except Empty:
                    continue
                except Exception:  # noqa: BLE001 - logged; a fault of ours must not end the talk
                    _log.exception("A turn was lost.")
        finally:
            self._close()

    def end(self):
        """Let run() return; may be called from any thread."""
        self._ended.set()
        self._body.touched.set()

    def able(self):
        """Return the actions the robot can do at this moment."""
        return sorted(name for name, skill in self._skills.items() if skill.able())

    # Preparing

    def _made_body(self, now, chance):
        body = Body(self._services, self._settings, self._voice, self._tablet, self._places)
        body.say, body.ask, body.later, body.meet = self._say, self._ask, self._later, self._meet
        body.now, body.chance = now, chance
        return body

    def _made_talk(self, person):
        settings = self._settings
        kept = self._people.talk_file(person)
        settings["person"] = person
        talk = self._talk_with(
            settings["server"],
            language=settings["language"],
            culture=settings["culture"] or None,
            state_file=kept,
            person=person or None,
            key=settings["key"] or None,
            ca_file=settings["ca_file"] or None,
            seed=int(settings["seed"]) or None,
            patience=settings["patience"],
            capabilities=_Able(self),
        )
        for name, skill in self._skills.items():
            talk.on(name, self._handler(name, skill))
        return talk, not self._people.has_talked(person)

    def _prepare(self):
        if self._settings["autonomous_life"]:
            life = self._settings["autonomous_life"]
            self._services.quietly("ALAutonomousLife", "setState", life)
            self._services.quietly("ALMotion", "wakeUp")
            self._services.quietly("ALBasicAwareness", "setEnabled", True)
        self._voice.prepare()
        self._places.load()
        for event in HEAD:
            self._forget.append(self._services.listen(event, self._on_touch))
        self._hearing.open()
        self._tablet.show(DIALOGUE, self._settings["robot_name"])

    def _close(self):
        for timer in self._timers:
            timer.cancel()
        for forget in self._forget:
            forget()
        self._hearing.close()
        self._tablet.hide()

    # The talk

    def _begin(self):
        introduction = self._body.text("i_am", robot=self._settings["robot_name"])
        reply = self._answered(self._talk.start)
        if reply is None:
            return
        if self._first_time and self._settings["robot_name"]:
            self._say(introduction)
        self._first_time = False
        self._perform(reply)

    def _next(self, item):
        """Answer a sentence, or do what a timer or a touch has left to be done."""
        if callable(item):
            item()
            return
        _log.info("hears a sentence")
        reply = self._answered(lambda: self._talk.say(item))
        if reply is not None:
            self._perform(reply)
        if self._new_person is not None:
            person, self._new_person = self._new_person, None
            self._people.keep(person)
            self._talk, self._first_time = self._made_talk(person)
            self._first_time = False  # they have just met
            self._begin()

    def _answered(self, call):
        """Return the reply. While the network is away it says so once and keeps trying."""
        told, pause = False, 0.5
        while not self._ended.is_set():
            try:
                return call()
            except UnreachableError as error:
                _log.warning("%s", error)
                if not told:
                    told = True
                    self._say(self._body.text("wait"))
                self._ended.wait(pause)
                pause = min(2 * pause, LONGEST_PAUSE)
            except CairError as error:
                _log.error("%s", error)
                self._say(self._body.text("trouble"))
                return None
        return None

    def _perform(self, reply):
        self._body.touched.clear()
        with self._hearing.deaf():
            self._busy = True
            try:
                self._talk.perform(reply, self._say_unless_touched)
            finally:
                self._busy = False
                self._tablet.show(DIALOGUE, self._settings["robot_name"])

    def _handler(self, name, skill):
        """Return the handler of an action: whatever happens, the talk goes on."""

        def handler(action):
            if self._body.touched.is_set():
                return None
            _log.info("action: %s", name)
            self._tablet.show(EXECUTION, label(name, self._settings["language"]))
            try:
                told = skill.do(action.parameters)
            except UnableError as unable:
                _log.warning("%s was not done: %s", name, unable)
                told = self._body.text("not_now")
            except Exception:  # noqa: BLE001 - logged; a fault of a skill must not end the talk
                _log.exception("%s was not done.", name)
                told = self._body.text("not_now")
            return told

        return handler

    def _say_unless_touched(self, text):
        if not self._body.touched.is_set() and self._new_person is None:
            self._say(text)

    def _say(self, text):
        with self._hearing.deaf():
            try:
                self._voice.say(text)
            except UnableError as unable:
                _log.error("Not said: %s", unable)

    # What comes from outside, on threads of NAOqi's

    def _heard(self, sentence):
        if self._answers is not None:
            self._answers.put(sentence)
        elif self._paused:
            _log.info("Not heard: it was told to be quiet.")
        else:
            self._leave(sentence)

    def _leave(self, item):
        try:
            self._inbox.put_nowait(item)
        except Full:
            _log.warning("Too much at once: something was not heard.")

    def _on_touch(self, value):
        if not value:
            return
        if self._body.looks_away:
            _log.info("touched: turns back")
            self._body.touched.set()
        elif self._busy:
            _log.info("touched: stops")
            # Not here: NAOqi's thread must be free to bring the end of what is stopped.
            threading.Thread(target=self._body.stop).start()
        else:
            self._pause_or_go_on()

    def _pause_or_go_on(self):
        self._paused = not self._paused
        _log.info("touched: %s", "pauses" if self._paused else "goes on")
        told = self._body.text("paused" if self._paused else "resumed")
        self._leave(lambda: self._say(told))

    # What skills may ask for

    def _ask(self, question):
        """Say a question; return the answer, None where none comes in time."""
        self._say(question)
        self._answers = answers = Queue()
        waited = 0.0
        try:
            with self._hearing.listening():
                while waited < self._settings["answer_seconds"] and not self._body.touched.is_set():
                    try:
                        return answers.get(timeout=0.2)
                    except Empty:
                        waited += 0.2
        finally:
            self._answers = None
        return None

    def _later(self, seconds, name, **filled):
        told = self._body.text(name, **filled)
        timer = threading.Timer(seconds, lambda: self._leave(lambda: self._say(told)))
        timer.daemon = True
        timer.start()
        self._timers = [one for one in self._timers if one.is_alive()] + [timer]

    def _meet(self, person):
        self._new_person = person


class _Able(object):
    """The capabilities, looked at anew on each turn: behaviours come and go."""

    def __init__(self, robot):
        self._robot = robot

    def __iter__(self):
        return iter(self._robot.able())
