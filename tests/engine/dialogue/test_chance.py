"""Chance: seeded talks can be had again, draws follow their weights."""

from collections import Counter
from random import Random

from dialogue.engine.chance import chance_for, draw
from tests.engine.dialogue.talk import Same


def test_the_same_seed_and_turn_have_the_same_chance():
    assert chance_for(7, 3).random() == chance_for(7, 3).random()


def test_turns_and_seeds_differ():
    drawn = {chance_for(seed, turn).random() for seed in (1, 2) for turn in (0, 1)}
    assert len(drawn) == 4


def test_without_a_seed_chance_is_fresh():
    assert chance_for(0, 3).random() != chance_for(0, 3).random()


def test_nothing_is_drawn_where_no_weight_is_above_zero():
    assert draw([("Tea", 0.0), ("Milk", 0.0)], Random(1)) is None
    assert draw([], Random(1)) is None


def test_what_weighs_nothing_is_never_drawn():
    drawn = {draw([("Tea", 0.0), ("Milk", 0.5)], Random(seed)) for seed in range(50)}
    assert drawn == {"Milk"}


def test_the_heavier_is_drawn_more_often():
    chance = Random(1)
    drawn = Counter(draw([("Tea", 0.9), ("Milk", 0.1)], chance) for _ in range(1000))
    assert 850 < drawn["Tea"] < 950


def test_rounding_never_leaves_a_draw_without_a_result():
    assert draw([("Tea", 0.1), ("Milk", 0.2), ("Music", 0.0)], Same(1.0)) == "Milk"
