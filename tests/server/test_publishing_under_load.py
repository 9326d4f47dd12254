"""Experts publish and roll back while people talk: no turn fails, and every talk goes on."""

import http.client
import json
import shutil
import threading
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

import pytest

from tests.server.conftest import Server, manage, start_server, wait_for

THREADS, A_SECOND, SECONDS = 8, 200, 6.0
SENTENCES = ("I love music", "yes", "no", "play Hey Brother", "mmm", "let us talk about food")
CHANGE = """
from dialogue.models import Sentence
row = Sentence.objects.filter(language="en", frame__pool="start").first()
row.text = "Hello, this is new."
row.save()
from dialogue.publishing import publish
print(publish(note="new").pk)
"""


@dataclass
class Talker:
    """One person who talks without a pause, on one connection."""

    port: int
    stop: threading.Event
    turns: int = 0
    state: str = ""
    faults: list[str] = field(default_factory=list)

    def talk(self) -> None:
        """Take turns, at this talker's share of the requests, until told to stop."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=20)
        due = time.monotonic()
        while not self.stop.is_set():
            due += THREADS / A_SECOND
            try:
                self._turn(connection)
            except (OSError, http.client.HTTPException, KeyError, ValueError) as error:
                self.faults.append(repr(error))
                connection.close()
            time.sleep(max(0.0, due - time.monotonic()))
        connection.close()

    def _turn(self, connection: http.client.HTTPConnection) -> None:
        wish = {"client_sentence": SENTENCES[self.turns % len(SENTENCES)]}
        body = json.dumps(wish | ({"dialogue_state": self.state} if self.state else {}))
        connection.request("POST", "/api/v1/hub/", body)
        answer = connection.getresponse()
        said = json.loads(answer.read())
        if answer.status != 200 or not said["dialogue_sentence"]:
            self.faults.append(f"{answer.status} {said}")
            return
        self.turns, self.state = self.turns + 1, said["dialogue_state"]


@dataclass
class Observed:
    """What happened while people talked."""

    server: Server
    talkers: list[Talker]
    numbers: list[int]
    taken_over: list[bool]


@pytest.fixture(scope="module")
def observed(prepared: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Observed]:
    """Talk, publish something new, roll back, and stop."""
    folder = tmp_path_factory.mktemp("load")
    server = start_server(Path(shutil.copytree(prepared, folder / "var")), folder / "log")
    stop = threading.Event()
    talkers = [Talker(server.port, stop) for _ in range(THREADS)]
    threads = [threading.Thread(target=talker.talk) for talker in talkers]
    try:
        yield _observe(server, talkers, threads, stop)
    finally:
        stop.set()
        server.stop()


def _observe(
    server: Server, talkers: list[Talker], threads: list[threading.Thread], stop: threading.Event
) -> Observed:
    began = time.monotonic()
    for thread in threads:
        thread.start()
    numbers, taken_over = [], []
    for command in (("shell", "-c", CHANGE), ("publish", "--roll-back", "1")):
        manage(server.var, *command)
        numbers.append(len(numbers) + 2)
        taken_over.append(wait_for(everybody_serves(server, numbers[-1]), 30))
    stop.wait(max(0.0, began + SECONDS - time.monotonic()))
    stop.set()
    for thread in threads:
        thread.join()
    return Observed(server, talkers, numbers, taken_over)


def everybody_serves(server: Server, number: int) -> Callable[[], bool]:
    """Return a question: do twenty new connections, so both workers, serve this publication?"""
    return lambda: all(server.publication() == number for _ in range(20))


def test_no_turn_fails(observed: Observed) -> None:
    assert [talker.faults for talker in observed.talkers] == [[]] * THREADS


def test_people_talked_all_the_time(observed: Observed) -> None:
    assert all(talker.turns > 50 for talker in observed.talkers)


def test_all_workers_take_over_each_publication(observed: Observed) -> None:
    assert observed.taken_over == [True, True]


def test_every_state_goes_on(observed: Observed) -> None:
    """A state counts its turns: none was lost or begun anew."""
    for talker in observed.talkers:
        body = json.dumps({"dialogue_state": talker.state}).encode()
        seen = observed.server.ask("POST", "/api/v1/dialogue/inspect/", body).json()
        assert seen["turn"] == talker.turns


def test_a_publication_that_says_the_same_is_the_same(observed: Observed) -> None:
    manage(observed.server.var, "publish", "--roll-back", "1")
    assert wait_for(everybody_serves(observed.server, observed.numbers[-1]), 30)
