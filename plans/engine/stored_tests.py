"""Run the tests that are stored with the intents, and say in words why one failed."""

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass

from languages.known import LANGUAGES
from plans.engine.catalogue import Catalogue, IntentMatch
from plans.engine.intents import Intent, IntentTest, Library
from plans.engine.reading import units_of
from plans.engine.templates import sentence_keys
from plans.engine.trigger_samples import Phrases, parsed, phrases_of, words_of


@dataclass(frozen=True, slots=True)
class Failure:
    """A stored test that failed: the sentence, and the reason in words."""

    intent: str
    language: str
    sentence: str
    reason: str


@dataclass(frozen=True, slots=True)
class TestedSpeech:
    """One intent in one language: how much is written, and what became of its tests."""

    __test__ = False  # pytest: this is no test.

    intent: Intent
    language: str
    triggers: int
    plan_sentences: int
    positive: int
    must_not_match: int
    failures: tuple[Failure, ...]

    @property
    def passed(self) -> int:
        """Return how many tests passed."""
        return self.positive + self.must_not_match - len(self.failures)


def run_stored_tests(
    library: Library,
    catalogue: Catalogue,
    *,
    intents: Collection[str] = (),
    languages: Collection[str] = (),
) -> tuple[TestedSpeech, ...]:
    """Run all tests of the library, or those of some intents and languages.

    A positive test must win over all intents with exactly its parameters; one that must not match
    may match any other intent.
    """
    codes = [code for code in LANGUAGES if code in (languages or LANGUAGES)]
    phrases = {code: phrases_of(library, code) for code in codes}
    return tuple(
        _tested(intent, code, catalogue, phrases[code])
        for intent in library.intents
        if intent.key in (intents or catalogue.intents)
        for code in codes
    )


def _tested(intent: Intent, language: str, catalogue: Catalogue, phrases: Phrases) -> TestedSpeech:
    tests = intent.tests.get(language, ())
    refused = sum(test.parameters is None for test in tests)
    return TestedSpeech(
        intent=intent,
        language=language,
        triggers=len(intent.triggers.get(language, ())),
        plan_sentences=len(intent.plan_sentences.get(language, ())),
        positive=len(tests) - refused,
        must_not_match=refused,
        failures=tuple(_failures(intent, language, catalogue, phrases)),
    )


def _failures(
    intent: Intent, language: str, catalogue: Catalogue, phrases: Phrases
) -> Iterator[Failure]:
    for test in intent.tests.get(language, ()):
        match = catalogue.match(test.sentence, language)
        reason = _reason(intent, test, match)
        if match is None and reason:
            reason += _nearest(intent, language, test.sentence, phrases)
        if reason:
            yield Failure(intent.key, language, test.sentence, reason)


def _reason(intent: Intent, test: IntentTest, match: IntentMatch | None) -> str:
    """Return why the test failed, "" where it passed."""
    own = match is not None and match.intent.key == intent.key
    if test.parameters is None:
        return f"matched by '{match.trigger}', must not match" if match and own else ""
    if match is None:
        return "nothing matched"
    if not own:
        return f"matched {match.intent.key} by '{match.trigger}' instead ({match.why})"
    if match.parameters != test.parameters:
        wanted = _pairs(test.parameters)
        return f"captured {_pairs(match.parameters)}, expected {wanted} (by '{match.trigger}')"
    return ""


def _pairs(parameters: Mapping[str, str]) -> str:
    return ", ".join(f"{name}={value}" for name, value in parameters.items()) or "nothing"


def _nearest(intent: Intent, language: str, sentence: str, phrases: Phrases) -> str:
    """Return the trigger that shares most with the sentence, as the end of a reason."""
    spaced = LANGUAGES[language].spaced
    heard = sentence_keys(units_of(sentence, LANGUAGES[language]), spaced)
    best, most = "", 0.0
    for trigger in intent.triggers.get(language, ()):
        units = (units_of(word, LANGUAGES[language]) for word in words_of(parsed(trigger), phrases))
        keys = frozenset().union(*(sentence_keys(each, spaced) for each in units))
        shared = 2 * len(keys & heard) / (len(keys) + len(heard))
        if shared > most:
            best, most = trigger, shared
    return f"; nearest is '{best}'" if best else ""
