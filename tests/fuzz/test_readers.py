"""Strangers' data, well-formed and then spoilt: documented answers and refusals, nothing else."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.fuzz import seeds, targets
from tests.fuzz.strategies import UNICODE, examples, mutated


@examples(300)
@given(mutated(seeds.STATES))
def test_a_spoilt_state_is_refused(data: bytes) -> None:
    targets.state_text(data)


@pytest.mark.parametrize("text", seeds.STATES)
def test_the_last_letter_of_a_state_is_held_to_as_well(text: bytes) -> None:
    for letter in b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_=":
        for changed in (text[:-1] + bytes((letter,)), text + bytes((letter,)), text + b"=="):
            targets.state_text(changed)


@examples(300)
@given(mutated(seeds.SIGNED))
def test_a_spoilt_state_that_was_signed_is_a_state_or_refused(data: bytes) -> None:
    targets.signed_state(data)


@examples(200)
@given(
    mutated(seeds.TRIGGERS, seeds.TRIGGER_WORDS)
    | UNICODE.map(lambda text: text.encode("utf-8", "replace"))
)
def test_any_trigger_is_read_or_refused_at_its_place(data: bytes) -> None:
    targets.trigger(data)


@examples(60)
@given(mutated(seeds.TRIGGERS, seeds.TRIGGER_WORDS))
def test_a_library_of_any_trigger_is_refused_or_matched(data: bytes) -> None:
    targets.library(data)


@examples(300)
@given(mutated(seeds.BODIES, seeds.JSON_WORDS) | st.binary(max_size=300))
def test_a_spoilt_body_is_an_object_or_refused(data: bytes) -> None:
    targets.body(data)


@examples(300)
@given(mutated(seeds.FILES, seeds.XML_WORDS) | st.binary(max_size=300))
def test_a_spoilt_owl_file_is_told_or_refused(data: bytes) -> None:
    targets.owl(data)
