"""How a topic flows: the ordering, pauses between questions, and the change to the next topic."""

from random import Random

import msgspec
import pytest

from dialogue.engine.content import build_content
from dialogue.engine.flow import PROPOSE, announce, begin, carry_on, enter
from dialogue.engine.next_topic import Step
from dialogue.engine.turn import Turn
from tests.engine.dialogue.talk import mrs_smith, node, turn_in
from tests.engine.dialogue.world import (
    KNOWLEDGE,
    LIBRARY,
    NUMBERS,
    changed,
    with_pool,
    without_topics,
)

TEA, PIANO = NUMBERS["Tea"], NUMBERS["Piano"]


def begun(topic: str, *, start: str = "", opinion: bool = False, likeliness: float = 0.5) -> Turn:
    turn = turn_in(mrs_smith().with_likeliness(NUMBERS[topic], likeliness))
    begin(turn, node(topic), start=start, opinion=opinion)
    return turn


def kinds(turn: Turn) -> list[str]:
    return [turn.content.tree.lines[number].type for number in turn.state.frames]


def nowhere_to_go() -> tuple[tuple[int, int], ...]:
    return tuple((NUMBERS[key], 99) for key in ("FoodAndDrink", "Music", "Traditions", "Life"))


def test_a_topic_begins_with_the_first_type_of_its_pattern():
    turn = begun("Tea")
    assert kinds(turn) == ["q"]
    assert turn.state.ordering == "rwc"
    assert turn.state.topics == (TEA,)


def test_likeliness_exactly_one_leaves_out_the_question():
    turn = begun("Tea", likeliness=1.0)
    assert kinds(turn) == ["p", "w"]
    assert turn.state.ordering == "c"
    assert kinds(begun("Tea", likeliness=0.9)) == ["q"]


def test_an_opinion_leaves_out_the_question():
    assert kinds(begun("Tea", opinion=True)) == ["p", "w"]


def test_without_a_question_there_is_no_reaction_either():
    content = build_content(changed("Tea", pattern=("c r w",)), LIBRARY)
    turn = turn_in(mrs_smith(), content=content)
    begin(turn, content.tree.by_key["Tea"], opinion=True)
    assert (kinds(turn), turn.state.ordering) == (["c"], "w")


@pytest.mark.parametrize(
    ("start", "said", "ordering"),
    [("p", ["p", "w"], "c"), ("q", ["q"], "rwc"), ("w", ["w"], "qrc"), ("c", ["c"], "qrw")],
)
def test_a_topic_can_begin_with_the_type_the_person_chose(start, said, ordering):
    turn = begun("Tea", start=start)
    assert (kinds(turn), turn.state.ordering) == (said, ordering)


def test_a_topic_begun_with_a_no_is_left_after_it():
    turn = begun("Tea", start="n")
    assert kinds(turn)[0] == "n"
    assert turn.state.topic != TEA


def test_one_of_the_patterns_is_drawn():
    content = build_content(changed("Tea", pattern=("q r w c", "c w")), LIBRARY)
    orderings = set()
    for seed in range(20):
        turn = turn_in(mrs_smith(), content=content)
        turn.chance = Random(seed)
        begin(turn, content.tree.by_key["Tea"])
        orderings.add(turn.state.ordering)
    assert orderings == {"rwc", "w"}


@pytest.mark.parametrize(("drawn", "ordering"), [(PROPOSE - 0.01, "wg"), (PROPOSE, "w")])
def test_what_is_in_brackets_is_said_now_and_then(drawn, ordering):
    content = build_content(changed("Piano", pattern=("c w [g]",)), LIBRARY)
    turn = turn_in(mrs_smith(), content=content, chance=drawn)
    begin(turn, content.tree.by_key["Piano"])
    assert turn.state.ordering == ordering


def test_p_goes_on_until_a_type_ends_the_turn():
    turn = turn_in(mrs_smith("Tea", ordering="pwc"))
    carry_on(turn)
    assert (kinds(turn), turn.state.ordering) == (["p", "w"], "c")


def test_n_leaves_the_topic():
    turn = turn_in(mrs_smith("Tea", ordering="nwc"))
    carry_on(turn)
    assert kinds(turn)[0] == "n"
    assert turn.state.topic != TEA


def test_types_without_a_sentence_are_skipped_one_by_one():
    turn = turn_in(mrs_smith("Tea", ordering="regc"))
    carry_on(turn)
    assert (kinds(turn), turn.state.ordering) == (["c"], "")


@pytest.mark.parametrize("letter", ["q", "w", "g"])
def test_after_two_questions_a_remark_comes_first(letter):
    turn = turn_in(mrs_smith("Piano", ordering=f"{letter}c", questions=2))
    carry_on(turn)
    assert (kinds(turn), turn.state.ordering) == (["c"], letter)


def test_without_a_remark_a_third_question_may_follow():
    content = build_content(changed("Life", frames=KNOWLEDGE.topics[12].frames[:9]), LIBRARY)
    turn = turn_in(mrs_smith("Gardening", ordering="qrc", questions=2), content=content)
    carry_on(turn)
    assert kinds(turn) == ["q"]


def test_a_completed_topic_leads_to_the_next_which_is_announced():
    turn = turn_in(mrs_smith("Tea"))
    carry_on(turn)
    assert turn.state.topic == NUMBERS["GreenTea"]
    assert kinds(turn) == ["t", "q"]


def test_siblings_in_a_row_are_counted():
    turn = turn_in(mrs_smith("Milk", siblings=1), chance=0.9)
    carry_on(turn)
    assert turn.state.siblings == 2
    other = turn_in(mrs_smith("Tea", siblings=1))
    carry_on(other)
    assert other.state.siblings == 0


def test_two_noes_in_a_row_lead_to_another_branch_and_are_forgotten():
    turn = turn_in(mrs_smith("Milk", noes=2), chance=0.9)
    carry_on(turn)
    assert turn.node is not None
    assert turn.node.branch != NUMBERS["FoodAndDrink"]
    assert turn.state.noes == 0


def test_a_loved_topic_is_entered_without_its_question():
    turn = turn_in(mrs_smith("Milk").with_likeliness(PIANO, 1.0))
    enter(turn, Step(node("Piano"), "far"))
    assert turn.state.ordering == "pwcg"


def test_where_no_topic_is_left_the_person_takes_the_initiative():
    turn = turn_in(mrs_smith("Tea", avoided=nowhere_to_go()))
    carry_on(turn)
    assert kinds(turn) == ["initiative"]
    assert "No topic is left to propose." in [step.text for step in turn.steps]


def test_when_all_has_been_talked_about_the_oldest_topics_may_come_again():
    topics = tuple(number for key, number in NUMBERS.items() if key != "Gardening")
    turn = turn_in(mrs_smith("Gardening", topics=(*topics, NUMBERS["Gardening"])))
    carry_on(turn)
    assert "initiative" not in kinds(turn)
    assert turn.state.topic not in (NUMBERS["Gardening"], 0)


def test_topics_with_nothing_to_say_are_passed_through():
    """After four of them the turn ends with a question of the pool."""
    silent = tuple(msgspec.structs.replace(one, frames=()) for one in KNOWLEDGE.topics)
    content = build_content(msgspec.structs.replace(KNOWLEDGE, topics=silent), LIBRARY)
    turn = turn_in(mrs_smith("Tea"), content=content)
    carry_on(turn)
    assert kinds(turn)[-1] == "initiative"


def announced(old: str, way: str, *, chance: float) -> list[str]:
    turn = turn_in(mrs_smith(), chance=chance)
    announce(turn, node(old), Step(node("Piano"), way))
    return turn.parts


def test_a_change_is_announced_with_the_topics_own_words_or_with_those_of_a_pool():
    assert announced("Tea", "link", chance=0.0) == ["Tea brings me to the piano."]
    assert announced("Tea", "link", chance=0.6) == ["After tea, the piano."]
    assert announced("Milk", "sibling", chance=0.0) == ["Milk brings me to the piano."]


def test_without_a_transition_of_its_own_the_pool_speaks():
    assert announced("Festivals", "link", chance=0.0) == ["From festivals to the piano."]


@pytest.mark.parametrize(("old", "way"), [("Tea", "far"), ("Grief", "sibling")])
def test_a_far_change_or_one_from_grief_does_not_name_the_old_topic(old, way):
    assert announced(old, way, chance=0.0) == ["Let us turn to the piano."]


def test_the_first_topic_of_a_talk_is_announced_as_such():
    turn = turn_in(mrs_smith())
    announce(turn, None, Step(node("Piano"), "far"))
    assert turn.parts == ["Shall we begin with the piano?"]


def test_a_hard_subject_is_heard_before_it_is_asked_about():
    content = build_content(changed("Grief", pattern=("w c",)), LIBRARY)
    turn = turn_in(mrs_smith(), content=content)
    begin(turn, content.tree.by_key["Funerals"])
    assert (kinds(turn), turn.state.ordering) == (["c"], "wc")


def test_after_a_hard_subject_the_person_says_how_to_go_on():
    turn = turn_in(mrs_smith("Grief"))
    carry_on(turn)
    assert kinds(turn) == ["stay_or_go"]
    assert turn.state.topic == NUMBERS["Grief"]


def test_without_its_own_pool_the_person_is_asked_for_the_initiative():
    turn = turn_in(mrs_smith("Grief"), content=with_pool("stay_or_go"))
    carry_on(turn)
    assert kinds(turn) == ["initiative"]
    assert turn.state.topic == NUMBERS["Grief"]


def test_where_there_is_no_way_to_ask_the_person_is_led_on():
    pools = {**KNOWLEDGE.pools, "stay_or_go": (), "initiative": ()}
    content = build_content(msgspec.structs.replace(KNOWLEDGE, pools=pools), LIBRARY)
    turn = turn_in(mrs_smith("Grief"), content=content)
    carry_on(turn)
    assert turn.node is not None
    assert not turn.node.gentle


@pytest.mark.parametrize("topic", ["Grief", "Funerals", "OnYourMind"])
def test_who_was_asked_and_names_nothing_is_listened_to(topic):
    turn = turn_in(mrs_smith(topic, last_type="e"))
    carry_on(turn)
    assert kinds(turn) == ["c"]
    assert (turn.state.topic, turn.state.ordering) == (NUMBERS[topic], "w")
    assert [step.rule for step in turn.steps][:1] == ["stay"]


def test_who_wants_to_move_on_is_not_asked_again():
    turn = turn_in(mrs_smith("Grief", last_type="e"))
    turn.moving = True
    carry_on(turn)
    assert turn.node is not None
    assert not turn.node.gentle


def test_a_change_that_was_announced_already_is_not_announced_again():
    turn = turn_in(mrs_smith("Tea"))
    turn.announced = True
    carry_on(turn)
    assert kinds(turn) == ["q"]


def test_an_old_topic_without_a_name_in_the_language_is_not_named():
    content = build_content(changed("Tea", names={"en": {"name": "tea"}}), LIBRARY)
    turn = turn_in(mrs_smith("Tea", language="it"), content=content)
    announce(turn, content.tree.by_key["Tea"], Step(node("Piano"), "link"))
    assert turn.parts == ["Passiamo al pianoforte."]


def test_a_topic_that_is_gone_is_completed():
    content = without_topics("Gardening")
    turn = turn_in(mrs_smith("Gardening", ordering="wc"), content=content)
    carry_on(turn)
    assert turn.node is not None
    assert kinds(turn)[0] == "begin"
