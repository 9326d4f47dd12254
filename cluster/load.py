"""Steady load: people who talk through the load balancer, and whose states must go on.

No turn is sent twice by us: what the load balancer does not mend counts as failed.
"""

import http.client
import json
import threading
import time
from dataclasses import dataclass, field

from cluster.talks import SENTENCES

TIMEOUT = 20.0
#: After so many turns the state is looked into.
INSPECT_EVERY = 5
LONGEST_TALK = 40


@dataclass(frozen=True, slots=True)
class Sample:
    """One turn: when it ended (monotonic clock), how long it took, and what was wrong, if so."""

    ended: float
    seconds: float
    fault: str = ""


@dataclass
class Talker:
    """One person: talks one after another, each with a seed and turns that are counted."""

    port: int
    number: int
    every: float
    stop: threading.Event
    samples: list[Sample] = field(default_factory=list)
    #: When, and what a state should have been and was.
    broken: list[tuple[float, str]] = field(default_factory=list)
    inspected: int = 0
    _talk: int = 0
    _turn: int = 0
    _state: str = ""
    _connection: http.client.HTTPConnection | None = None

    def talk(self) -> None:
        """Take turns at a steady rate until told to stop; the last state is looked into."""
        due = time.monotonic() + self.every * (self.number % 10) / 10
        while not self.stop.wait(max(0.0, due - time.monotonic())):
            due = max(due + self.every, time.monotonic())
            self._take_turn()
        if self._state:
            self._inspect()
        self._hang_up()

    @property
    def seed(self) -> int:
        """Return the seed of the talk that is going on."""
        return 1 + self.number * 1000 + self._talk

    @property
    def language(self) -> str:
        """Return the language of the talk that is going on."""
        return list(SENTENCES)[(self.number + self._talk) % len(SENTENCES)]

    def _take_turn(self) -> None:
        sentences = SENTENCES[self.language]
        wish: dict[str, object] = {
            "client_sentence": sentences[(self._turn + self.number) % len(sentences)]
        }
        if self._state:
            wish["dialogue_state"] = self._state
        else:
            wish |= {"language": self.language, "seed": self.seed}
        began = time.monotonic()
        said, fault = self._ask("hub", wish)
        self._sample(began, fault)
        if fault:
            return
        self._state, self._turn = str(said["dialogue_state"]), self._turn + 1
        if self._turn % INSPECT_EVERY == 0:
            self._inspect()
        if self._turn == LONGEST_TALK:
            self._talk, self._turn, self._state = self._talk + 1, 0, ""

    def _inspect(self) -> None:
        """Compare what the state says of itself with what it must say."""
        began = time.monotonic()
        said, fault = self._ask("dialogue/inspect", {"dialogue_state": self._state})
        if fault:
            self._sample(began, f"inspect: {fault}")
            return
        self.inspected += 1
        must = (self._turn, self.seed, self.language)
        seen = (said["turn"], said["seed"], said["language"])
        if seen != must:
            told = f"talker {self.number}: {seen} instead of {must}"
            self.broken.append((time.monotonic(), told))

    def _sample(self, began: float, fault: str) -> None:
        now = time.monotonic()
        self.samples.append(Sample(now, now - began, fault))

    def _ask(self, service: str, wish: dict[str, object]) -> tuple[dict[str, object], str]:
        """Return the answer and what is wrong with it, "" where nothing is."""
        if self._connection is None:
            self._connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=TIMEOUT)
        body = json.dumps(wish, ensure_ascii=False).encode()
        try:
            self._connection.request("POST", f"/api/v1/{service}/", body)
            answer = self._connection.getresponse()
            text = answer.read()
            said = json.loads(text) if answer.status == http.HTTPStatus.OK else {}
        except (OSError, http.client.HTTPException, ValueError) as error:
            self._hang_up()
            return {}, repr(error)
        if answer.status != http.HTTPStatus.OK:
            return {}, f"{answer.status} {text[:200]!r}"
        if service == "hub" and not (said["dialogue_sentence"] or said["plan_sentence"]):
            return {}, "nothing was said"
        return said, ""

    def _hang_up(self) -> None:
        if self._connection:
            self._connection.close()
        self._connection = None


@dataclass(frozen=True, slots=True)
class Counted:
    """The turns of some stretch of time; seconds are those of a turn."""

    turns: int
    failed: int
    not_continued: int
    median: float
    p99: float
    slowest: float
    faults: tuple[str, ...] = ()


class Load:
    """Talkers, each in a thread, at so many turns a second together."""

    def __init__(self, port: int, talkers: int, a_second: float) -> None:
        self._stop = threading.Event()
        self.talkers = [
            Talker(port, number, talkers / a_second, self._stop) for number in range(talkers)
        ]
        self._threads = [threading.Thread(target=one.talk) for one in self.talkers]

    def __enter__(self) -> "Load":
        for thread in self._threads:
            thread.start()
        return self

    def __exit__(self, *_error: object) -> None:
        self.end()

    def end(self) -> None:
        """Stop talking; the turns that have begun are ended, and all last states looked into."""
        self._stop.set()
        for thread in self._threads:
            if thread.is_alive():
                thread.join()

    def counted(self, since: float, until: float) -> Counted:
        """Return what happened between two moments of the monotonic clock."""
        samples = [
            one
            for talker in self.talkers
            for one in list(talker.samples)
            if since <= one.ended < until
        ]
        broken = [
            text
            for talker in self.talkers
            for when, text in list(talker.broken)
            if since <= when < until
        ]
        times = sorted(one.seconds for one in samples)
        faults = [one.fault for one in samples if one.fault]
        return Counted(
            turns=len(samples) - len(faults),
            failed=len(faults),
            not_continued=len(broken),
            median=share_of(times, 0.5),
            p99=share_of(times, 0.99),
            slowest=times[-1] if times else 0.0,
            faults=tuple([*faults, *broken][:5]),
        )

    def forget(self, before: float) -> None:
        """Forget the turns before a moment: our own memory must not grow for hours."""
        for talker in self.talkers:
            old = sum(one.ended < before for one in talker.samples)
            del talker.samples[:old]

    def inspected(self) -> int:
        """Return how many states were looked into."""
        return sum(talker.inspected for talker in self.talkers)


def share_of(ordered: list[float], share: float) -> float:
    """Return the value that this share of the values does not exceed, 0 without any."""
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))] if ordered else 0.0
