"""Ordinary talk is hardly ever asked about and never acted on."""

from functools import cache

import msgspec
import pytest

from plans.engine.catalogue import Catalogue, compile_catalogue
from plans.engine.intents import Phrase
from tests.engine.plans.chat import CHAT
from tests.engine.plans.shipped import LANGUAGES, library
from tests.engine.plans.small_talk import SMALL_TALK

MOST_ASKED = 0.005
FILLERS = {
    "en": "just|like|well|you know|kindly|maybe|I mean",
    "it": "cioè|magari|diciamo|insomma|tipo",
    "ja": "ちょっと|まあ|なんか|その|あの",
}


@cache
def catalogue() -> Catalogue:
    whole = library()
    keys = {phrase.key for phrase in whole.phrases}
    fillers = () if "fillers" in keys else (Phrase(key="fillers", texts=FILLERS),)
    return compile_catalogue(msgspec.structs.replace(whole, phrases=(*whole.phrases, *fillers)))


def lines(language: str) -> list[str]:
    return CHAT[language] + SMALL_TALK[language]


@pytest.mark.parametrize("language", LANGUAGES)
def test_there_is_talk_enough(language: str) -> None:
    assert len(set(lines(language))) >= 335


@pytest.mark.parametrize("language", LANGUAGES)
def test_talk_is_not_acted_on(language: str) -> None:
    matches = [(line, catalogue().match(line, language)) for line in lines(language)]
    # Thanks, feelings and pains are rightly heard in talk; nothing is done about them.
    acted = [(line, match.intent.key) for line, match in matches if match and match.intent.plan]
    assert acted == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_talk_is_hardly_asked_about(language: str) -> None:
    quiet = [line for line in lines(language) if catalogue().match(line, language) is None]
    suggested = [(line, catalogue().suggest(line, language)) for line in quiet]
    asked = [(line, each.intent.key) for line, each in suggested if each and each.intent.abilities]
    assert len(asked) <= MOST_ASKED * len(lines(language)), asked
