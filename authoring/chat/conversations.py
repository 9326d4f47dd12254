"""Regression conversations: saved, run on any content, accepted anew."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from hashlib import sha256

import msgspec
from django.core.exceptions import ValidationError
from django.db import transaction
from django.utils import timezone
from django.utils.translation import gettext as _

from authoring.chat.conversation_turns import (
    PLAN,
    TOPIC,
    WORDS,
    Said,
    Turn,
    accepted,
    holds,
    missing_words,
    said_in,
)
from authoring.chat.replaying import MOST_TURNS, Talk, UnknownTopicError, replay
from authoring.models.conversation import Conversation
from dialogue.engine.content import Content
from dialogue.turns import UnknownChoiceError

MOST_CONVERSATIONS = 300


@dataclass(frozen=True, slots=True)
class TurnResult:
    """One turn of a run: what was found right, what is said now, why it does not hold ("")."""

    expected: Turn
    now: Said
    passed: bool
    reason: str = ""

    @property
    def heard(self) -> str:
        """Return what the person says."""
        return self.expected.heard

    @property
    def before(self) -> Said:
        """Return what was said when the conversation was saved."""
        return self.expected.said


@dataclass(frozen=True, slots=True)
class Result:
    """What became of a conversation; `turns` is empty where it could not even begin."""

    id: int
    title: str
    passed: bool
    turns: tuple[TurnResult, ...] = ()
    reason: str = ""

    @property
    def digest(self) -> str:
        """Return a digest of all replies, to see whether what is accepted is what was shown."""
        replies = msgspec.json.encode([turn.now for turn in self.turns])
        return sha256(replies).hexdigest()


def talk_of(row: Conversation) -> Talk:
    """Return how the talk of a conversation is had."""
    able = None if row.capabilities is None else tuple(row.capabilities)
    return Talk(row.language, row.culture, row.seed, row.topic, able)


def turns_of(row: Conversation) -> tuple[Turn, ...]:
    """Return the turns of a conversation, the opening first."""
    return msgspec.convert(row.turns, tuple[Turn, ...])


def run(content: Content, row: Conversation) -> Result:
    """Have the talk of a conversation again; nothing is stored."""
    try:
        expected = turns_of(row)
        sentences = [turn.heard for turn in expected[1:]]
        exchanges = list(replay(content, talk_of(row), sentences))
    except msgspec.ValidationError:
        reason = _("It is stored in a form that cannot be read. Delete it and save it again.")
        return Result(row.pk, row.title, passed=False, reason=reason)
    except UnknownTopicError:
        reason = _("It begins with the topic %(key)s, which is gone.") % {"key": row.topic}
        return Result(row.pk, row.title, passed=False, reason=reason)
    except UnknownChoiceError:
        reason = _("Its culture %(code)s or its language is gone.") % {"code": row.culture}
        return Result(row.pk, row.title, passed=False, reason=reason)
    pairs = zip(expected, exchanges, strict=True)
    turns = tuple(judged(turn, said_in(one), row.language) for turn, one in pairs)
    failed = [turn for turn in turns if not turn.passed]
    return Result(row.pk, row.title, not failed, turns, failed[0].reason if failed else "")


def judged(expected: Turn, now: Said, language: str) -> TurnResult:
    """Return whether a reply keeps what must hold, and why not."""
    if holds(expected, now, language):
        return TurnResult(expected, now, passed=True)
    return TurnResult(expected, now, passed=False, reason=_reason(expected, now, language))


def _reason(expected: Turn, now: Said, language: str) -> str:
    nothing = _("none")
    words = {"wanted": expected.value or nothing}
    if expected.kind == TOPIC:
        text = _("The topic should be %(wanted)s; it is %(now)s.")
        return text % {**words, "now": now.topic or nothing}
    if expected.kind == PLAN:
        text = _("The plan should be %(wanted)s; it is %(now)s.")
        return text % {**words, "now": now.plan or nothing}
    if expected.kind == WORDS:
        missing = ", ".join(missing_words(expected, now, language))
        return _("These words are missing: %(words)s.") % {"words": missing}
    if expected.said.plan != now.plan:
        return _("The robot does something else.")
    return _("The robot says something else.")


def run_all(
    content: Content, *, write: bool = False, only: Iterable[int] | None = None
) -> tuple[Result, ...]:
    """Run all conversations (or some, by number) and return what became of each.

    One query; the database is only written to where `write` is true.
    """
    rows = Conversation.objects.all()
    chosen = list(rows if only is None else rows.filter(pk__in=tuple(only)))
    results = tuple(run(content, row) for row in chosen)
    if write:
        _note(content, chosen, results)
    return results


def _note(content: Content, rows: Sequence[Conversation], results: Sequence[Result]) -> None:
    now = timezone.now()
    for row, result in zip(rows, results, strict=True):
        row.passed, row.ran, row.ran_on = result.passed, now, content.number
    Conversation.objects.bulk_update(rows, ["passed", "ran", "ran_on"], batch_size=100)


@dataclass(frozen=True, slots=True)
class About:
    """What is kept with a conversation: its title, a note for colleagues, who saved it."""

    title: str
    note: str = ""
    author: int | None = None


def save(content: Content, talk: Talk, turns: Sequence[Turn], about: About) -> Conversation:
    """Keep a talk as a regression conversation. Raises ValidationError with what to do."""
    if not 1 <= len(turns) <= MOST_TURNS + 1:
        text = _("A conversation has at most %(most)s turns.")
        raise ValidationError(text % {"most": MOST_TURNS})
    row = Conversation(
        title=about.title.strip(),
        note=about.note.strip(),
        language=talk.language,
        culture=talk.culture,
        seed=talk.seed,
        topic=talk.topic,
        capabilities=None if talk.capabilities is None else list(talk.capabilities),
        turns=msgspec.to_builtins(list(turns)),
        created_by_id=about.author,
        passed=all(holds(turn, turn.said, talk.language) for turn in turns),
        ran=timezone.now(),
        ran_on=content.number,
    )
    row.full_clean()
    with transaction.atomic():
        if Conversation.objects.count() >= MOST_CONVERSATIONS:
            text = _("There are %(most)s conversations already. Delete one you no longer need.")
            raise ValidationError(text % {"most": MOST_CONVERSATIONS})
        row.save()
    return row


class ChangedMeanwhileError(RuntimeError):
    """The replies are no longer those that the person looked at."""


def accept(content: Content, number: int, seen: str, turn: int | None = None) -> Result:
    """Take the replies of one turn (None: of all that fail) as right from now on.

    `seen` is the digest of the result the person looked at. Raises ChangedMeanwhileError,
    Conversation.DoesNotExist.
    """
    with transaction.atomic():
        row = Conversation.objects.select_for_update().get(pk=number)
        result = run(content, row)
        if result.digest != seen or not result.turns:
            raise ChangedMeanwhileError
        row.turns = msgspec.to_builtins(
            [
                accepted(one.expected, one.now)
                if not one.passed and turn in (None, place)
                else one.expected
                for place, one in enumerate(result.turns)
            ]
        )
        again = run(content, row)
        row.passed, row.ran, row.ran_on = again.passed, timezone.now(), content.number
        row.save()
    return again
