"""What a regression conversation holds of each turn, and whether a reply keeps it: pure values."""

from typing import Final, Literal

import msgspec

from authoring.chat.replaying import Exchange
from languages.known import LANGUAGES
from languages.language import Language

EXACT: Final = "exact"
TOPIC: Final = "topic"
PLAN: Final = "plan"
WORDS: Final = "words"
ANY: Final = "any"
Kind = Literal["exact", "topic", "plan", "words", "any"]
LONGEST_EXPECTED = 300


class Said(msgspec.Struct, frozen=True):
    """A reply: the plan sentence, the plan ("" for none), the sentence, its topic and type."""

    plan_sentence: str = ""
    plan: str = ""
    sentence: str = ""
    topic: str = ""
    type: str = ""

    def text(self, language: str) -> str:
        """Return all that is said aloud."""
        known = LANGUAGES.get(language)
        blank = " " if known is None or known.spaced else ""
        return blank.join(part for part in (self.plan_sentence, self.sentence) if part)


class Turn(msgspec.Struct, frozen=True):
    """One turn as it was found right; `heard` is "" for the opening.

    `kind` says what must hold: EXACT the same reply, TOPIC and PLAN the `value`, WORDS all words
    or phrases of `value` (apart by commas), ANY nothing.
    """

    heard: str
    said: Said
    kind: Kind = EXACT
    value: str = ""


def said_in(turn: Exchange) -> Said:
    """Return the reply of a turn."""
    plan = turn.plan
    return Said(
        plan_sentence=plan.plan_sentence,
        plan=plan.plan,
        sentence=turn.reply.sentence,
        topic=turn.reply.topic,
        type=turn.reply.sentence_type,
    )


def holds(expected: Turn, now: Said, language: str) -> bool:
    """Say whether a reply keeps what must hold."""
    if expected.kind == EXACT:
        return _heard(expected.said) == _heard(now)
    if expected.kind == TOPIC:
        return now.topic == expected.value
    if expected.kind == PLAN:
        return _plan(now.plan) == _plan(expected.value)
    return not missing_words(expected, now, language)


def _heard(said: Said) -> tuple[str, str, str]:
    """Return what a person notices: the topic's key and the type may change behind it."""
    return said.plan_sentence, said.plan, said.sentence


def _plan(text: str) -> str:
    return " ".join(text.split())


def missing_words(expected: Turn, now: Said, language: str) -> tuple[str, ...]:
    """Return the words or phrases that must come and do not; none where no words are expected."""
    if expected.kind != WORDS:
        return ()
    known = LANGUAGES.get(language)
    text = _spelled(now.text(language), known)
    return tuple(each for each in wanted_words(expected.value) if _spelled(each, known) not in text)


def wanted_words(value: str) -> list[str]:
    """Return the words or phrases of a list with commas (、 in Japanese)."""
    return [part.strip() for part in value.replace("、", ",").split(",") if part.strip()]


def _spelled(text: str, known: Language | None) -> str:
    """Return the text in one spelling, between blanks so that words are whole words."""
    if known is None:
        return text.casefold()
    blank = " " if known.spaced else ""
    return blank + blank.join(token.text for token in known.tokens(text)) + blank


def accepted(expected: Turn, now: Said) -> Turn:
    """Return the turn with the new reply taken as right."""
    if expected.kind == TOPIC:
        return Turn(expected.heard, now, TOPIC, now.topic)
    if expected.kind == PLAN:
        return Turn(expected.heard, now, PLAN, now.plan)
    if expected.kind == ANY:
        return Turn(expected.heard, now, ANY)
    return Turn(expected.heard, now)
