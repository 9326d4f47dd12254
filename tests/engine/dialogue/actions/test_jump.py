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


@pytest.mark.parametrize("words", ["my wife Margaret", "my green tea", "my milk"])
def test_someones_own_is_listened_to_even_where_keywords_match(words):
    reply = hear(BEFORE, words, act("jump", topic=words, startsentence="q"))
    assert reply.topic == "OnYourMind"
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
