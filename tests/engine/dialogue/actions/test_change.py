"""change: the person wants another subject."""

from tests.engine.dialogue.talk import act, hear, kinds_said, mrs_smith, node
from tests.engine.dialogue.world import NUMBERS, with_pool


def test_another_branch_follows_without_a_second_announcement():
    before = mrs_smith("Tea", ordering="wc", last_type="w")
    reply = hear(before, "Something else", act("change"))
    assert kinds_said(before, reply) == ["change_asked", "q"]
    assert node(reply.topic).branch != NUMBERS["FoodAndDrink"]
    assert reply.state.noes == 0


def test_after_a_plan_sentence_the_new_topic_is_announced():
    before = mrs_smith("Milk", ordering="wc")
    reply = hear(before, "Something else", act("change"), plan_said=True)
    assert kinds_said(before, reply) == ["change", "q"]


def test_without_its_pool_the_new_topic_is_announced():
    before = mrs_smith("Milk", ordering="wc")
    content = with_pool("change_asked")
    reply = hear(before, "Something else", act("change"), content=content)
    assert kinds_said(before, reply, content) == ["change", "q"]
