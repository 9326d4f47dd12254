"""Which sentence is said: unused ones first, none heard lately, never the same twice in a row."""

from collections import Counter
from random import Random

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as some

from dialogue.engine.content import build_content
from dialogue.engine.saying import (
    apology,
    choose,
    say_from_pool,
    say_of_type,
    say_transition,
    sayable,
)
from dialogue.engine.tree import Line
from tests.engine.dialogue.talk import mrs_smith, node, turn_in
from tests.engine.dialogue.world import (
    KNOWLEDGE,
    LIBRARY,
    NUMBERS,
    WORLD,
    changed,
    with_pool,
    without_topics,
)

TEA = node("Tea")
PIANO = node("Piano")


def line(key: str) -> Line:
    return next(one for one in WORLD.tree.lines.values() if one.key == key)


def keys(lines: list[Line]) -> set[str]:
    return {one.key for one in lines}


def test_a_sentence_is_filled_and_remembered():
    turn = turn_in(mrs_smith("Tea"))
    assert say_of_type(turn, TEA, "q")
    assert turn.parts == ["Do you like tea?"]
    assert turn.last_line is line("FoodAndDrink.q1")
    assert turn.state.frames == (turn.last_line.number,)
    assert turn.state.has_used(TEA.number, turn.last_line.slot)


def test_a_type_without_a_sentence_is_skipped():
    turn = turn_in(mrs_smith("Tea"))
    assert not say_of_type(turn, TEA, "g")
    assert turn.steps[-1].rule == "skip"
    assert turn.parts == []


def test_each_sentence_is_said_before_one_is_said_again():
    turn = turn_in(mrs_smith("Piano"))
    turn.chance = Random(3)
    chosen = []
    for _ in range(3):
        chosen.append(choose(turn, PIANO, sayable(turn, PIANO, "w")))
        turn.state = turn.state.with_used(PIANO.number, chosen[-1].slot)
    assert keys(chosen) == {"Music.w1", "Music.w2", "Music.w3"}


def test_a_sentence_of_another_topic_heard_lately_is_put_off():
    turn = turn_in(mrs_smith("Tea", frames=(line("FoodAndDrink.q1").number,)))
    assert choose(turn, TEA, sayable(turn, TEA, "q")).key == "FoodAndDrink.q2"


def test_where_all_were_heard_lately_the_oldest_comes_first():
    heard = tuple(line(f"Music.w{number}").number for number in (2, 3, 1, 2))
    turn = turn_in(mrs_smith("Piano", frames=heard))
    assert choose(turn, PIANO, sayable(turn, PIANO, "w")).key == "Music.w3"


def test_when_all_are_used_all_may_be_said_again():
    state = mrs_smith("Piano")
    for one in PIANO.lines["w"]:
        state = state.with_used(PIANO.number, one.slot)
    turn = turn_in(state)
    assert choose(turn, PIANO, sayable(turn, PIANO, "w")).type == "w"
    assert turn.state.used_slots(PIANO.number) == 0


@given(
    some.lists(some.sampled_from([one for lines in TEA.lines.values() for one in lines])),
    some.lists(some.sampled_from([line.number for line in WORLD.tree.lines.values()]), max_size=32),
    some.sampled_from("cwq"),
    some.integers(0, 99),
)
def test_unused_comes_before_used_and_not_heard_lately_before_heard(used, heard, type_, seed):
    state = mrs_smith("Tea", frames=tuple(heard))
    for one in used:
        state = state.with_used(TEA.number, one.slot)
    turn = turn_in(state)
    turn.chance = Random(seed)
    lines = sayable(turn, TEA, type_)
    others = [one for one in lines if one.number not in heard[-1:]] or lines
    unused = [one for one in others if one not in used] or others
    fresh = [one for one in unused if one.number not in heard] or unused
    assert not lines or choose(turn, TEA, lines) in fresh


def test_own_sentences_come_more_often_than_those_of_the_class():
    drawn: Counter[str] = Counter()
    for seed in range(600):
        turn = turn_in(mrs_smith("Tea"))
        turn.chance = Random(seed)
        drawn[choose(turn, TEA, sayable(turn, TEA, "c")).key] += 1
    # Tea.c1 weighs 4, the three of the branch 1 each.
    assert 0.5 < drawn["Tea.c1"] / 600 < 0.64


def test_sentences_of_the_class_come_before_those_from_further_up():
    green = node("GreenTea")
    drawn: Counter[str] = Counter()
    for seed in range(600):
        turn = turn_in(mrs_smith("GreenTea"))
        turn.chance = Random(seed)
        drawn[choose(turn, green, sayable(turn, green, "c")).key] += 1
    assert 0.43 < drawn["Tea.c1"] / 600 < 0.57


def test_what_was_written_for_this_very_grief_comes_first():
    knowledge = changed("Grief", stop="qpng")
    content = build_content(knowledge, LIBRARY)
    grief = content.tree.by_key["Grief"]
    for seed in range(20):
        turn = turn_in(mrs_smith("Grief"), content=content)
        turn.chance = Random(seed)
        assert choose(turn, grief, sayable(turn, grief, "c")).owner == grief.number


def test_the_sentence_just_heard_is_not_said_again():
    state = mrs_smith("Tea", frames=(line("Tea.c1").number,))
    state = state.with_used(TEA.number, line("Tea.c1").slot)
    turn = turn_in(state)
    assert "Tea.c1" not in keys(sayable(turn, TEA, "c"))
    say_from_pool(turn, "acknowledge")
    assert "Tea.c1" not in keys(sayable(turn, TEA, "c"))


def test_a_new_sentence_of_a_draft_can_be_said_before_it_has_its_slot():
    new = msgspec.structs.replace(KNOWLEDGE.topics[2].frames[0], slot=-1)
    tea_draft = msgspec.structs.replace(KNOWLEDGE.topics[2], frames=(new,), stop="c")
    topics = tuple(tea_draft if one.key == "Tea" else one for one in KNOWLEDGE.topics)
    content = build_content(msgspec.structs.replace(KNOWLEDGE, topics=topics), LIBRARY)
    turn = turn_in(mrs_smith("Tea"), content=content)
    tea = content.tree.by_key["Tea"]
    assert say_of_type(turn, tea, "c")
    assert (turn.parts, turn.state.used) == (["Tea warms the hands."], ())
    assert sayable(turn, tea, "c") == []


def test_the_only_remark_is_skipped_rather_than_said_twice():
    knowledge = changed("Grief", frames=KNOWLEDGE.topics[13].frames[1:2])
    content = build_content(knowledge, LIBRARY)
    grief = content.tree.by_key["Grief"]
    turn = turn_in(mrs_smith("Grief"), content=content)
    assert say_of_type(turn, grief, "c")
    again = turn_in(turn.state, content=content)
    assert not say_of_type(again, grief, "c")


def test_a_sentence_kept_for_a_culture_is_said_there_only():
    assert "Tea.c4" in keys(sayable(turn_in(mrs_smith(culture="JP")), TEA, "c"))
    assert "Tea.c4" not in keys(sayable(turn_in(mrs_smith()), TEA, "c"))


def test_a_topic_without_a_name_in_the_language_says_nothing():
    assert sayable(turn_in(mrs_smith(language="it")), TEA, "q")
    unnamed = msgspec.structs.replace(KNOWLEDGE.topics[2], names={"en": {"name": "tea"}})
    topics = tuple(unnamed if one.key == "Tea" else one for one in KNOWLEDGE.topics)
    content = build_content(msgspec.structs.replace(KNOWLEDGE, topics=topics), LIBRARY)
    turn = turn_in(mrs_smith(language="it"), content=content)
    assert sayable(turn, content.tree.by_key["Tea"], "q") == []


def test_an_activity_is_offered_where_the_client_can_do_all_of_it():
    everything = turn_in(mrs_smith())
    assert keys(sayable(everything, PIANO, "g")) == {"Music.g1", "Music.g2"}
    waving = turn_in(mrs_smith(), capabilities={"attention"})
    assert keys(sayable(waving, PIANO, "g")) == {"Music.g2"}
    assert sayable(turn_in(mrs_smith(), capabilities=()), PIANO, "g") == []


def test_an_activity_whose_plan_is_gone_or_not_written_is_not_offered():
    gone = msgspec.structs.replace(LIBRARY, intents=LIBRARY.intents[1:])
    frames = (
        *KNOWLEDGE.topics[6].frames[-2:],
        msgspec.structs.replace(KNOWLEDGE.topics[6].frames[-1], key="Music.g3", do=""),
    )
    content = build_content(changed("Music", frames=frames), gone)
    turn = turn_in(mrs_smith(), content=content)
    assert keys(sayable(turn, content.tree.by_key["Piano"], "g")) == {"Music.g2"}


def test_gentle_topics_never_ask_do_you_like_nor_propose():
    knowledge = changed("Grief", stop="", frames=KNOWLEDGE.topics[6].frames)
    content = build_content(knowledge, LIBRARY)
    grief = content.tree.by_key["Grief"]
    turn = turn_in(mrs_smith("Grief"), content=content)
    assert sayable(turn, grief, "q") == []
    assert sayable(turn, grief, "g") == []
    assert sayable(turn, grief, "w")


def test_an_old_sentence_that_cannot_be_filled_is_skipped():
    turn = turn_in(mrs_smith("Tea"))
    assert not say_of_type(turn, TEA, "t")
    assert turn.steps[-1].rule == "unfilled"
    assert (turn.parts, turn.state.frames) == ([], ())


def test_a_transition_names_both_topics():
    turn = turn_in(mrs_smith("Tea"))
    assert say_transition(turn, TEA, PIANO)
    assert turn.parts == ["Tea brings me to the piano."]


@pytest.mark.parametrize(("topic", "frames"), [("Piano", ()), ("Tea", ("FoodAndDrink.t1",))])
def test_a_transition_that_is_not_there_or_heard_lately_is_not_said(topic, frames):
    turn = turn_in(mrs_smith(topic, frames=tuple(line(key).number for key in frames)))
    assert not say_transition(turn, node(topic), node("Festivals"))


def test_a_transition_that_was_said_of_this_topic_is_not_said_again():
    turn = turn_in(mrs_smith("Tea"))
    assert say_transition(turn, TEA, PIANO)
    turn.change(frames=())
    assert not say_transition(turn, TEA, PIANO)


def test_a_pool_gives_what_was_not_heard_lately():
    turn = turn_in(mrs_smith(frames=(line("acknowledge.1").number,)))
    assert say_from_pool(turn, "acknowledge")
    assert turn.last_line is line("acknowledge.2")


def test_a_pool_heard_completely_gives_the_oldest():
    heard = tuple(line(f"acknowledge.{number}").number for number in (3, 1, 2, 3))
    turn = turn_in(mrs_smith(frames=heard))
    assert say_from_pool(turn, "acknowledge")
    assert turn.last_line is line("acknowledge.1")


def test_an_empty_or_unknown_pool_says_nothing():
    content = with_pool("acknowledge")
    assert not say_from_pool(turn_in(mrs_smith(), content=content), "acknowledge")
    assert not say_from_pool(turn_in(mrs_smith()), "no such pool")


def test_a_pool_sentence_that_cannot_be_filled_is_skipped():
    turn = turn_in(mrs_smith())
    assert not say_from_pool(turn, "wish")
    assert turn.steps[-1].rule == "unfilled"


def test_an_apology_is_there_in_each_language():
    assert apology(WORLD, "en") == "I did not hear you."
    assert apology(WORLD, "ja") == "聞こえませんでした。"
    assert apology(WORLD, "fr") == ""
    assert apology(with_pool("apology"), "en") == ""


def test_numbers_of_sentences_that_are_gone_do_no_harm():
    content = without_topics("Gardening")
    turn = turn_in(mrs_smith("Tea", frames=(999_999,)), content=content)
    assert say_of_type(turn, content.tree.nodes[NUMBERS["Tea"]], "q")


def test_words_just_said_are_not_said_again_with_more_behind_them():
    turn = turn_in(mrs_smith("Tea"))
    turn.parts.append("Do you")
    assert say_of_type(turn, TEA, "q")
    assert turn.parts == ["", "Do you like tea?"]
