"""listen: the person speaks of a feeling or a need; the talk turns to them."""

import pytest

from tests.engine.dialogue.talk import act, hear, kinds_said, mrs_smith


@pytest.mark.parametrize(("start", "said"), [("c", "urgent"), ("w", "w")])
def test_the_talk_turns_to_the_person(start: str, said: str):
    before = mrs_smith("Tea", ordering="wg")
    reply = hear(before, "I feel so sad", act("listen", startsentence=start))
    assert (reply.topic, kinds_said(before, reply)) == ("OnYourMind", [said])


def test_without_a_word_on_how_it_stays_quietly():
    before = mrs_smith("Tea", ordering="wg")
    assert kinds_said(before, hear(before, "I am cold", act("listen"))) == ["urgent"]


def test_nothing_is_proposed_afterwards():
    reply = hear(mrs_smith("Tea", ordering="wg"), "I feel so sad", act("listen"))
    for _ in range(2):
        reply = hear(reply.state, "It is like that every evening")
        assert reply.sentence_type in "cw"


def test_a_hard_subject_is_listened_to_as_such():
    before = mrs_smith("Tea", ordering="wg")
    reply = hear(before, "I feel such grief", act("listen", startsentence="w"))
    assert reply.topic == "Grief"
