"""The compiled library: it knows which intent a sentence means."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType

from languages.known import LANGUAGES
from plans.engine.intent_checks import library_problems
from plans.engine.intents import Intent, Library
from plans.engine.matchers.known import MATCHERS
from plans.engine.matchers.matcher import Candidate, Matcher, Way
from plans.engine.problems import LibraryError, Problem
from plans.engine.sayings import Sayings, sayings_of

__all__ = ["Catalogue", "IntentMatch", "LibraryError", "Problem", "compile_catalogue"]


#: Where a sentence is cut, and the priority from which a clause is then enough: punctuation for
#: wishes about the talk, conjunctions for safety only.
WISHES, SAFETY = 80, 100
_PUNCTUATION = re.compile(r"[,.;:!?、。；！？…]+\s*")
_CONJUNCTIONS = re.compile(r"[,.;:!?、。；！？…]+\s*|\s(?:and|but|because|e|ma|perché)\s")
_CLAUSES = ((_CONJUNCTIONS, SAFETY), (_PUNCTUATION, WISHES))
MOST_CLAUSES = 8
SHORTEST_CLAUSE = 3  # "Eh, è una storia lunga" does not ask for a repetition.
#: Ways to find what free words have swallowed, and the literal words that may then be wrong.
_SWALLOWED = ((Way.FILLERS, 0), (Way.SPELLING, 1))
_FREE = 3  # Where a score tells the slots of free text.


@dataclass(frozen=True, slots=True)
class IntentMatch:
    """The best intent for a sentence; `parameters` in the person's spelling or canonical.

    `score` compares with other matches of the same sentence only; `runner_up` is the key of the
    next best intent, "" where no other fits. `way` says what had to be forgiven: "words" (nothing),
    "clause", "fillers", "spelling", or "suggestion", which is asked about and never acted on.
    """

    intent: Intent
    trigger: str
    parameters: dict[str, str]
    score: tuple[int, ...]
    runner_up: str
    why: str
    way: str = Way.WORDS.value


@dataclass(frozen=True, slots=True)
class Catalogue:
    """All intents of a library, ready to be matched; never changes.

    `sayings` holds what the agent says about plans in general: key -> language -> sentences.
    """

    intents: Mapping[str, Intent]
    by_number: Mapping[int, Intent]
    matchers: Mapping[str, tuple[Matcher, ...]]
    sayings: Sayings

    def match(self, sentence: str, language: str) -> IntentMatch | None:
        """Return what the sentence asks for, or None for ordinary talk.

        An unknown language matches nothing. Where the whole sentence asks for nothing, one clause
        is enough for safety and for wishes about the talk: "I am so tired, I want to die". Only
        then are fillers left out ("play, you know, Volare"), and only then is spelling mended.
        """
        found = self._match_strictly(sentence, language)
        if found is None:
            found = self._match_whole(sentence, language, Way.FILLERS) or self._match_whole(
                sentence, language, Way.SPELLING
            )
        elif found.score[_FREE] and found.way == Way.WORDS:
            found = self._without_swallowed(found, sentence, language)
        if found is not None:
            self.forget(language)
        return found

    def _without_swallowed(self, found: IntentMatch, sentence: str, language: str) -> IntentMatch:
        """Return another intent that free words have swallowed, or the same.

        "Set an alarm, maybe" is no song called "an alarm maybe", and "call the polce" no call.
        The other must say more even without the word that is mended.
        """
        priority, literal = found.score[:2]
        # Without spaces a mended character is no proof of another word.
        for way, uncertain in _SWALLOWED if LANGUAGES[language].spaced else _SWALLOWED[:1]:
            other = self._match_whole(sentence, language, way)
            if (
                other is not None
                and other.intent is not found.intent
                and other.score[0] >= priority
                and other.score[1] > literal + uncertain
            ):
                return other
        return found

    def suggest(self, sentence: str, language: str) -> IntentMatch | None:
        """Return what a sentence that matches nothing may have been meant to ask, or None.

        For questions only ("Did you want me to play a song?"): unknown words stand in the way, a
        word is missing, or the spelling is too uncertain to act on.
        """
        found = self._match_whole(sentence, language, Way.SUGGESTION)
        self.forget(language)
        return found

    def forget(self, language: str) -> None:
        """Keep nothing of what was said; `suggest` and a match do this by themselves."""
        for matcher in self.matchers.get(language, ()):
            matcher.forget()

    def prepare(self) -> None:
        """Build now what is else built when a sentence needs it: forked workers then share it."""
        for matchers in self.matchers.values():
            for matcher in matchers:
                matcher.prepare()

    def _match_strictly(self, sentence: str, language: str) -> IntentMatch | None:
        whole = self._match_whole(sentence, language, Way.WORDS)
        if whole is None:
            return next(self._clauses(sentence, language), None)
        # A free slot may have swallowed a cry for help: "play Yesterday, I can't breathe".
        for value in whole.parameters.values():
            for pressing in self._clauses(value, language):
                if pressing.intent.priority >= SAFETY > whole.intent.priority:
                    return pressing
        return whole

    def _clauses(self, sentence: str, language: str) -> Iterator[IntentMatch]:
        """Yield what a clause alone is enough for, safety first."""
        for splitter, priority in _CLAUSES:
            parts = splitter.split(sentence)[:MOST_CLAUSES]
            clauses = [part for part in parts if len(part.strip()) >= SHORTEST_CLAUSE]
            if len(parts) > 1:
                matches = (self._match_whole(clause, language, Way.WORDS) for clause in clauses)
                pressing = [one for one in matches if one and one.intent.priority >= priority]
                if pressing:
                    best = max(pressing, key=lambda match: match.intent.priority)
                    yield replace(best, way=Way.CLAUSE.value)

    def _match_whole(self, sentence: str, language: str, way: Way) -> IntentMatch | None:
        for matcher in self.matchers.get(language, ()):
            candidates = matcher.find(sentence, way)
            if candidates:
                return _best(candidates, way)
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
        sayings=sayings_of(library),
    )


def _best(candidates: tuple[Candidate, ...], way: Way) -> IntentMatch:
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
        way=way.value,
    )


def _why(first: Candidate, second: Candidate | None) -> str:
    words = f"'{first.trigger}' fits with {first.score[1]} words of its own"
    if first.change:
        words = f"{first.change}; {words}"
    if second is None:
        return f"{words}; no other intent fits"
    reasons = ("priority", "words of its own", "listed values", "fewer free slots", "shorter slots")
    pairs = zip(reasons, first.score, second.score, strict=True)
    reason = next((name for name, one, two in pairs if one != two), "its place in the library")
    return f"{words}; it wins over '{second.trigger}' of {second.intent.key} by {reason}"
