"""repeat: the person did not hear the last sentence."""

import msgspec

from dialogue.engine.content import build_content
from tests.engine.dialogue.talk import act, hear, kinds_said, mrs_smith
from tests.engine.dialogue.world import KNOWLEDGE, LIBRARY, without_topics

REPEAT = act("repeat")


def test_the_last_sentence_is_said_again_and_the_talk_stays_where_it_was():
    asked = hear(mrs_smith("Tea", ordering="qrwc"), "Well")
    again = hear(asked.state, "Pardon?", REPEAT)
    assert again.sentence.endswith(asked.sentence)
    assert again.sentence != asked.sentence
    assert again.state.ordering == asked.state.ordering
    assert again.sentence_type == "q"


def test_an_answer_to_the_repeated_question_counts():
    asked = hear(mrs_smith("Tea", ordering="qrwc"), "Well")
    answered = hear(hear(asked.state, "Pardon?", REPEAT).state, "Yes")
    assert answered.state.likeliness(asked.state.topic) == 0.9


def test_a_repeated_offer_can_be_accepted():
    offered = hear(mrs_smith("Piano", ordering="g"), "Well")
    again = hear(offered.state, "Pardon?", REPEAT)
    assert hear(again.state, "Yes").plan is not None


def test_it_can_be_repeated_as_often_as_asked_for():
    asked = hear(mrs_smith("Tea", ordering="w"), "Well")
    twice = hear(hear(asked.state, "Pardon?", REPEAT).state, "Pardon?", REPEAT)
    assert twice.sentence.endswith(asked.sentence)


def test_a_sentence_of_a_pool_can_be_repeated_before_any_topic():
    ended = hear(mrs_smith(), "Goodbye", act("stop"))
    assert hear(ended.state, "Pardon?", REPEAT).sentence.endswith(ended.sentence)


def test_before_anything_was_said_there_is_nothing_to_repeat():
    before = mrs_smith()
    assert kinds_said(before, hear(before, "Pardon?", REPEAT)) == ["nothing_to_repeat"]


def test_a_sentence_that_is_gone_cannot_be_repeated():
    before = mrs_smith("Tea", frames=(999_999,))
    assert kinds_said(before, hear(before, "Pardon?", REPEAT)) == ["nothing_to_repeat"]


def test_words_that_were_only_known_then_cannot_be_repeated():
    wish = hear(mrs_smith("Tea"), "Submarines", act("jump", topic="submarines"))
    reply = hear(wish.state, "Pardon?", REPEAT)
    assert kinds_said(wish.state, reply) == ["nothing_to_repeat"]


def test_a_sentence_that_has_lost_its_translation_cannot_be_repeated():
    asked = hear(mrs_smith("Tea", ordering="q", language="it"), "Ecco")
    food = KNOWLEDGE.topics[0]
    frames = tuple(
        msgspec.structs.replace(one, texts={"en": one.texts["en"]}) for one in food.frames
    )
    topics = (msgspec.structs.replace(food, frames=frames), *KNOWLEDGE.topics[1:])
    content = build_content(msgspec.structs.replace(KNOWLEDGE, topics=topics), LIBRARY)
    reply = hear(asked.state, "Come?", REPEAT, content=content)
    assert kinds_said(asked.state, reply, content) == ["nothing_to_repeat"]


def test_a_sentence_about_a_topic_that_is_gone_cannot_be_repeated():
    asked = hear(mrs_smith("Milk", ordering="q"), "Well")
    content = without_topics("Milk")
    reply = hear(asked.state, "Pardon?", REPEAT, content=content)
    assert kinds_said(asked.state, reply, content) == ["nothing_to_repeat"]


def test_after_a_plan_sentence_nothing_more_is_said_before_it():
    asked = hear(mrs_smith("Tea", ordering="w"), "Well")
    again = hear(asked.state, "Pardon?", REPEAT, plan_said=True)
    assert again.sentence == asked.sentence
