"""jump: the person brought a topic up (Algorithm 1, lines 9-14)."""

import pytest

from dialogue.engine.codec import encode
from tests.engine.dialogue.talk import act, hear, kinds_said, mrs_smith
from tests.engine.dialogue.world import NUMBERS

BEFORE = mrs_smith("Milk", siblings=2, noes=1)


def test_a_known_topic_is_begun_with_the_type_asked_for():
    reply = hear(BEFORE, "I love tea", act("jump", topic="tea", startsentence="p"))
    assert kinds_said(BEFORE, reply) == ["p", "w"]
    assert (reply.topic, reply.state.siblings, reply.state.noes) == ("Tea", 0, 0)


def test_without_a_type_the_topic_begins_with_its_first():
    reply = hear(BEFORE, "Tea", act("jump", topic="tea", startsentence=None))
    assert kinds_said(BEFORE, reply) == ["q"]


@pytest.mark.parametrize("start", ["x", "cx", "r", "wwwwwwwwwwwwwwwwwwwwwwww", "茶"])
def test_a_type_that_does_not_exist_is_passed_over(start):
    reply = hear(BEFORE, "Tea", act("jump", topic="tea", startsentence=start))
    assert kinds_said(BEFORE, reply) == ["q"]
    encode(reply.state, [b"a key of many bytes"])


def test_a_gentle_topic_is_begun_gently_whatever_was_asked_for():
    reply = hear(BEFORE, "I hate funerals", act("jump", topic="funerals", startsentence="n"))
    assert kinds_said(BEFORE, reply) == ["c"]
    assert (reply.topic, reply.state.ordering) == ("Funerals", "wc")


def test_an_unknown_topic_is_listened_to():
    reply = hear(BEFORE, "Submarines!", act("jump", topic="submarines", startsentence="q"))
    assert kinds_said(BEFORE, reply) == ["wish"]
    assert (reply.topic, reply.sentence_type) == ("OnYourMind", "e")
    assert "submarines" in reply.sentence


@pytest.mark.parametrize("words", ["my wife Margaret", "my husband", "my submarine"])
def test_people_of_theirs_and_the_unknown_are_listened_to(words):
    reply = hear(BEFORE, words, act("jump", topic=words, startsentence="q"))
    assert kinds_said(BEFORE, reply) == ["wish"]
    assert (reply.topic, reply.state.ordering) == ("OnYourMind", "cwc")
    assert words.replace("my", "your") in reply.sentence


@pytest.mark.parametrize(
    ("words", "topic"), [("my green tea", "GreenTea"), ("my milk", "Milk"), ("my piano", "Piano")]
)
def test_a_known_thing_of_theirs_is_a_topic(words, topic):
    reply = hear(mrs_smith("Tea"), words, act("jump", topic=words, startsentence="q"))
    assert kinds_said(mrs_smith("Tea"), reply) == ["q"]
    assert reply.topic == topic


def test_people_of_nobody_in_particular_are_a_topic():
    reply = hear(BEFORE, "Husbands", act("jump", topic="husbands", startsentence="q"))
    assert (reply.topic, kinds_said(BEFORE, reply)) == ("Husband", ["q"])


@pytest.mark.parametrize(("start", "pool"), [("q", "wish"), ("p", "fond"), (None, "wish")])
def test_an_unknown_wish_is_followed_by_an_open_question(start, pool):
    reply = hear(BEFORE, "Submarines", act("jump", topic="submarines", startsentence=start))
    assert kinds_said(BEFORE, reply) == [pool]
    assert (reply.topic, reply.state.ordering) == ("OnYourMind", "w")
    assert hear(reply.state, "They dive so deep").sentence_type == "w"


def test_after_an_unknown_dislike_the_talk_carries_on():
    before = mrs_smith("Milk", ordering="wc")
    reply = hear(before, "Submarines?", act("jump", topic="submarines", startsentence="n"))
    assert kinds_said(before, reply) == ["averse", "w"]
    assert (reply.topic, reply.state.ordering) == ("Milk", "c")


@pytest.mark.parametrize("words", ["my neighbour", "my husband", "my submarine"])
def test_who_dislikes_someone_or_something_of_theirs_is_listened_to(words):
    before = mrs_smith("Milk", ordering="wc")
    reply = hear(before, words, act("jump", topic=words, startsentence="n"))
    assert kinds_said(before, reply) == ["averse"]
    assert (reply.topic, reply.state.ordering) == ("OnYourMind", "cwc")
    assert words.replace("my", "your") in reply.sentence


def test_listening_goes_on_in_the_turns_after():
    reply = hear(BEFORE, "My wife", act("jump", topic="my wife Margaret", startsentence="q"))
    types = []
    for sentence in ("She drank tea", "She played the piano", "Ah well"):
        reply = hear(reply.state, sentence)
        types.append((reply.topic, reply.sentence_type))
    assert types == [("OnYourMind", letter) for letter in "cwc"]


def test_a_jump_without_a_topic_does_nothing():
    before = mrs_smith("Milk", ordering="c")
    reply = hear(before, "Well", act("jump", topic=""))
    assert (reply.state.topic, reply.sentence_type) == (NUMBERS["Milk"], "c")
