"""Patterns such as `q r w c [g]` and what is wrong with bad ones."""

import pytest

from dialogue.engine.codec import encode
from dialogue.engine.patterns import MOST_TYPES, PatternError, parse_pattern, parse_patterns
from tests.engine.dialogue.talk import mrs_smith


def test_a_pattern_says_which_types_may_be_left_out():
    assert parse_pattern("q r [g]") == (("q", False), ("r", False), ("g", True))


@pytest.mark.parametrize("text", ["q p|n w", "q (p|n) w", "q r w"])
def test_the_reaction_can_be_written_as_in_the_paper(text):
    assert [letter for letter, _ in parse_pattern(text)] == ["q", "r", "w"]


@pytest.mark.parametrize("text", ["q x", "qr", "[q", "[]", "q ["])
def test_what_is_no_type_is_named(text):
    with pytest.raises(PatternError, match="is no sentence type"):
        parse_pattern(text)


def test_an_empty_pattern_is_refused():
    with pytest.raises(PatternError, match="empty"):
        parse_pattern("  ")


def test_a_pattern_fits_into_a_dialogue_state():
    longest = " ".join("w" * MOST_TYPES)
    encode(mrs_smith(ordering="q" + longest.replace(" ", "")), [b"a key of many bytes"])
    with pytest.raises(PatternError, match="15 types at most"):
        parse_pattern(f"{longest} c")


def test_alternatives_stay_in_order():
    assert parse_patterns(["c", "w"]) == ((("c", False),), (("w", False),))
