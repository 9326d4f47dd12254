"""A turn in the making: likeliness of the person over that of the culture, notes on demand."""

from tests.engine.dialogue.talk import mrs_smith, node, turn_in
from tests.engine.dialogue.world import NUMBERS


def test_likeliness_is_the_persons_before_the_cultures():
    tea = node("Tea")
    assert turn_in(mrs_smith()).likeliness(tea) == 0.8
    assert turn_in(mrs_smith(culture="IT")).likeliness(tea) == 0.3
    dislikes = mrs_smith().with_likeliness(NUMBERS["Tea"], 0.0)
    assert turn_in(dislikes).likeliness(tea) == 0.0


def test_a_culture_that_says_nothing_has_a_half():
    assert turn_in(mrs_smith(culture="XX")).likeliness(node("Tea")) == 0.5


def test_notes_are_taken_only_where_asked_for():
    silent = turn_in(mrs_smith(), explain=False)
    silent.note("say", "Tea.c1")
    assert silent.steps == []
    asked = turn_in(mrs_smith())
    asked.note("next", "drawn", [(node("Tea"), 0.12345)])
    assert asked.steps[0].candidates[0].topic == "Tea"
    assert asked.steps[0].candidates[0].likeliness == 0.123


def test_a_turn_knows_its_language_and_topic():
    turn = turn_in(mrs_smith("Tea", language="ja"))
    assert turn.language.code == "ja"
    assert turn.node is node("Tea")
    assert turn_in(mrs_smith()).node is None
