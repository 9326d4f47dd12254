"""Findings about intents, and about proposals that offer none of them."""

import msgspec
import pytest

from dialogue.engine.concepts import Frame, Knowledge
from dialogue.engine.library_checks import check_library
from plans.engine.intents import Library
from tests.engine.dialogue.world import KNOWLEDGE, LIBRARY, PLAYSONG, WAVE, changed


def offering(do: str) -> Knowledge:
    frame = Frame(key="Tea.g1", type="g", texts={"en": "Shall I?"}, do=do)
    return changed("Tea", frames=(frame,))


def codes(knowledge: Knowledge, library: Library = LIBRARY) -> list[tuple[str, str]]:
    return [(finding.code, finding.where) for finding in check_library(knowledge, library)]


def test_the_small_world_has_no_findings():
    assert check_library(KNOWLEDGE, LIBRARY) == []


def test_p001_an_intent_that_cannot_be_compiled():
    broken = msgspec.structs.replace(WAVE, triggers={"en": ("wave {",)})
    found = check_library(KNOWLEDGE, msgspec.structs.replace(LIBRARY, intents=(PLAYSONG, broken)))
    assert [finding.code for finding in found] == ["P001"]
    assert "wave" in found[0].where
    assert found[0].error


def test_intents_without_a_number_yet_are_checked_too():
    fresh = [msgspec.structs.replace(intent, number=0) for intent in LIBRARY.intents]
    assert codes(KNOWLEDGE, Library(intents=tuple(fresh))) == []


def test_d025_a_proposal_of_an_unknown_intent():
    assert codes(offering("dance")) == [("D025", "Tea.g1")]


def test_d026_a_proposal_with_an_unknown_parameter():
    assert codes(offering("playsong singer=ABBA title=Waterloo")) == [("D026", "Tea.g1")]
    hint = check_library(offering("wave what=hand"), LIBRARY)[0].hint
    assert hint == "It knows no parameters."


@pytest.mark.parametrize("do", ["playsong title=Waterloo", "playsong", "wave", ""])
def test_a_proposal_of_a_known_intent_is_right(do):
    assert codes(offering(do)) == []


def test_a_proposal_that_cannot_be_read_is_left_to_d018():
    assert codes(offering("playsong title")) == []
