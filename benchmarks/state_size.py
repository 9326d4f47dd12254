"""The size of a state and the time to write and read it, against the number of topics covered."""

import argparse
import time
from collections.abc import Callable
from functools import partial
from random import Random

from dialogue.engine.codec import decode, encode
from dialogue.engine.state import DialogueState

TOPICS = 2_780
COVERED = (0, 50, 926, 1_853, 2_780)
TARGETS = (120, 320, 3_600, 5_800, 7_400)
KEY = b"a key for benchmarks, 32 bytes.."
LEVELS = tuple(tenth / 10 for tenth in range(11))
# People are asked about what their culture likes, so more of them say yes than no.
LEVEL_WEIGHTS = (2, 1, 2, 2, 3, 4, 4, 5, 6, 5, 4)
TYPES = "qpnrwcgte"


class Tree:
    """A synthetic Dialogue Tree: topics numbered branch by branch, about 8 sentences each.

    Sentences have the lowest frame slots, or any of `spread` ones (sentences of ancestors
    and descendants have different slots, so a topic with many ancestors has few low ones).
    """

    def __init__(self, size: int, spread: int, chance: Random) -> None:
        self.size = size
        counts = [min(max(round(chance.gauss(7.2, 2)), 2), 16) for _ in range(size)]
        self.slots = [
            (),
            *(tuple(chance.sample(range(spread or n), min(n, spread or n))) for n in counts),
        ]
        self.children: list[list[int]] = [[] for _ in range(size + 1)]
        path = [1]
        for topic in range(2, size + 1):
            del path[chance.randint(1, 6) :]
            self.children[path[-1]].append(topic)
            path.append(topic)

    def frame(self, topic: int, slot: int) -> int:
        """Return a frame number; ten of a hundred topics got theirs later, out of order."""
        return (topic * 7 + slot) if topic % 10 else 20_000 + topic % 97 * 11 + slot


def walk(tree: Tree, chance: Random) -> list[int]:
    """Return all topics in the order of a talk: down to a child, else a jump to an open one."""
    fresh, order, topic = set(range(1, tree.size + 1)), [], 1
    while fresh:
        fresh.discard(topic)
        order.append(topic)
        below = [child for child in tree.children[topic] if child in fresh]
        if below and chance.random() < 0.8:
            topic = below[int(chance.random() * len(below))]
        elif fresh:
            topic = sorted(fresh)[int(chance.random() * len(fresh))]
    return order


def talk(tree: Tree, order: list[int], covered: int, chance: Random) -> DialogueState:
    """Return the state of a person who talked about this many topics."""
    state = DialogueState("en", "EN")
    for topic in order[:covered]:
        state = state.with_topic_started(topic)
        slots = tree.slots[topic]
        said = min(len(slots), 1 + int(chance.random() * 4))
        for slot in chance.sample(slots, said):
            state = state.with_used(topic, slot).with_frame(tree.frame(topic, slot))
        if chance.random() < 0.85:
            state = state.with_likeliness(topic, chance.choices(LEVELS, LEVEL_WEIGHTS)[0])
    return state if not covered else _in_the_middle(state, covered)


def _in_the_middle(state: DialogueState, covered: int) -> DialogueState:
    fields = {name: getattr(state, name) for name in state.__slots__}
    fields |= {"turn": covered * 3, "last_type": "p", "ordering": "wc", "questions": 1}
    fields |= {"avoided": ((17, covered * 3 + 20),), "siblings": 1, "offer": 1_234}
    return DialogueState(**fields)


def best(work: Callable[[], object], rounds: int) -> float:
    """Return the CPU microseconds of the quickest of many rounds."""
    quickest = 10**12
    for _ in range(rounds):
        begin = time.process_time_ns()
        work()
        quickest = min(quickest, time.process_time_ns() - begin)
    return quickest / 1_000


def report(seed: int, spread: int, rounds: int) -> None:
    """Print one row per number of covered topics."""
    tree = Tree(TOPICS, spread, Random(seed))
    order = walk(tree, Random(seed))
    print("| topics covered | characters | target | bytes | encode µs | decode µs | together |")
    print("| ---: | ---: | ---: | ---: | ---: | ---: | ---: |")
    for covered, target in zip(COVERED, TARGETS, strict=True):
        state = talk(tree, order, covered, Random(seed))
        text = encode(state, [KEY])
        assert decode(text, [KEY]) == state
        write = best(partial(encode, state, [KEY]), rounds)
        read = best(partial(decode, text, [KEY]), rounds)
        print(
            f"| {covered:,} | {len(text):,} | {target:,} | {len(text) * 3 // 4:,} "
            f"| {write:.0f} | {read:.0f} | {write + read:.0f} |"
        )


if __name__ == "__main__":
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--seed", type=int, default=1)
    arguments.add_argument("--spread", type=int, default=0, help="slots to spread over, up to 128")
    arguments.add_argument("--rounds", type=int, default=400)
    chosen = arguments.parse_args()
    report(chosen.seed, chosen.spread, chosen.rounds)
