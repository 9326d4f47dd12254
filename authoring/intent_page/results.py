"""What an intent's stored tests and the checks of the library say."""

from collections import Counter
from dataclasses import dataclass

from authoring.intent_page.draft_library import Compiled, draft_library
from authoring.intent_page.posted import Posted
from plans.engine.library_lint import lint
from plans.engine.stored_tests import run_stored_tests


@dataclass(frozen=True, slots=True)
class Mark:
    """What became of one stored test; `reason` says why it failed, "" where it passed."""

    name: str
    language: str
    sentence: str
    reason: str


@dataclass(frozen=True, slots=True)
class Told:
    """A remark of the checks: about which language ("" for all), and whether it is an error."""

    language: str
    text: str
    error: bool


def key_of(compiled: Compiled, number: int) -> str:
    """Return the key of an intent in a library, "" where it had to be left out."""
    intent = compiled.catalogue.by_number.get(number)
    return intent.key if intent else ""


def test_marks(posted: Posted, compiled: Compiled) -> list[Mark]:
    """Return the result of each stored test of a form."""
    reasons = _reasons(compiled, key_of(compiled, posted.intent.number))
    return [
        Mark(line.name, line.language, line.text, reasons.get((line.language, line.text), ""))
        for line in posted.tests
    ]


def _reasons(compiled: Compiled, key: str) -> dict[tuple[str, str], str]:
    if not key:
        return {}
    tested = run_stored_tests(compiled.library, compiled.catalogue, intents=[key])
    return {
        (failure.language, failure.sentence): failure.reason
        for speech in tested
        for failure in speech.failures
    }


def remarks(compiled: Compiled, number: int) -> list[Told]:
    """Return what the checks say of an intent, the errors first."""
    key = key_of(compiled, number)
    if not key:
        return []
    found = lint(compiled.library, compiled.catalogue, intents=[key])
    return [Told(one.language, one.text, one.error) for one in found]


def failing_tests() -> dict[int, int]:
    """Return for each intent of the draft how many of its stored tests fail."""
    compiled = draft_library()
    failing: Counter[int] = Counter()
    for speech in run_stored_tests(compiled.library, compiled.catalogue):
        failing[speech.intent.number] += len(speech.failures)
    return dict(failing)


def failures(compiled: Compiled, number: int) -> list[Mark]:
    """Return the stored tests of an intent of a library that fail."""
    found = _reasons(compiled, key_of(compiled, number))
    return [Mark("", language, sentence, why) for (language, sentence), why in found.items()]
