"""The ROS 2 node on a stub of rclpy, against a real server. It has not been run on ROS 2."""

import importlib
import sys
from types import SimpleNamespace

import pytest

from tests.clients.ros.conftest import ROS2
from tests.clients.ros.rclpy_stub import Node, rclpy_stub
from tests.server.conftest import wait_for

PACKAGE = ROS2 / "cair_ros2"
pytestmark = pytest.mark.server


@pytest.fixture
def run(server, tmp_path, monkeypatch):
    """Return a function that runs main() and lets a test drive the node meanwhile."""
    monkeypatch.syspath_prepend(str(PACKAGE))
    kept = str(tmp_path / "{name}.json")
    base = {"server": f"http://127.0.0.1:{server.port}", "state_file": kept, "seed": 7}

    def main(drive, **given):
        monkeypatch.setattr(Node, "given", {**base, **given})
        with rclpy_stub(ROS2 / "cair_interfaces", drive):
            try:
                importlib.import_module("cair_ros2.node").main()
            finally:
                for name in [name for name in sys.modules if name.startswith("cair_ros2")]:
                    del sys.modules[name]

    return main


def performed(node):
    """Return what was published, by topic."""
    plain = {topic.strip("~/"): one.published for topic, one in node.publishers.items()}
    return SimpleNamespace(**plain)


def test_it_greets_hears_a_sentence_and_publishes_the_plan(run, tmp_path):
    def drive(node):
        out = performed(node)
        assert wait_for(lambda: out.speech, 20)
        assert "Anna" in out.speech[0].data
        node.send("~/heard", data="Play the song Hey Brother")
        assert wait_for(lambda: len(out.speech) == 3, 20)
        (action,) = out.plan
        assert (action.name, action.keys, action.values) == ("playsong", ["title"], ["Hey Brother"])
        assert out.reply[1].plan_sentence == out.speech[1].data
        assert out.reply[1].actions[0].name == "playsong"

    run(drive, person="Anna", language="en")
    assert (tmp_path / "cair.json").exists()


def test_its_services_answer(run):
    def drive(node):
        started = node.ask("~/start", afresh=True, language="it", culture="IT", person="Zoë").reply
        assert "Zoë" in started.dialogue_sentence
        reply = node.ask("~/say", sentence="Suona una canzone", quiet=True).reply
        assert [(one.name, one.values) for one in reply.actions] == [("playsong", [""])]
        assert node.ask("~/stop").success
        node.send("~/done")

    run(drive, greet=False)


def test_it_plans_only_what_the_robot_can_do(run):
    def drive(node):
        reply = node.ask("~/say", sentence="Give me a hug", quiet=True).reply
        assert reply.actions == []
        assert reply.plan_sentence

    run(drive, greet=False, capabilities="playsong, hello", language="en")


def test_it_survives_a_server_that_is_away(run):
    def drive(node):
        out = performed(node)
        node.send("~/heard", data="Hello")
        assert wait_for(lambda: out.speech, 20)
        assert out.reply[0].error == "client.unreachable"
        reply = node.ask("~/say", sentence="Hello").reply
        assert (reply.error, reply.heard) == ("client.unreachable", "Hello")

    run(drive, greet=False, server="http://127.0.0.1:9", patience=0.0)


def test_an_address_that_is_none_ends_it_with_the_reason(run):
    with pytest.raises(SystemExit, match=r"client\.address"):
        run(lambda node: None, server="cair")
