"""The talk of the test chat: begun, continued and replayed on any content; nothing is stored."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from dialogue.engine.content import Content
from dialogue.engine.manager import Reply, reply
from dialogue.engine.state import DialogueState
from dialogue.engine.turn import Heard
from dialogue.turns import TurnAnswer, chosen, first_turn, take_turn
from plans.engine.manager import Action, PlanAnswer

MOST_TURNS = 100


class UnknownTopicError(LookupError):
    """The topic the talk should begin with is not in the content."""


@dataclass(frozen=True, slots=True)
class Talk:
    """How a talk is had.

    `seed` 1..2**32-1 makes it reproducible; `topic` is the key it begins with, "" for none;
    `capabilities` are the actions the robot can do, None for a robot that names none.
    """

    language: str
    culture: str
    seed: int
    topic: str = ""
    capabilities: tuple[str, ...] | None = None


@dataclass(frozen=True, slots=True)
class Exchange:
    """One turn: what was heard ("" for the opening), the state before, what both managers made."""

    heard: str
    before: DialogueState | None
    understood: PlanAnswer
    reply: Reply

    @property
    def plan(self) -> PlanAnswer:
        """Return the plan the robot gets."""
        return TurnAnswer(self.understood, self.reply).plan


def begin(content: Content, talk: Talk, *, explain: bool = False) -> Exchange:
    """Return the opening of a talk. Raises UnknownChoiceError or UnknownTopicError."""
    opening = first_turn(content, talk.language, talk.culture, talk.seed)
    if not talk.topic:
        return Exchange("", None, PlanAnswer(), opening)
    if talk.topic not in content.tree.by_key:
        raise UnknownTopicError(talk.topic)
    jump = (Action("jump", {"topic": talk.topic}),)
    heard = Heard(
        "", kbplan_actions=jump, capabilities=talk.capabilities, plan_said=True, explain=explain
    )
    return Exchange("", None, PlanAnswer(), reply(content, opening.state, heard))


def proceed(
    content: Content, talk: Talk, state: DialogueState, sentence: str, *, explain: bool = False
) -> Exchange:
    """Return the next turn of a talk."""
    taken = take_turn(content, state, sentence, capabilities=talk.capabilities, explain=explain)
    return Exchange(sentence, state, taken.understood, taken.reply)


def replay(
    content: Content, talk: Talk, sentences: Iterable[str], *, explain: bool = False
) -> Iterator[Exchange]:
    """Yield the opening and the turns of a whole talk. Raises as `begin` does."""
    turn = begin(content, talk, explain=explain)
    yield turn
    for sentence in sentences:
        turn = proceed(content, talk, turn.reply.state, sentence, explain=explain)
        yield turn


def settled(content: Content, talk: Talk) -> Talk:
    """Return the talk with its language and culture as codes. Raises UnknownChoiceError."""
    language, culture = chosen(content, talk.language, talk.culture)
    return Talk(language, culture, talk.seed, talk.topic, talk.capabilities)
