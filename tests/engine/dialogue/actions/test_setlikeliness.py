"""setlikeliness: how much the person likes something (Algorithm 1, lines 4-8)."""

import pytest

from dialogue.engine.actions.setlikeliness import set_likeliness
from tests.engine.dialogue.talk import mrs_smith, turn_in
from tests.engine.dialogue.world import NUMBERS

TEA = NUMBERS["Tea"]


def shown(value: str | None, *, before: float | None = None, topic: str = "tea") -> float | None:
    turn = turn_in(mrs_smith().with_likeliness(TEA, before))
    assert not set_likeliness(turn, {"topic": topic, "value": value})
    return turn.state.likeliness(TEA)


@pytest.mark.parametrize(
    ("value", "before", "after"),
    [
        ("1.0", 0.2, 1.0),
        ("0", 0.9, 0.0),
        ("0.9", 0.2, 0.9),
        ("0.6", 0.9, 0.9),
        ("0.1", 0.9, 0.1),
        ("0.6", None, 0.8),
    ],
)
def test_what_was_shown_before_is_lowered_by_dislike_only(value, before, after):
    assert shown(value, before=before) == after


@pytest.mark.parametrize("value", [None, "", "much", "nan", "inf", "-0.1", "1.1"])
def test_what_is_no_likeliness_changes_nothing(value):
    assert shown(value) is None


def test_line_6_an_unknown_topic_changes_nothing():
    turn = turn_in(mrs_smith())
    assert not set_likeliness(turn, {"topic": "submarines", "value": "1.0"})
    assert not set_likeliness(turn, {})
    assert turn.state == mrs_smith()
