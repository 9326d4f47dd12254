"""Plan strings: nothing a person says can forge a plan."""

import re

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plans.engine.actions import ACTIONS, ParameterKind
from plans.engine.fill import clean, fill_actions, kbplan_string, plan_string
from plans.engine.intents import ActionItem
from plans.engine.kb_actions import KB_ACTIONS
from plans.engine.plan_text import PlanTextError, parse_plan, print_plan

SONG = parse_plan("#action=playsong title={title}")
NASTY = st.text(alphabet="ab #\n\r\u2028\x00actionACTION= 音＃", max_size=60)


def plan(text: str, **values: str) -> str:
    return plan_string(fill_actions(parse_plan(text), values))


def test_a_known_value_is_filled_in() -> None:
    assert plan("#action=playsong title={title}", title="Hey Brother") == (
        "#action=playsong title=Hey Brother"
    )


def test_an_unknown_value_is_none() -> None:
    assert plan("#action=playsong title={title}") == "#action=playsong title=None"


def test_every_key_is_present_and_free_text_is_last() -> None:
    assert plan("#action=translate what={what}", what="good dog") == (
        "#action=translate language=None what=good dog"
    )


def test_two_actions_follow_without_a_blank() -> None:
    assert plan("#action=goto where=docking station#action=rest") == (
        "#action=goto where=docking station#action=rest"
    )


@pytest.mark.parametrize("level", ["very loud", "più", "loud#er", "99", ""])
def test_a_word_parameter_is_one_known_word_or_none(level: str) -> None:
    assert plan("#action=volume level={level}", level=level) == "#action=volume level=None"


def test_a_kbplan_topic_has_no_blanks() -> None:
    text = "#action=setlikeliness topic={topic} value=1.0"
    filled = fill_actions(parse_plan(text), {"topic": "shepherd's pie"})
    assert kbplan_string(filled) == "#action=setlikeliness topic=shepherd_s_pie value=1.0"
    assert filled[0].parameters["topic"] == "shepherd's pie"


@given(NASTY)
@settings(max_examples=300, deadline=None)
def test_no_value_forges_an_action(title: str) -> None:
    string = plan_string(fill_actions(SONG, {"title": title}))
    assert string.count("#") == 1
    assert len(re.findall(r"action\s*=", string, re.IGNORECASE)) == 1
    assert string.splitlines() == [string]
    assert string == string.rstrip()


@given(NASTY)
@settings(max_examples=200, deadline=None)
def test_no_topic_forges_a_kbplan(topic: str) -> None:
    items = parse_plan("#action=jump topic={topic} startsentence=q")
    string = kbplan_string(fill_actions(items, {"topic": topic}))
    assert re.fullmatch(r"#action=jump topic=\w+ startsentence=q", string)


@given(NASTY)
@settings(max_examples=100, deadline=None)
def test_cleaning_twice_changes_nothing(value: str) -> None:
    assert clean(clean(value)) == clean(value)


def test_an_endless_value_is_cut() -> None:
    assert len(clean("a" * 100_000)) == 200
    assert len(clean("action=" * 100_000)) <= 200


def test_a_printed_plan_reads_back_the_same() -> None:
    text = "#action=goto where=docking station#action=translate language=Italian what={what}"
    assert print_plan(parse_plan(text)) == text
    assert parse_plan("") == ()


@pytest.mark.parametrize(("text", "position"), [("play", 0), ("#play", 1), ("#action=rest#x", 13)])
def test_a_wrong_plan_is_refused_at_its_place(text: str, position: int) -> None:
    with pytest.raises(PlanTextError) as refused:
        parse_plan(text)
    assert refused.value.position == position


def test_each_action_has_at_most_one_free_text_and_it_is_last() -> None:
    for action in ACTIONS:
        kinds = [parameter.kind for parameter in action.parameters]
        assert ParameterKind.TEXT not in kinds[:-1]


def test_the_kb_actions_of_the_dialogue_are_all_there() -> None:
    talk = "setlikeliness jump leave change repeat opinion more stop forget"
    assert [action.name for action in KB_ACTIONS] == [
        *talk.split(),
        *("list", "abilities", "listen", "tell"),
    ]


def test_digits_are_a_word() -> None:
    item = ActionItem(action="timer", parameters=(("seconds", "{length}"),))
    assert plan_string(fill_actions([item], {"length": "1200"})) == "#action=timer seconds=1200"
