"""What can be wrong with one filled sentence: its ending, its length, and words a robot must avoid.

The codes are those of the quality bars: G1-G5 grammar and signs, S1 length, P1 persona.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass

from languages.lint_words import ADVICE, CHEERFUL, WORDS

#: Letters of sentence types that ask, and that do not; others (hands over, pools) may do both.
_ASKING = frozenset("qwg")
_TELLING = frozenset("pnct")

_WORDS_WISHED, _WORDS_MOST = 18, 22
_CHARACTERS_WISHED, _CHARACTERS_MOST = 50, 60
_GULPEASE_LEAST = 50
_QUESTION = re.compile("[?？]")
_CLOSING = "\"'”’»」』"


@dataclass(frozen=True, slots=True)
class Finding:
    """One thing an author should mend; `error` stops a publication, the rest is advice."""

    code: str
    message: str
    hint: str
    error: bool


def lint_sentence(text_filled: str, kind: str, language: str) -> tuple[Finding, ...]:
    """Return what is wrong with a filled sentence of a type ("q", "p" …), the worst first."""
    found = [
        *_lint_ending(text_filled, kind, language),
        *_lint_length(text_filled, language),
        *_lint_words(text_filled, language),
    ]
    return tuple(sorted(found, key=lambda finding: not finding.error))


def lint_health_sentence(text_filled: str, language: str) -> tuple[Finding, ...]:
    """Return the advice found in a sentence of the Health branch: should, devi, べき."""
    found = ADVICE[language].search(text_filled)
    if not found:
        return ()
    return (Finding("P1", f"{found.group()!r} is advice.", "The robot is no doctor.", error=True),)


def lint_gentle_sentence(text_filled: str, language: str) -> tuple[Finding, ...]:
    """Return the cheerful words found in a sentence of a gentle class: great, che bello."""
    found = CHEERFUL[language].search(text_filled)
    if not found:
        return ()
    hint = "Grief and illness want calm words."
    return (Finding("P1", f"{found.group()!r} is too cheerful here.", hint, error=True),)


def _lint_ending(text: str, kind: str, language: str) -> Iterator[Finding]:
    question, stops = ("？", "。！") if language == "ja" else ("?", ".!")
    last = text.rstrip(_CLOSING)[-1:]
    questions = len(_QUESTION.findall(text))
    if kind in _ASKING and last != question:
        yield Finding(
            "G5", "A question must end the sentence.", f"End it with {question}", error=True
        )
    elif kind in _TELLING and (last == "" or last not in stops or questions):
        hint = f"End it with {' or '.join(stops)} and ask nothing."
        yield Finding("G5", "This type states, it does not ask.", hint, error=True)
    elif not last or last not in question + stops:
        hint = f"End it with one of {question}{stops}"
        yield Finding("G5", "The sentence does not end.", hint, error=True)
    if questions > 1:
        yield Finding(
            "G5", "It asks more than one question.", "Ask one thing at a time.", error=True
        )


def _lint_length(text: str, language: str) -> Iterator[Finding]:
    if language == "ja":
        length, unit = len(text), "characters"
        wished, most = _CHARACTERS_WISHED, _CHARACTERS_MOST
    else:
        length, unit, wished, most = len(text.split()), "words", _WORDS_WISHED, _WORDS_MOST
    if length > wished:
        message = f"The sentence has {length} {unit}."
        yield Finding("S1", message, f"Stay below {wished} {unit}.", error=length > most)
    elif language == "it" and _gulpease(text) < _GULPEASE_LEAST:
        message = f"The sentence is hard to follow (Gulpease {_gulpease(text):.0f})."
        yield Finding("S1", message, "Use shorter words or two sentences.", error=False)


def _gulpease(text: str) -> float:
    """Return the Gulpease readability of an Italian text: 100 is easy, below 50 is hard."""
    words = max(1, len(text.split()))
    letters = sum(character.isalnum() for character in text)
    sentences = max(1, len(re.findall(r"[.!?](?:\s|$)", text)))
    return 89 + (300 * sentences - 10 * letters) / words


def _lint_words(text: str, language: str) -> Iterator[Finding]:
    for row in WORDS[language]:
        found = row.pattern.search(text)
        if found:
            message = f"{row.message}: {found.group()!r}."
            yield Finding(row.code, message, row.hint, error=row.error)
