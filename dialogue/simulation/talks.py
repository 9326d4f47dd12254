"""One simulated talk: deterministic by user, culture, language and seed."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from random import Random
from types import MappingProxyType

from dialogue.engine.content import Content
from dialogue.engine.manager import Reply, start
from dialogue.engine.state import RING, DialogueState
from dialogue.simulation.users import USERS, Hearing, Said
from dialogue.turns import TurnAnswer, take_turn

#: Rules of an explanation that tell that the person, not the agent, chose the topic.
_LED = frozenset({"keywords", "name", "urgent"})


@dataclass(frozen=True, slots=True)
class Cast:
    """Who talks: the kind of user, the culture and language, the seed."""

    user: str
    culture: str
    language: str
    seed: int


@dataclass(frozen=True, slots=True)
class Utterances:
    """Things people say that nobody tuned the agent to: topical ones, and mere chat."""

    topical: Sequence[str] = ()
    chat: Sequence[str] = ()


@dataclass(frozen=True, slots=True)
class Exchange:
    """One turn: what the user said, what came back, and how the talk moved.

    `frames` are the numbers of what was said, `led` tells that the person chose the topic,
    `matched` that what they said was recognised: as a topic, the present one, or an intent.
    """

    said: Said
    reply: Reply
    spoken: str
    before: int
    frames: tuple[int, ...]
    led: bool
    matched: bool
    pools: frozenset[str]


NO_UTTERANCES: Mapping[str, Utterances] = MappingProxyType({})


def talk(
    content: Content,
    cast: Cast,
    turns: int,
    utterances: Mapping[str, Utterances] = NO_UTTERANCES,
) -> Iterator[Exchange]:
    """Yield the turns of one talk; the same arguments give the same talk."""
    # A str seed: its hash does not change from one process to the next.
    chance = Random(f"{cast.user} {cast.culture} {cast.language} {cast.seed}")
    words = utterances.get(cast.language, Utterances())
    say: Callable[[Hearing], Said] = USERS[cast.user]
    reply = start(content, cast.language, cast.culture, cast.seed)
    for _ in range(turns):
        said = say(Hearing(reply, content, chance, words.topical, words.chat))
        state = reply.state
        taken = take_turn(content, state, said.text, explain=True)
        reply = taken.reply
        yield _exchange(said, taken, state)


def _exchange(said: Said, taken: TurnAnswer, before: DialogueState) -> Exchange:
    reply = taken.reply
    rules = {step.rule for step in reply.steps}
    separator = "" if before.language == "ja" else " "
    return Exchange(
        said=said,
        reply=reply,
        spoken=separator.join(filter(None, (taken.plan.plan_sentence, reply.sentence))),
        before=before.topic,
        frames=_new_frames(before.frames, reply.state.frames),
        led=bool(rules & _LED or taken.understood.kbplan_actions),
        matched=bool(taken.understood.intent or rules & {"keywords", "name", "stay"}),
        pools=frozenset(
            step.text.rpartition(" ")[2] for step in reply.steps if step.rule == "pool"
        ),
    )


def _new_frames(before: tuple[int, ...], after: tuple[int, ...]) -> tuple[int, ...]:
    """Return the frames that were added to the ring."""
    for count in range(len(after) + 1):
        new = after[len(after) - count :]
        if (before + new)[-RING:] == after:
            return new
    return after
