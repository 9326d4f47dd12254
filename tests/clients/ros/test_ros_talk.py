"""The talk of the ROS nodes, without ROS: what goes out, in which order, whatever comes in."""

import importlib.util
import logging
import sys
from pathlib import Path

import pytest

from tests.clients.conftest import DOWN, answered
from tests.clients.ros.conftest import ROS1
from tests.server.conftest import wait_for


def load(package, folder):
    """Import a package of a node from its folder."""
    if package not in sys.modules:
        spec = importlib.util.spec_from_file_location(package, Path(folder) / "__init__.py")
        sys.modules[package] = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(sys.modules[package])
    return importlib.import_module(f"{package}.talk"), importlib.import_module(
        f"{package}.cair_client"
    )


class Out:
    """Writes down what a node would publish."""

    def __init__(self):
        self.log = []

    def reply(self, heard, reply):
        self.log.append(("reply", heard))

    def failure(self, heard, error):
        self.log.append(("failure", error.code))

    def speech(self, text):
        self.log.append(("speech", text))

    def action(self, action):
        self.log.append(("plan", action.name))

    def has(self, count):
        return wait_for(lambda: len(self.log) >= count, 30)


@pytest.fixture
def out():
    return Out()


@pytest.fixture
def talk_to(hub, out, monkeypatch):
    """Return a function that makes a talk with the made-up server."""
    talk, client = load("cair_ros", ROS1 / "src" / "cair_ros")
    made = []

    def make(step_seconds=0.0, **settings):
        settings = {"patience": 0.0, **settings}
        conversation = client.Conversation("http://robot.example", transport=hub, **settings)
        made.append(talk.Talk(conversation, out, logging.getLogger("test"), step_seconds))
        return made[-1]

    yield make
    for one in made:
        one.end()


def test_a_plan_stands_between_its_two_sentences(talk_to, hub, out):
    talk = talk_to()
    talk.say("hello", quiet=True)
    hub.next.append(hub.plan("hug", "playsong"))
    talk.hear("hug me and play")
    assert out.has(5)
    assert out.log == [
        ("reply", "hug me and play"),
        ("speech", "Gladly."),
        ("plan", "hug"),
        ("plan", "playsong"),
        ("speech", "And so on."),
    ]


def test_an_alert_comes_before_all_words_and_waits_for_nobody(talk_to, hub, out):
    talk = talk_to(step_seconds=60)
    talk.say("hello", quiet=True)
    hub.next.append(hub.plan("alert"))
    talk.hear("help")
    assert out.has(3)
    assert out.log[1:3] == [("plan", "alert"), ("speech", "Gladly.")]


def test_each_step_waits_until_the_one_before_is_done(talk_to, hub, out):
    talk = talk_to(step_seconds=60)
    talk.say("hello", quiet=True)
    hub.next.append(hub.plan("hug"))
    talk.hear("hug me")
    for count, last in ((2, "Gladly."), (3, "hug"), (4, "And so on.")):
        assert out.has(count)
        assert out.log[-1][1] == last
        talk.done()


def test_stop_breaks_off_what_is_performed_and_forgets_what_waits(talk_to, hub, out):
    talk = talk_to(step_seconds=60)
    talk.say("hello", quiet=True)
    hub.next.append(hub.plan("hug"))
    talk.hear("hug me")
    talk.hear("and this")
    assert out.has(2)
    talk.stop()
    talk.hear("nobody hears this")
    talk.start()
    assert out.has(4)
    assert [kind for kind, _ in out.log] == ["reply", "speech", "reply", "speech"]
    assert ("reply", "nobody hears this") not in out.log


def test_a_sentence_waits_for_a_server_that_is_away_and_is_answered_then(talk_to, hub, out):
    talk = talk_to(language="it")
    talk.say("ciao", quiet=True)
    hub.next.extend([DOWN, DOWN])
    talk.hear("mi piace il tè")
    assert out.has(4)
    assert out.log == [
        ("failure", "client.unreachable"),
        ("speech", "Solo un momento, per favore. Raccolgo le idee e poi ti rispondo."),
        ("reply", "mi piace il tè"),
        ("speech", "You said mi piace il tè."),
    ]


def test_a_refused_sentence_is_said_to_be_trouble_and_the_talk_goes_on(talk_to, hub, out):
    talk = talk_to()
    talk.say("hello", quiet=True)
    hub.next.append(answered({"error": {"code": "key.missing", "message": "A key."}}, 401))
    talk.hear("hello")
    talk.hear("again")
    assert out.has(4)
    assert out.log[0] == ("failure", "key.missing")
    assert out.log[-1] == ("speech", "You said again.")


def test_who_speaks_before_the_robot_has_greeted_is_answered(talk_to, out):
    talk = talk_to()
    talk.begin(lambda: False)
    talk.hear("good morning")
    assert out.has(2)
    assert out.log == [("reply", "good morning"), ("speech", "You said good morning.")]


def test_a_start_in_a_language_that_is_refused_leaves_the_talk_as_it_was(talk_to, hub):
    talk = talk_to(language="en")
    talk.say("hello", quiet=True)
    hub.next.append(answered({"error": {"code": "language.unknown", "message": "No."}}, 400))
    with pytest.raises(Exception, match=r"language\.unknown"):
        talk.start(language="xx")
    talk.say("hello", quiet=True)
    assert [method for method, _, _ in hub.asked] == ["GET", "POST", "GET", "POST"]


def test_a_blank_is_neither_answered_nor_published(talk_to, hub, out):
    talk = talk_to()
    talk.hear("  ")
    assert talk.say("").text == ""
    talk.say("tea")
    assert out.has(2)
    assert out.log[0] == ("reply", "tea")
