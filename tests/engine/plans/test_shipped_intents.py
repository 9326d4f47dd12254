"""Every stored test of content/intents.yaml passes, and ordinary talk asks for nothing."""

import pytest

from languages.known import LANGUAGES as KNOWN
from plans.engine.fill import slots_in
from plans.engine.intents import Intent
from tests.engine.plans.chat import CHAT
from tests.engine.plans.shipped import LANGUAGES, catalogue, library

INTENTS = {intent.key: intent for intent in library().intents}
PAIRS = [(key, language) for key in INTENTS for language in LANGUAGES]


@pytest.mark.parametrize(("key", "language"), PAIRS)
def test_stored_tests_pass(key: str, language: str) -> None:
    for test in INTENTS[key].tests[language]:
        match = catalogue().match(test.sentence, language)
        found = match.parameters if match and match.intent.key == key else None
        assert found == test.parameters, test.sentence


@pytest.mark.parametrize("language", LANGUAGES)
def test_answers_to_open_questions_ask_for_nothing(language: str) -> None:
    matches = [(line, catalogue().match(line, language)) for line in CHAT[language]]
    asked = [line for line, match in matches if match and match.intent.plan]
    assert asked == []


@pytest.mark.parametrize(("key", "language"), PAIRS)
def test_every_intent_is_written_whole(key: str, language: str) -> None:
    intent = INTENTS[key]
    tests = intent.tests[language]
    refused = [test for test in tests if test.parameters is None]
    assert len(intent.triggers[language]) >= 8
    assert 3 <= len(intent.plan_sentences[language]) <= 5
    assert len(tests) >= 12
    assert len(refused) * 5 >= len(tests)


@pytest.mark.parametrize("intent", INTENTS.values(), ids=INTENTS.keys())
def test_something_can_be_said_without_any_slot_and_culture(intent: Intent) -> None:
    for sentences in intent.plan_sentences.values():
        assert any(not slots_in(each.text) and not each.only for each in sentences)


def test_every_language_is_written() -> None:
    assert set(LANGUAGES) == set(KNOWN)


def test_a_cry_for_help_wins_over_everything() -> None:
    assert max(INTENTS.values(), key=lambda intent: intent.priority).key == "need_help"
