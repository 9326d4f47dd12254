"""opinion: the person asks what the agent thinks of something."""

import pytest

from tests.engine.dialogue.talk import act, hear, kinds_said, mrs_smith


def test_a_known_topic_is_spoken_of_without_a_yes_no_question():
    before = mrs_smith("Milk", siblings=2, noes=1)
    reply = hear(before, "What do you think of tea?", act("opinion", topic="tea"))
    assert kinds_said(before, reply) == ["opinion", "p", "w"]
    assert (reply.topic, reply.state.siblings, reply.state.noes) == ("Tea", 0, 0)


def test_without_a_topic_the_current_one_is_meant():
    before = mrs_smith("Tea", ordering="c")
    reply = hear(before, "What do you think?", act("opinion", topic=None))
    assert kinds_said(before, reply) == ["opinion", "p", "w"]
    assert reply.topic == "Tea"


def test_an_unknown_topic_is_asked_about():
    before = mrs_smith("Tea")
    reply = hear(before, "And submarines?", act("opinion", topic="submarines"))
    assert kinds_said(before, reply) == ["opinion", "wish"]
    assert reply.topic == "OnYourMind"


@pytest.mark.parametrize("words", ["my husband", "my wife Margaret", "my submarine"])
def test_the_agent_has_no_opinion_of_the_persons_own(words):
    before = mrs_smith("Tea")
    reply = hear(before, "And mine?", act("opinion", topic=words))
    assert kinds_said(before, reply) == ["opinion", "wish"]
    assert words.replace("my", "your") in reply.sentence
    assert (reply.topic, reply.state.ordering) == ("OnYourMind", "cwc")


def test_a_known_thing_of_theirs_is_spoken_of():
    before = mrs_smith("Tea")
    reply = hear(before, "And my milk?", act("opinion", topic="my milk"))
    assert kinds_said(before, reply) == ["opinion", "p", "w"]
    assert reply.topic == "Milk"


@pytest.mark.parametrize("words", [None, "  ", "submarines " * 10])
def test_where_there_is_nothing_to_have_an_opinion_of_the_talk_goes_on(words):
    before = mrs_smith()
    reply = hear(before, "What do you think?", act("opinion", topic=words))
    assert kinds_said(before, reply) == ["not_understood", "begin", "q"]


def test_after_a_plan_sentence_the_opinion_needs_no_introduction():
    before = mrs_smith("Milk")
    reply = hear(before, "And tea?", act("opinion", topic="tea"), plan_said=True)
    assert kinds_said(before, reply) == ["p", "w"]


def test_a_hard_subject_gets_no_opinion():
    before = mrs_smith("Tea")
    reply = hear(before, "What do you think of grief?", act("opinion", topic="grief"))
    assert (kinds_said(before, reply)[0], reply.topic) == ("c", "Grief")
