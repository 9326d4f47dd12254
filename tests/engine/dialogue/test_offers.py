"""Activities on offer: accepted, refused, ignored."""

import pytest

from dialogue.engine.content import build_content
from dialogue.engine.lines import parse_proposal
from dialogue.engine.offers import answer_offer
from languages.language import Attitude
from plans.engine.intents import Library
from tests.engine.dialogue.talk import hear, kinds_said, lines_said, mrs_smith, turn_in
from tests.engine.dialogue.world import KNOWLEDGE, WORLD

FRAMES = {line.key: line.number for line in WORLD.tree.lines.values()}


def offered(key: str, **fields: object):
    number = FRAMES[key]
    return mrs_smith("Piano", offer=number, last_type="g", frames=(number,), **fields)


def test_a_yes_brings_the_plan_with_the_topics_name():
    answer = hear(offered("Music.g1"), "Yes please")
    assert answer.plan is not None
    assert answer.plan.plan == "#action=playsong title=the piano"
    assert answer.plan.plan_sentence == "I play the piano."
    assert answer.state.offer == 0


@pytest.mark.parametrize("sentence", ["Yes, why not?", "Yes I would really like that"])
def test_after_a_yes_the_agent_does_not_say_that_it_did_not_understand(sentence):
    before = offered("Music.g1", ordering="c")
    answer = hear(before, sentence)
    assert answer.plan is not None
    assert kinds_said(before, answer) == ["c"]


def test_a_plan_without_words_is_announced():
    before = offered("Music.g2", ordering="c")
    answer = hear(before, "Yes")
    assert kinds_said(before, answer) == ["goal_accepted", "c"]
    assert answer.plan is not None
    assert answer.plan.plan == "#action=attention"


def test_a_no_is_accepted_and_the_talk_goes_on():
    before = offered("Music.g1", ordering="c")
    answer = hear(before, "No thanks")
    assert answer.plan is None
    assert kinds_said(before, answer) == ["goal_refused", "c"]


def test_neither_yes_nor_no_is_an_ordinary_sentence():
    before = offered("Music.g1", ordering="c")
    answer = hear(before, "Milk is for cats")
    assert answer.plan is None
    assert answer.topic == "Milk"
    assert "goal_refused" not in kinds_said(before, answer)


def test_a_yes_is_no_answer_to_a_proposal_where_another_plan_was_asked_for():
    answer = hear(offered("Music.g1", ordering="c"), "Yes, wave", plan_matched=True)
    assert answer.plan is None


def test_a_yes_to_an_offer_long_gone_is_an_ordinary_sentence():
    answer = hear(mrs_smith("Piano", last_type="g", ordering="c", offer=999_999), "Yes")
    assert answer.plan is None
    acknowledge = hear(mrs_smith("Piano", offer=FRAMES["acknowledge.1"], ordering="c"), "Yes")
    assert acknowledge.plan is None


def test_the_offer_is_remembered_for_one_turn():
    answer = hear(mrs_smith("Piano", ordering="g"), "That is so")
    assert answer.sentence_type == "g"
    assert answer.state.offer == answer.state.frames[-1]
    again = hear(answer.state, "It rains outside today")
    assert again.state.offer == 0


def test_a_robot_that_lost_the_ability_says_so_instead_of_a_plan():
    answer = hear(offered("Music.g1", ordering="c"), "Yes", capabilities={"attention"})
    assert answer.plan is not None
    assert answer.plan.plan == ""


def test_an_accepted_plan_that_is_gone_does_nothing():
    content = build_content(KNOWLEDGE, Library())
    before = offered("Music.g1", ordering="c")
    answer = hear(before, "Yes", content=content)
    assert answer.plan is not None
    assert answer.plan.plan == ""
    assert lines_said(before, answer)[0].startswith("goal_accepted")


@pytest.mark.parametrize(
    ("topic", "language", "do"),
    [("", "en", "playsong title=$hasName"), ("Piano", "en", "playsong title=$unit")],
)
def test_a_parameter_that_cannot_be_filled_is_left_out(topic, language, do):
    turn = turn_in(mrs_smith(topic, language=language))
    answer_offer(turn, parse_proposal(do), Attitude.YES)
    assert turn.plan is not None
    assert turn.plan.plan == "#action=playsong title=None"
