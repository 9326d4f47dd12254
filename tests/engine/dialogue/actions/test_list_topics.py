"""list: the person asks what there is to talk about."""

from tests.engine.dialogue.talk import act, hear, kinds_said, mrs_smith
from tests.engine.dialogue.world import NUMBERS


def test_a_few_topics_are_named_and_the_choice_is_left_to_the_person():
    before = mrs_smith("Tea")
    reply = hear(before, "What can we talk about?", act("list"))
    assert kinds_said(before, reply) == ["list"]
    assert reply.sentence.count(",") <= 1
    assert " or " in reply.sentence
    assert reply.topic == "Tea"


def test_hard_topics_are_not_named():
    for seed in range(1, 20):
        reply = hear(mrs_smith("Tea", seed=seed), "What can we talk about?", act("list"))
        assert "grief" not in reply.sentence
        assert "on your mind" not in reply.sentence


def test_where_nothing_is_left_the_talk_goes_on():
    away = tuple((NUMBERS[key], 99) for key in ("FoodAndDrink", "Music", "Traditions", "Life"))
    before = mrs_smith("Tea", ordering="c", avoided=away)
    assert kinds_said(before, hear(before, "What else", act("list"))) == ["c"]
