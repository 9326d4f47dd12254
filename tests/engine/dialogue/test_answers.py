"""What an answer to a yes/no question does to likeliness, and which reaction fits."""

import pytest

from dialogue.engine.answers import learn, reaction
from languages.language import Attitude
from tests.engine.dialogue.talk import mrs_smith, node, turn_in
from tests.engine.dialogue.world import NUMBERS

TEA = NUMBERS["Tea"]


@pytest.mark.parametrize(
    ("attitude", "likeliness", "letter"),
    [
        (Attitude.YES_STRONG, 1.0, "p"),
        (Attitude.YES, 0.9, "p"),
        (Attitude.A_LITTLE, 0.6, "p"),
        (Attitude.DEPENDS, 0.5, ""),
        (Attitude.NOT_REALLY, 0.2, "n"),
        (Attitude.NO, 0.1, "n"),
        (Attitude.NO_STRONG, 0.0, "n"),
    ],
)
def test_a_graded_answer_has_a_graded_effect(attitude, likeliness, letter):
    turn = turn_in(mrs_smith("Tea"))
    learn(turn, node("Tea"), attitude)
    assert turn.state.likeliness(TEA) == likeliness
    assert reaction(attitude) == letter


def test_an_unclear_answer_changes_nothing():
    turn = turn_in(mrs_smith("Tea"))
    learn(turn, node("Tea"), Attitude.UNCLEAR)
    assert turn.state.likeliness(TEA) is None
    assert reaction(Attitude.UNCLEAR) == ""


def test_a_second_yes_makes_it_certain():
    turn = turn_in(mrs_smith("Tea").with_likeliness(TEA, 0.9))
    learn(turn, node("Tea"), Attitude.YES)
    assert turn.state.likeliness(TEA) == 1.0
