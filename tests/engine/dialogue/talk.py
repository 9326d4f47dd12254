"""Talk with the small world: hear a sentence, see which sentences were chosen and why."""

from random import Random

from dialogue.engine.content import Content
from dialogue.engine.manager import Reply, reply
from dialogue.engine.state import DialogueState
from dialogue.engine.tree import Node
from dialogue.engine.turn import Heard, Turn
from plans.engine.manager import Action
from tests.engine.dialogue.world import NUMBERS, WORLD


class Same(Random):
    """Chance that always draws the same: 0.0 the first, 0.99 the last."""

    def __init__(self, drawn: float) -> None:
        super().__init__(1)
        self.drawn = drawn

    def random(self) -> float:
        return self.drawn

    def randrange(self, start: int, *_more: int) -> int:
        return min(int(self.drawn * start), start - 1)


def node(key: str) -> Node:
    return WORLD.tree.by_key[key]


def mrs_smith(topic: str = "", **fields: object) -> DialogueState:
    """Return the state of a talk that has got to a topic."""
    started = {"topic": NUMBERS[topic], "topics": (NUMBERS[topic],)} if topic else {}
    usual = {"language": "en", "culture": "EN", "seed": 7, "turn": 5, "last_type": "c"}
    return DialogueState(**{**usual, **started, **fields})  # type: ignore[arg-type]


def hear(state: DialogueState, sentence: str, *actions: Action, **more: object) -> Reply:
    """Return the explained reply to a sentence and the actions of its KBplan."""
    content = more.pop("content", WORLD)
    assert isinstance(content, Content)
    heard = Heard(sentence, actions, explain=True, **more)  # type: ignore[arg-type]
    return reply(content, state, heard)


def act(action: str, **parameters: str | None) -> Action:
    return Action(action, parameters)


def turn_in(
    state: DialogueState, *, content: Content = WORLD, chance: float | int = 0.0, **heard: object
) -> Turn:
    """Return a turn to try parts of the engine on."""
    asked = Heard(**{"sentence": "", "explain": True, **heard})  # type: ignore[arg-type]
    return Turn(content, state, asked, Same(chance))


def lines_said(before: DialogueState, answer: Reply, content: Content = WORLD) -> list[str]:
    """Return the keys of the sentences of a turn, such as ["acknowledge.1", "Tea.c1"]."""
    new = answer.state.frames[len(before.frames) :]
    return [content.tree.lines[number].key for number in new]


def kinds_said(before: DialogueState, answer: Reply, content: Content = WORLD) -> list[str]:
    """Return pools and types in order, such as ["acknowledge", "c"]."""
    new = answer.state.frames[len(before.frames) :]
    return [content.tree.lines[number].type for number in new]


def rules(answer: Reply) -> list[str]:
    """Return the rules that fired, such as ["learn", "say"]."""
    return [step.rule for step in answer.steps]
