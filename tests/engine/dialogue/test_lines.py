"""Frames become lines: templates in each language, and the activity of a proposal."""

from contextlib import suppress

import pytest
from hypothesis import given
from hypothesis import strategies as some

from dialogue.engine.concepts import Frame
from dialogue.engine.lines import ProposalError, compile_line, parse_proposal

TEA = Frame(key="Tea.c1", type="c", number=5, slot=2, texts={"en": "Tea!", "fr": "{", "it": ""})


def test_a_line_keeps_what_the_frame_says_in_known_languages():
    line = compile_line(TEA, 3)
    assert (line.number, line.slot, line.owner) == (5, 2, 3)
    assert set(line.templates) == {"en"}
    assert line.proposal is None


def test_a_line_fits_its_language_and_culture():
    line = compile_line(Frame(key="Tea.c2", type="c", only=("JP",), texts={"en": "Tea!"}), 3)
    assert line.fits("en", "JP")
    assert not line.fits("en", "EN")
    assert not line.fits("it", "JP")


def test_a_proposal_names_its_plan_and_parameters():
    proposal = parse_proposal(" playsong  artist=ABBA title=the song of $hasName ")
    assert proposal.intent == "playsong"
    filled = {name: texts["en"].text for name, texts in proposal.parameters}
    assert filled == {"artist": "ABBA", "title": "the song of $hasName"}


def test_a_proposal_may_have_no_parameters():
    assert parse_proposal("wave").parameters == ()


def test_a_proposal_is_compiled_for_its_frame():
    line = compile_line(Frame(key="Music.g1", type="g", texts={"en": "Music?"}, do="wave"), 3)
    assert line.proposal == parse_proposal("wave")


@given(some.text("ab= $.{}\n", max_size=60))
def test_whatever_an_expert_writes_is_read_or_refused(text):
    with suppress(ValueError):
        assert parse_proposal(text).intent.isidentifier()


@pytest.mark.parametrize("text", ["", "   ", "play-song title=x", "=x"])
def test_a_proposal_must_begin_with_a_name(text):
    with pytest.raises(ProposalError, match="must begin with a plan's name"):
        parse_proposal(text)


@pytest.mark.parametrize("text", ["playsong title", "playsong the title=x", "playsong =x"])
def test_a_parameter_must_be_written_name_equals_value(text):
    with pytest.raises(ProposalError, match="is no parameter"):
        parse_proposal(text)
