"""Invented content of any size, and states of people who have talked about any part of it."""

from collections import Counter
from random import Random

from msgspec.structs import replace

from benchmarks.tree import World
from dialogue.engine.concepts import Knowledge
from dialogue.engine.content import Content
from dialogue.engine.state import MAX_SLOT, TOPIC_RING, DialogueState

#: Branches, their groups and the classes below: what every invented tree has besides leaves.
SCAFFOLD = 16 + 16 * 3 + 16 * 6
FAN_OUT = 30
_CLASSES = 96
_TYPES = "cwqpn"
_LEVELS, _WEIGHTS = (0, 1, 2, 7, 10, 11), (2, 1, 1, 1, 2, 3)


class Talkative(World):
    """A world whose leaves have so many sentences of their own.

    No class has more than `fan_out` leaves: where there are more, it gets classes of its own.
    """

    def __init__(self, leaves: int, sentences: int, fan_out: int) -> None:
        self.types = (_TYPES * sentences)[:sentences]
        self.fan_out = fan_out
        self.leaves: Counter[str] = Counter()
        self.here = ""
        super().__init__(leaves, 0)

    def _leaf(self, parent: str) -> None:
        if self.leaves[parent] % self.fan_out == 0:
            self.here = self._topic(parent, f"Class{len(self.topics)}", "")
        self.leaves[parent] += 1
        self._topic(self.here, f"Leaf{len(self.topics)}", self.types)


def knowledge_of(topics: int, sentences: int = 2, fan_out: int = FAN_OUT) -> Knowledge:
    """Return about so many topics (352 at least), each leaf with so many sentences of its own."""
    leaves = _CLASSES * max(1, round((topics - SCAFFOLD - _CLASSES) / _CLASSES))
    return Talkative(leaves, sentences, fan_out).knowledge()


def sentences_a_topic(content: Content) -> float:
    """Return how many sentences a topic can say, inherited ones too, on average."""
    nodes = content.tree.nodes.values()
    return sum(len(lines) for node in nodes for lines in node.lines.values()) / len(nodes)


def talked(content: Content, covered: int) -> DialogueState:
    """Return a state that covers so many topics, spread over the tree: 1 to 4 sentences said.

    Columns are written whole: topic by topic 30,000 of them would take minutes.
    """
    chance = Random(2)
    numbers = chance.sample(sorted(content.tree.nodes), covered)
    size = max(numbers, default=0) + 1
    levels, used = bytearray(size), [bytearray(size) for _ in range((MAX_SLOT + 1) // 8)]
    for number in numbers:
        levels[number] = chance.choices(_LEVELS, _WEIGHTS)[0]
        slots = [line.slot for lines in content.tree.nodes[number].lines.values() for line in lines]
        for slot in chance.sample(slots, min(len(slots), chance.randint(1, 4))):
            used[slot // 8][number] |= 1 << slot % 8
    columns = [bytes(column).rstrip(b"\0") for column in used]
    while columns and not columns[-1]:
        columns.pop()
    state = DialogueState("en", "EN", seed=1, turn=4 * covered)
    state = replace(state, topics=tuple(numbers[-TOPIC_RING:]), used=tuple(columns))
    return replace(state, levels=bytes(levels).rstrip(b"\0"), topic=numbers[-1] if numbers else 0)
