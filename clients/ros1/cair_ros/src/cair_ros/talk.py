# -*- coding: utf-8 -*-
"""The talk of a node, without ROS: sentences in, sentences and actions out in their order."""

from __future__ import absolute_import, unicode_literals

import functools
import threading

from .cair_client import AT_ONCE, SILENCE, CairError, UnreachableError

try:
    from queue import Empty, Queue
except ImportError:  # Python 2.7
    from Queue import Empty, Queue

MOST_WAITING = 5  # heard sentences that wait for their answer
LONGEST_PAUSE = 15.0  # seconds between two attempts while the server is away

#: Said by the robot itself, once, while there is no answer.
WAIT = {
    "en": "Just a moment, please. I am collecting my thoughts, and then I will answer you.",
    "it": "Solo un momento, per favore. Raccolgo le idee e poi ti rispondo.",
    "ja": "少しだけお待ちくださいね。考えをまとめたら、お返事します。",
}
TROUBLE = {
    "en": "I am sorry, something is wrong with me. Please tell whoever looks after me.",
    "it": "Mi dispiace, ho un problema. Per favore, dillo a chi si occupa di me.",
    "ja": "すみません、調子が良くないようです。私の担当の方に伝えていただけますか。",
}


class Talk(object):
    """A talk that goes on whatever happens to the network.

    conversation -- a Conversation.
    out -- where it goes: out.reply(heard, reply), out.failure(heard, error), out.speech(text) and
        out.action(action), called on one thread.
    log -- has info(), warning(), error().
    step_seconds -- how long to wait after each sentence and action for done(); 0: not at all.
    """

    def __init__(self, conversation, out, log, step_seconds=0.0):
        self._conversation = conversation
        self._out = out
        self._log = log
        self._step_seconds = step_seconds
        self._jobs = Queue()
        self._waiting = 0
        self._lock = threading.Lock()
        self._hearing = True
        self._run = 0  # what was heard or answered before the last stop() has an older number
        self._performed = 0  # the number of what is performed now
        self._done = threading.Event()
        self._ended = threading.Event()
        conversation.on("*", self._act)
        self._thread = threading.Thread(target=self._work, name=str("cair_talk"))
        self._thread.daemon = True
        self._thread.start()

    # What may be asked of it, from any thread

    def begin(self, somebody_listens):
        """Say the first sentence as soon as somebody listens, unless the talk begins otherwise."""
        self._leave(lambda run: self._begin_for(somebody_listens, run))

    def hear(self, sentence):
        """Answer a sentence when its turn comes, however long the server is away."""
        if not self._hearing or not sentence.strip():
            return
        with self._lock:
            crowded = self._waiting >= MOST_WAITING
            self._waiting += not crowded
        if crowded:
            self._log.warning("Too much at once: a sentence was not heard.")
            return
        self._leave(lambda run: self._answer_heard(sentence, run))

    def say(self, sentence, quiet=False):
        """Return the reply at once, and perform it unless `quiet`. Raises CairError."""
        reply = self._conversation.say(sentence)
        if not quiet and reply is not SILENCE:
            self._leave(lambda run: self._perform(sentence, reply, run))
        return reply

    def start(self, afresh=False, language="", culture="", person=""):
        """Return the first sentence and perform it, forget what waits, hear again.

        "" leaves language, culture or person as it is. Raises CairError.
        """
        talk = self._conversation
        before = talk.language, talk.culture, talk.person
        talk.language, talk.culture = language or talk.language, culture or talk.culture
        talk.person = person or talk.person
        try:
            reply = talk.start(afresh)
        except CairError:
            talk.language, talk.culture, talk.person = before
            raise
        self._forget()
        self._hearing = True
        self._leave(lambda run: self._perform("", reply, run))
        return reply

    def stop(self):
        """Forget what waits, break off what is performed, hear nothing until start()."""
        self._hearing = False
        self._forget()

    def done(self):
        """Go on to the next sentence or action."""
        self._done.set()

    def end(self):
        """End the thread."""
        self.stop()
        self._ended.set()

    def _forget(self):
        with self._lock:
            self._run += 1
        self._done.set()

    # On its own thread

    def _leave(self, job):
        run = self._run
        self._jobs.put(lambda: job(run))

    def _work(self):
        while not self._ended.is_set():
            try:
                job = self._jobs.get(timeout=0.5)
            except Empty:
                continue
            try:
                job()
            except Exception as error:  # noqa: BLE001 - a fault of ours must not end the talk
                self._log.error("A turn was lost: %r" % (error,))

    def _begin_for(self, somebody_listens, run):
        def wanted():
            return self._goes_on(run) and self._jobs.empty()

        while wanted() and not somebody_listens():
            self._ended.wait(0.1)
        self._answer("", self._conversation.start, run, wanted)

    def _answer_heard(self, sentence, run):
        with self._lock:
            self._waiting -= 1
        wanted = functools.partial(self._goes_on, run)
        self._answer(sentence, lambda: self._conversation.say(sentence), run, wanted)

    def _answer(self, heard, call, run, wanted):
        """Perform the reply. While the server is away, say so once and keep trying."""
        told, pause = False, 0.5
        while wanted():
            try:
                reply = call()
            except UnreachableError as error:
                self._log.warning("%s: %s" % (error.code, error.message))
                if not told:
                    told = True
                    self._fail(heard, error, WAIT)
                self._ended.wait(pause)
                pause = min(2 * pause, LONGEST_PAUSE)
            except CairError as error:
                self._log.error("%s: %s" % (error.code, error.message))
                self._fail(heard, error, TROUBLE)
                return
            else:
                self._perform(heard, reply, run)
                return

    def _fail(self, heard, error, told):
        self._out.failure(heard, error)
        language = (self._conversation.language or "en").replace("_", "-").split("-")[0].lower()
        self._out.speech(told.get(language, told["en"]))

    def _perform(self, heard, reply, run):
        if not self._goes_on(run):
            return
        self._performed = run
        self._out.reply(heard, reply)
        self._conversation.perform(reply, self._speak)

    def _speak(self, text):
        if self._goes_on(self._performed):
            self._step(lambda: self._out.speech(text))

    def _act(self, action):
        if action.name in AT_ONCE:
            self._out.action(action)
        elif self._goes_on(self._performed):
            self._step(lambda: self._out.action(action))

    def _step(self, publish):
        self._done.clear()
        publish()
        if self._step_seconds > 0 and self._goes_on(self._performed):
            self._done.wait(self._step_seconds)

    def _goes_on(self, run):
        return run == self._run and not self._ended.is_set()
