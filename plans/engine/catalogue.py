"""The compiled library: it knows which intent a sentence means."""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from languages.known import LANGUAGES
from plans.engine.intent_checks import library_problems
from plans.engine.intents import Intent, Library
from plans.engine.matchers.known import MATCHERS
from plans.engine.matchers.matcher import Candidate, Matcher
from plans.engine.matchers.patterns_compiler import CANNOT
from plans.engine.problems import LibraryError, Problem

__all__ = ["Catalogue", "IntentMatch", "LibraryError", "Problem", "compile_catalogue"]


#: Where a sentence is cut, and the priority from which a clause is then enough: punctuation for
#: wishes about the talk (80), conjunctions for safety (100) only.
_CLAUSES = (
    (re.compile(r"[,.;:!?、。；！？…]+\s*"), 80),
    (re.compile(r"[,.;:!?、。；！？…]+\s*|\s(?:and|but|e|ma)\s"), 100),
)
MOST_CLAUSES = 8


@dataclass(frozen=True, slots=True)
class IntentMatch:
    """The best intent for a sentence; `parameters` in the person's spelling or canonical.

    `score` compares with other matches of the same sentence only; `runner_up` is the key of the
    next best intent, "" where no other fits.
    """

    intent: Intent
    trigger: str
    parameters: dict[str, str]
    score: tuple[int, ...]
    runner_up: str
    why: str


@dataclass(frozen=True, slots=True)
class Catalogue:
    """All intents of a library, ready to be matched; never changes.

    `cannot` holds what is said where the robot lacks an action: "do" in general, "alert" for that
    one -> language -> sentences.
    """

    intents: Mapping[str, Intent]
    by_number: Mapping[int, Intent]
    matchers: Mapping[str, tuple[Matcher, ...]]
    cannot: Mapping[str, Mapping[str, tuple[str, ...]]]

    def match(self, sentence: str, language: str) -> IntentMatch | None:
        """Return what the sentence asks for, or None for ordinary talk.

        An unknown language matches nothing. Where the whole sentence asks for nothing, one clause
        is enough for safety and for wishes about the talk: "I am so tired, I want to die".
        """
        return self._match_whole(sentence, language) or self._match_clause(sentence, language)

    def _match_clause(self, sentence: str, language: str) -> "IntentMatch | None":
        for splitter, priority in _CLAUSES:
            clauses = [part for part in splitter.split(sentence)[:MOST_CLAUSES] if part.strip()]
            if len(clauses) > 1:
                matches = (self._match_whole(clause, language) for clause in clauses)
                pressing = [one for one in matches if one and one.intent.priority >= priority]
                if pressing:
                    return max(pressing, key=lambda match: match.intent.priority)
        return None

    def _match_whole(self, sentence: str, language: str) -> "IntentMatch | None":
        for matcher in self.matchers.get(language, ()):
            candidates = matcher.find(sentence)
            if candidates:
                return _best(candidates)
        return None


def compile_catalogue(library: Library) -> Catalogue:
    """Compile a library; raises LibraryError listing all its problems."""
    problems = list(library_problems(library, frozenset(LANGUAGES)))
    if problems:
        raise LibraryError(tuple(problems))
    matchers = {
        code: tuple(build(library, language, problems) for build in MATCHERS)
        for code, language in LANGUAGES.items()
    }
    if problems:
        raise LibraryError(tuple(problems))
    return Catalogue(
        intents=MappingProxyType({intent.key: intent for intent in library.intents}),
        by_number=MappingProxyType({intent.number: intent for intent in library.intents}),
        matchers=MappingProxyType(matchers),
        cannot=MappingProxyType(_cannot(library)),
    )


def _best(candidates: tuple[Candidate, ...]) -> IntentMatch:
    ranked = sorted(candidates, key=lambda candidate: candidate.score, reverse=True)
    first = ranked[0]
    others = (each for each in ranked if each.intent.key != first.intent.key)
    second = next(others, None)
    return IntentMatch(
        intent=first.intent,
        trigger=first.trigger,
        parameters=first.parameters,
        score=first.score,
        runner_up=second.intent.key if second else "",
        why=_why(first, second),
    )


def _why(first: Candidate, second: Candidate | None) -> str:
    words = f"'{first.trigger}' fits with {first.score[1]} literal units"
    if second is None:
        return f"{words}; no other intent fits"
    reasons = ("priority", "literal units", "listed values", "fewer free slots", "shorter slots")
    pairs = zip(reasons, first.score, second.score, strict=True)
    reason = next((name for name, one, two in pairs if one != two), "its place in the library")
    return f"{words}; it wins over '{second.trigger}' of {second.intent.key} by {reason}"


def _cannot(library: Library) -> dict[str, Mapping[str, tuple[str, ...]]]:
    return {
        phrase.key.removeprefix(CANNOT): MappingProxyType(
            {language: _sentences(text) for language, text in phrase.texts.items()}
        )
        for phrase in library.phrases
        if phrase.key.startswith(CANNOT)
    }


def _sentences(text: str) -> tuple[str, ...]:
    return tuple(sentence.strip() for sentence in text.split("|") if sentence.strip())
