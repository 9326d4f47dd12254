"""The ROS 1 node on a real roscore, against a real server: another node talks with it."""

import json

import pytest

from tests.clients.ros.conftest import ROS1
from tests.server.conftest import wait_for

pytestmark = pytest.mark.server
PERFORMED = ("reply", "speech", "plan")


def heard(peer, sentence, count):
    """Let the node hear a sentence; return so many events that follow."""
    after = len(peer.events)
    peer.tell("hear", sentence)
    return peer.next(count, PERFORMED, after)


def sentences(events):
    return [one["text"] for one in events if one["kind"] == "speech"]


def test_the_robot_greets_as_soon_as_somebody_listens(peer, node):
    spoken = peer.next(1, ("speech",), 0)[0]["text"]
    first = peer.next(1, ("reply",), 0)[0]
    assert first["heard"] == ""
    assert first["dialogue_sentence"].startswith(spoken)
    assert "Anna" in spoken


def test_a_sentence_heard_is_answered_and_its_plan_published_in_order(peer, node):
    events = heard(peer, "Play the song Hey Brother", 4)
    by_kind = {one["kind"]: one for one in events}
    reply, plan = by_kind["reply"], by_kind["plan"]
    assert plan["action"] == ["playsong", {"title": "Hey Brother"}]
    assert reply["actions"] == [plan["action"]]
    assert reply["heard"] == "Play the song Hey Brother"
    assert sentences(events) == [reply["plan_sentence"], reply["dialogue_sentence"]]


def test_a_greeting_is_an_action_of_its_own(peer, node):
    events = heard(peer, "Say hello to everybody", 4)
    assert ["hello", {}] in [one["action"] for one in events if one["kind"] == "plan"]


def test_a_service_answers_and_the_robot_speaks(peer, node):
    after = len(peer.events)
    said = peer.answer_to("say", "What day is it today?", False)
    assert said["actions"] == [["date", {}]]
    assert said["error"] == ""
    spoken = sentences(peer.next(4, PERFORMED, after))
    assert spoken == [said["plan_sentence"], said["dialogue_sentence"]]


def test_a_quiet_service_call_is_answered_to_the_caller_alone(peer, node):
    after = len(peer.events)
    said = peer.answer_to("say", "I love music", True)
    assert said["dialogue_sentence"]
    heard(peer, "I love tea", 2)
    assert said["dialogue_sentence"] not in sentences(peer.events[after:])


def test_the_talk_goes_over_to_italian(peer, node):
    started = peer.answer_to("start", False, "it", "IT", "Zoë")
    assert "Zoë" in started["dialogue_sentence"]
    said = peer.answer_to("say", "Suona la canzone Perché no", True)
    assert said["actions"] == [["playsong", {"title": "Perché no"}]]
    peer.answer_to("start", True, "en", "EN", "Anna")


def test_a_parameter_that_nobody_said_is_empty(peer, node):
    said = peer.answer_to("say", "Play a song", True)
    assert said["actions"] == [["playsong", {"title": ""}]]


def test_the_talk_goes_on_where_it_was_when_the_server_was_away(peer, node, network):
    before = peer.answer_to("say", "I love music", True)
    network.down()
    after = len(peer.events)
    peer.tell("hear", "Play the song Danny Boy")
    failure, waiting = peer.next(2, ("reply", "speech"), after)
    if failure["kind"] == "speech":
        failure, waiting = waiting, failure
    assert failure["error"] == "client.unreachable"
    assert waiting["text"].startswith("Just a moment")
    asked = peer.answer_to("say", "What is the time?", True)
    assert (asked["error"], asked["dialogue_sentence"]) == ("client.unreachable", "")
    network.up()
    plan = peer.next(1, ("plan",), after)[0]
    assert plan["action"] == ["playsong", {"title": "Danny Boy"}]
    answered = peer.next(2, ("reply",), after)[1]
    assert not answered["restarted"]
    assert answered["topic"] == before["topic"]


def test_a_stopped_robot_hears_nothing_until_it_is_started(peer, node):
    assert peer.answer_to("stop")["success"]
    after = len(peer.events)
    peer.tell("hear", "Play the song Volare")
    assert peer.answer_to("say", "I love music", True)["dialogue_sentence"]
    assert peer.answer_to("start", False, "", "", "")["dialogue_sentence"]
    peer.tell("hear", "I love tea")
    answered = [one["heard"] for one in peer.next(2, ("reply",), after)]
    assert answered == ["", "I love tea"]


def test_the_robot_of_the_page_speaks_and_acts(peer, node, launch, tmp_path):
    page = (ROS1.parent / "README.md").read_text(encoding="utf-8")
    (tmp_path / "robot.py").write_text(page.split("```python\n")[1].split("```")[0])
    robot = launch("/usr/bin/python3", str(tmp_path / "robot.py"))
    assert wait_for(lambda: _all_is_told(peer, robot), 30), robot.log.read_text()


def _all_is_told(peer, robot):
    """Ask for a song; say whether the robot had connected to both topics by then."""
    events = heard(peer, "Play the song Hey Brother", 4)
    lines = {f"says: {sentence}\n" for sentence in sentences(events)}
    lines.add("does: playsong {'title': 'Hey Brother'}\n")
    return wait_for(lambda: lines <= set(robot.lines), 3)


def test_the_talk_is_kept_in_the_folder_of_ros(peer, node, workspace):
    kept = json.loads((workspace / "ros_home" / "cair_talk.json").read_text())
    assert kept["dialogue_state"]
    assert node.running()
