"""leave: the person does not want to talk about something."""

import pytest

from dialogue.engine.actions.leave import STAY_OUT
from tests.engine.dialogue.talk import act, hear, kinds_said, mrs_smith, node
from tests.engine.dialogue.world import NUMBERS

FOOD = NUMBERS["FoodAndDrink"]


def test_the_current_topic_is_left_and_stays_out():
    before = mrs_smith("Tea", ordering="wc")
    reply = hear(before, "Not this", act("leave"))
    assert kinds_said(before, reply)[:1] == ["leave"]
    assert node(reply.topic).branch != FOOD
    assert reply.state.avoided == ((NUMBERS["Tea"], 6 + STAY_OUT),)


def test_a_branch_stays_out_for_twenty_turns():
    reply = hear(mrs_smith("Tea"), "No food please", act("leave", topic="food and drink"))
    seen = set()
    for _ in range(STAY_OUT):
        reply = hear(reply.state, "Something else please", act("change"))
        seen.add(node(reply.topic).branch)
    assert seen
    assert FOOD not in seen
    assert not hear(reply.state, "Well").state.avoids((FOOD,))


def test_the_persons_own_words_open_it_again():
    left = hear(mrs_smith("Tea"), "No tea", act("leave", topic="tea"))
    assert hear(left.state, "Some tea after all").topic == "Tea"


def test_to_avoid_something_else_does_not_end_the_topic():
    before = mrs_smith("Tea", ordering="wc")
    reply = hear(before, "Never talk of the piano", act("leave", topic="piano"))
    assert kinds_said(before, reply) == ["leave", "w"]
    assert reply.topic == "Tea"


@pytest.mark.parametrize("topic", ["Grief", "Funerals", "OnYourMind"])
@pytest.mark.parametrize("words", [None, "grief", "funerals", "piano", "submarines"])
@pytest.mark.parametrize("last_type", ["c", "e"])
def test_a_hard_subject_is_left_whatever_is_named(topic, words, last_type):
    before = mrs_smith(topic, ordering="wc", last_type=last_type)
    reply = hear(before, "Not this", act("leave", topic=words))
    assert kinds_said(before, reply)[0] == ("change_asked" if words == "submarines" else "leave")
    assert not node(reply.topic).gentle
    assert node(reply.topic).branch != NUMBERS["Life"]


def test_from_elsewhere_a_hard_subject_is_only_avoided():
    before = mrs_smith("Tea", ordering="wc")
    reply = hear(before, "No funerals", act("leave", topic="funerals"))
    assert (reply.topic, kinds_said(before, reply)) == ("Tea", ["leave", "w"])
    assert reply.state.avoided == ((NUMBERS["Funerals"], 6 + STAY_OUT),)


def test_where_nothing_known_is_named_the_subject_changes():
    before = mrs_smith("Tea", ordering="wc")
    reply = hear(before, "No submarines", act("leave", topic="submarines"))
    assert kinds_said(before, reply)[0] == "change_asked"
    assert reply.topic != "Tea"
    assert reply.state.avoided == ()


def test_what_the_plan_said_is_not_said_again():
    before = mrs_smith("Tea", ordering="wc")
    reply = hear(before, "Not this", act("leave"), plan_said=True)
    assert "leave" not in kinds_said(before, reply)
    assert reply.state.avoided


def test_before_any_topic_there_is_none_to_leave():
    before = mrs_smith()
    reply = hear(before, "Not this", act("leave"))
    assert kinds_said(before, reply) == ["change_asked", "q"]
