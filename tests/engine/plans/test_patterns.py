"""The grammar of triggers: what is read, printed, sampled and refused, and where."""

from random import Random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plans.engine.patterns import (
    Choice,
    Part,
    PatternError,
    PhraseUse,
    Sequence,
    SlotUse,
    Word,
    always_literal,
    expansions,
    parse_options,
    parse_pattern,
    print_pattern,
    sample,
)

WORDS = st.sampled_from(["play", "song", "l'arte", "più", "音楽", "を", "7pm", "don't"])
LEAVES = st.one_of(
    WORDS.map(Word),
    st.sampled_from(["title", "what"]).map(SlotUse),
    st.sampled_from(["please"]).map(PhraseUse),
)


def read_or_refusal(text: str) -> Sequence | PatternError:
    try:
        return parse_pattern(text)
    except PatternError as error:
        return error


def choices(parts: st.SearchStrategy[Part]) -> st.SearchStrategy[Choice]:
    options = st.lists(parts, min_size=1, max_size=3).map(lambda found: Sequence(tuple(found)))
    several = st.lists(options, min_size=1, max_size=3).map(tuple)
    return st.builds(Choice, several, optional=st.booleans())


ONE_DEEP = st.one_of(LEAVES, choices(LEAVES))
TWO_DEEP = st.one_of(ONE_DEEP, choices(ONE_DEEP))
SEQUENCES = st.lists(TWO_DEEP, min_size=1, max_size=4).map(lambda found: Sequence(tuple(found)))


@given(SEQUENCES)
@settings(max_examples=150, deadline=None)
def test_a_printed_trigger_reads_back_the_same(sequence: Sequence) -> None:
    text = print_pattern(sequence)
    if len(text) <= 600:
        assert parse_pattern(text) == sequence


@given(st.text(alphabet="ab []()|{}<>_'é音", max_size=40))
@settings(max_examples=300, deadline=None)
def test_any_text_is_read_or_refused_with_a_place_inside_it(text: str) -> None:
    found = read_or_refusal(text)
    if isinstance(found, PatternError):
        assert 0 <= found.position <= len(text)
    else:
        assert parse_pattern(print_pattern(found)) == found


@pytest.mark.parametrize(
    ("text", "position"),
    [
        ("play {title", 5),
        ("(play|put on {title}", 0),
        ("play] it", 4),
        ("play | put", 5),
        ("play (a||b)", 8),
        ("play []", 6),
        ("play (a]", 7),
        ("play {Title}", 6),
        ("", 0),
        ("a [b [c [d [e [f]]]]]", 14),
        ("x" * 601, 600),
    ],
)
def test_a_wrong_trigger_is_refused_at_its_place(text: str, position: int) -> None:
    with pytest.raises(PatternError) as refused:
        parse_pattern(text)
    assert refused.value.position == position


def test_the_error_names_place_and_text() -> None:
    with pytest.raises(PatternError) as refused:
        parse_pattern("play {title")
    assert str(refused.value) == "Open '{' without '}' at position 5 of 'play {title'"


def test_a_phrase_may_have_bars_outside_brackets() -> None:
    phrase = parse_options("please|could you")
    assert expansions(phrase, {}) == 2


def test_a_wrong_phrase_is_refused_at_its_place() -> None:
    with pytest.raises(PatternError) as refused:
        parse_options("please|{x")
    assert refused.value.position == 7


def test_expansions_multiply_and_add() -> None:
    phrases = {"please": parse_options("please|kindly")}
    assert expansions(parse_pattern("[<please>] (play|put on) [the|a] {title}"), phrases) == 18


def test_a_trigger_whose_words_are_all_optional_is_not_always_literal() -> None:
    assert not always_literal(parse_pattern("[play] {title}"), {})
    assert not always_literal(parse_pattern("(play|{title})"), {})
    assert always_literal(parse_pattern("(play|put on) {title}"), {})


@given(SEQUENCES, st.integers(0, 1_000))
@settings(max_examples=100, deadline=None)
def test_a_sample_holds_only_words_of_the_trigger(sequence: Sequence, seed: int) -> None:
    phrases = {"please": parse_options("please|kindly")}
    words = sample(sequence, Random(seed), phrases, lambda name: f"<{name}>")
    known = print_pattern(sequence) + " please kindly <title> <what>"
    assert all(word in known for word in words)


def test_a_value_list_is_as_good_as_words() -> None:
    assert always_literal(parse_pattern("{level} [please]"), {}, {"level"})
    assert not always_literal(parse_pattern("[{level}] {title}"), {}, {"level"})
