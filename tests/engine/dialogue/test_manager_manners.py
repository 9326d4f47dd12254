"""How the Dialogue Manager listens, helps, greets, and what the state carries on."""

import msgspec
import pytest

from dialogue.engine.content import build_content
from dialogue.engine.manager import start
from tests.engine.dialogue.talk import act, hear, kinds_said, lines_said, mrs_smith, node, rules
from tests.engine.dialogue.world import (
    KNOWLEDGE,
    LIBRARY,
    WORLD,
    with_pool,
)

# Acknowledgements.


@pytest.mark.parametrize(
    ("last_type", "sentence", "said"),
    [
        ("w", "Hm", ["acknowledge", "c"]),
        ("e", "Hm", ["acknowledge", "c"]),
        ("c", "Hm", ["c"]),
        ("c", "It rains outside", ["acknowledge", "c"]),
        ("c", "Why is that?", ["not_understood", "c"]),
    ],
)
def test_the_person_is_heard(last_type, sentence, said):
    before = mrs_smith("Tea", ordering="c", last_type=last_type)
    assert kinds_said(before, hear(before, sentence)) == said


def test_who_speaks_of_hard_things_is_heard_in_their_tone():
    before = mrs_smith("Grief", ordering="c", last_type="w")
    assert kinds_said(before, hear(before, "It was long ago")) == ["gentle", "c"]


def test_turns_that_were_not_understood_are_counted():
    before = mrs_smith("Tea", ordering="c", misses=1)
    assert hear(before, "Why is that?").state.misses == 2
    assert hear(before, "That is so").state.misses == 0


# Help, coming back, speaking after the end.


def test_who_asks_for_help_hears_no_chit_chat():
    before = mrs_smith("Tea", ordering="wc", offer=5)
    reply = hear(before, "Help me", act("more"), urgent=True)
    assert kinds_said(before, reply) == ["urgent"]
    assert (reply.topic, reply.state.ordering, reply.state.offer) == ("OnYourMind", "cwc", 0)
    assert rules(reply)[0] == "urgent"


def test_help_without_its_pool_still_gets_a_reply():
    before = mrs_smith("Tea", ordering="c")
    reply = hear(before, "Help me", urgent=True, content=with_pool("urgent"))
    assert reply.sentence


def test_an_empty_sentence_with_a_state_is_welcomed_back():
    before = mrs_smith("Tea", ordering="wc", ended=True, offer=5)
    reply = hear(before, "  ")
    assert kinds_said(before, reply) == ["welcome_back"]
    assert (reply.state.ended, reply.state.ordering) == (False, "wc")
    assert reply.sentence_type == "e"


def test_speaking_after_the_end_opens_the_talk_again():
    before = mrs_smith("Tea", ordering="c", ended=True, last_type="c")
    reply = hear(before, "One more thing though")
    assert kinds_said(before, reply) == ["after_end", "c"]
    assert not reply.state.ended


# What the state carries.


def test_the_turn_and_the_questions_in_a_row_are_counted():
    before = mrs_smith("Tea", ordering="wc", questions=1)
    asked = hear(before, "Well")
    assert (asked.state.turn, asked.state.questions) == (6, 2)
    assert hear(asked.state, "Well").state.questions == 0


def test_a_reply_without_words_keeps_the_last_type_and_asks_nothing():
    before = mrs_smith(last_type="q", questions=2)
    reply = hear(before, "Forget it", act("forget"), plan_said=True)
    assert (reply.sentence, reply.sentence_type) == ("", "q")
    assert reply.state.questions == 0


@pytest.mark.parametrize(
    ("pool", "last_type"), [("end", "c"), ("initiative", "e"), ("start", "e"), ("no pool", "c")]
)
def test_a_sentence_of_a_pool_hands_over_where_the_pool_asks(pool, last_type):
    frame = msgspec.structs.replace(KNOWLEDGE.pools["end"][0], type=pool)
    pools = {**KNOWLEDGE.pools, "end": (frame,)}
    content = build_content(msgspec.structs.replace(KNOWLEDGE, pools=pools), LIBRARY)
    assert hear(mrs_smith(), "Bye", act("stop"), content=content).sentence_type == last_type


def test_sentences_are_joined_as_the_language_wants_it():
    before = mrs_smith("Tea", ordering="pc", language="ja", culture="JP")
    reply = hear(before, "うん")
    assert " " not in reply.sentence
    assert len(lines_said(before, reply)) == 2


def test_no_step_is_noted_unless_asked_for():
    reply = hear(mrs_smith("Tea", ordering="c"), "Well")
    assert "say" in rules(reply)
    assert start(WORLD, "en", "EN").steps == ()


@pytest.mark.parametrize(
    ("language", "culture", "sentence"),
    [("en", "EN", "Yes"), ("it", "IT", "Sì"), ("ja", "JP", "はい")],
)
def test_the_answer_is_understood_in_each_language(language, culture, sentence):
    before = mrs_smith("Tea", last_type="q", ordering="rwc", language=language, culture=culture)
    reply = hear(before, sentence)
    assert kinds_said(before, reply) == ["p", "w"]


def test_a_topic_they_did_not_like_is_taken_up_with_care():
    before = mrs_smith("Milk", ordering="w").with_likeliness(node("Tea").number, 0.1)
    assert "disliked" in kinds_said(before, hear(before, "I had tea"))


def test_a_first_turn_without_words_is_a_greeting():
    before = start(WORLD, "en", "EN", 1).state
    assert kinds_said(before, hear(before, "")) == ["start"]


def test_a_question_about_people_gets_no_stock_line_about_them():
    before = mrs_smith("Husband", ordering="wc", last_type="c")
    reply = hear(before, "Where is he now?")
    assert kinds_said(before, reply)[0] == "not_understood"
    assert reply.topic == "OnYourMind"
