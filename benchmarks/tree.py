"""A synthetic tree of the full size: time to build, memory, and what a turn costs.

python benchmarks/tree.py [--topics 3000] [--frames-per-class 8]
"""

import argparse
import time
import tracemalloc
from collections.abc import Callable
from random import Random
from typing import TypeVar

import msgspec

from dialogue.engine.codec import decode, encode
from dialogue.engine.concepts import Culture, Frame, Knowledge, Topic
from dialogue.engine.content import Content, build_content
from dialogue.engine.manager import reply, start
from dialogue.engine.pools import POOLS
from dialogue.engine.slots import missing_slots
from dialogue.engine.state import DialogueState
from dialogue.engine.turn import Heard
from dialogue.snapshot import Snapshot, checksum, pack, unpack
from plans.engine.intents import Library

SYLLABLES = [consonant + vowel for consonant in "bcdflmnprst" for vowel in "aeiou"]
KANA = "アイウエオカキクケコサシスセソタチツテトナニヌネノマミムメモ"
Result = TypeVar("Result")
KEYS = (b"a key of a benchmark, thirty-two b",)
CULTURES = ("EN", "IT", "JP", "IN")
TYPES = "qqppnnwwcc"


class World:
    """Makes a knowledge base of branches, groups, classes and leaves with invented names."""

    def __init__(self, leaves: int, frames_per_class: int, seed: int = 1) -> None:
        self.chance = Random(seed)
        self.frames_per_class = frames_per_class
        self.topics: list[Topic] = []
        self.frame_number = 0
        self.words: set[str] = set()
        for branch in range(16):
            key = self._topic("", f"Branch{branch}", TYPES)
            for group in range(3):
                above = self._topic(key, f"Group{branch}x{group}", "")
                for class_ in range(2):
                    here = self._topic(above, f"Class{branch}x{group}x{class_}", "")
                    for _ in range(leaves // 96):
                        self._leaf(here)

    def _word(self) -> str:
        while True:
            word = "".join(self.chance.choices(SYLLABLES, k=4))
            if word not in self.words:
                self.words.add(word)
                return word

    def _frames(self, key: str, types: str) -> tuple[Frame, ...]:
        frames = []
        for place, type_ in enumerate(types):
            self.frame_number += 1
            frames.append(
                Frame(
                    key=f"{key}.{type_}{place}",
                    type=type_,
                    number=self.frame_number,
                    texts={
                        "en": f"Sentence {self.frame_number} about $hasName {{is|are}} here.",
                        "it": f"Frase {self.frame_number} che parla $hasName.di.",
                        "ja": f"$hasNameについての文{self.frame_number}です。",
                    },
                )
            )
        return tuple(frames)

    def _topic(self, parent: str, key: str, types: str) -> str:
        word = self._word()
        frames = self._frames(key, types or "qpnwcqpn"[: self.frames_per_class])
        kana = "".join(self.chance.choices(KANA, k=5))
        self.topics.append(
            Topic(
                key=key,
                is_a=parent or "Topic",
                number=len(self.topics) + 1,
                names={"en": {"name": word}, "it": {"name": word, "g": "m"}, "ja": {"name": kana}},
                keywords={
                    "en": ((word,), ("*",)),
                    "it": ((word,), ("*",)),
                    "ja": ((kana,), ("*",)),
                },
                likeliness=dict.fromkeys(CULTURES, 0.5),
                frames=frames,
            )
        )
        return key

    def _leaf(self, parent: str) -> None:
        self._topic(parent, f"Leaf{len(self.topics)}", "cw")

    def knowledge(self) -> Knowledge:
        """Return the knowledge base, with links, pools and slots."""
        keys = [topic.key for topic in self.topics]
        replace = msgspec.structs.replace
        topics = [replace(one, see=tuple(self.chance.sample(keys, 2))) for one in self.topics]
        topics = [
            replace(one, see=tuple(key for key in one.see if key != one.key)) for one in topics
        ]
        pools = {name: self._frames(name, "x" * 12) for name in POOLS}
        base = Knowledge(
            cultures=tuple(Culture(code=code, names={}, language="en") for code in CULTURES),
            topics=tuple(topics),
            pools={name: _plain(frames) for name, frames in pools.items()},
        )
        slots = missing_slots(base)
        return replace(
            base,
            topics=tuple(
                replace(one, frames=tuple(replace(f, slot=slots[f.number]) for f in one.frames))
                for one in base.topics
            ),
        )


def _plain(frames: tuple[Frame, ...]) -> tuple[Frame, ...]:
    texts = {"en": "Well, I see.", "it": "Capisco.", "ja": "そうですか。"}
    return tuple(msgspec.structs.replace(frame, texts=texts) for frame in frames)


def cover(content: Content, topics: int) -> DialogueState:
    """Return a state in which so many topics were talked about: 1 to 4 sentences, an opinion."""
    chance, tree = Random(2), content.tree
    state = DialogueState("en", "EN", seed=1)
    for number in chance.sample(sorted(tree.nodes), topics):
        node = tree.nodes[number]
        state = state.with_topic_started(number)
        if chance.random() < 0.8:
            state = state.with_likeliness(number, chance.sample((0.0, 0.1, 0.6, 0.9, 1.0), 1)[0])
        types = [type_ for type_ in ("q", "p", "w", "c") if type_ in node.lines]
        for type_ in types[: chance.randint(1, 4)]:
            line = node.lines[type_][chance.randrange(len(node.lines[type_]))]
            state = state.with_used(number, line.slot).with_frame(line.number)
    return state


def best(work: Callable[[], object], rounds: int = 60) -> float:
    """Return the least CPU microseconds of so many rounds."""
    times = []
    for _ in range(rounds):
        before = time.process_time_ns()
        work()
        times.append((time.process_time_ns() - before) / 1000)
    return min(times)


def state_row(state: DialogueState, covered: int, target: str) -> None:
    """Print the size of a state and what it costs to read and to write."""
    text = encode(state, KEYS)
    cost = best(lambda: encode(state, KEYS)) + best(lambda: decode(text, KEYS))
    row(f"state, {covered} topics covered", f"{len(text)} characters, {cost:.0f} µs", target)


def turn_cost(content: Content, state: DialogueState, turns: int = 300) -> float:
    """Return the CPU microseconds of one turn of the Dialogue Manager (best of five rounds)."""
    least = float("inf")
    for _ in range(5):
        now = state
        before = time.process_time_ns()
        for turn in range(turns):
            now = reply(content, now, Heard(("yes", "no", "I do not know")[turn % 3])).state
        least = min(least, (time.process_time_ns() - before) / 1000 / turns)
    return least


def row(what: str, figure: str, target: str = "") -> None:
    """Print a row of the table."""
    print(f"| {what} | {figure} | {target} |")


def timed(what: str, target: str, work: Callable[[], Result]) -> Result:
    """Print how long a step took, and return what it gave."""
    before = time.process_time()
    result = work()
    row(what, f"{time.process_time() - before:.2f} s", target)
    return result


def publish(knowledge: Knowledge) -> bytes:
    """Return the snapshot of a knowledge base, and print what it costs to read and build it."""
    data = timed(
        "pack a snapshot", "", lambda: pack(Snapshot(knowledge=knowledge, library=Library()))
    )
    row("snapshot on disk", f"{len(data) / 1e6:.2f} MB")
    snapshot = timed("read the snapshot", "", lambda: unpack(data, checksum(data)))
    timed(
        "build tree, names, keywords", "< 5 s", lambda: build_content(snapshot.knowledge, Library())
    )
    return data


def held(data: bytes) -> Content:
    """Return the content, and print the memory it holds for all cultures and languages."""
    tracemalloc.start()
    content = build_content(unpack(data, checksum(data)).knowledge, Library())
    megabytes = tracemalloc.get_traced_memory()[0] / 1e6
    tracemalloc.stop()
    sentences = sum(len(x) for node in content.tree.nodes.values() for x in node.lines.values())
    row("topics, sentences a language", f"{len(content.tree.nodes)}, {sentences}", "3,000, 25,000")
    row("memory held, all cultures and languages", f"{megabytes:.0f} MB", "< 150 MB")
    return content


def main() -> None:
    """Print the table of docs/figures.md."""
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--topics", type=int, default=3000)
    arguments.add_argument("--frames-per-class", type=int, default=8)
    chosen = arguments.parse_args()
    print("| what | figure (CPU) | target |\n| --- | --- | --- |")
    content = held(publish(World(chosen.topics, chosen.frames_per_class).knowledge()))
    fresh = turn_cost(content, start(content, "en", "EN", 1).state)
    for covered, target in (
        (0, "120"),
        (50, "320"),
        (926, "3,600"),
        (1853, "5,800"),
        (2780, "7,400"),
    ):
        state = cover(content, covered)
        state_row(state, covered, f"<= {target} characters, 400 µs")
        cost = turn_cost(content, state)
        row(f"a turn, {covered} topics covered", f"{cost:.0f} µs, {cost / fresh:.2f} ×")


if __name__ == "__main__":
    main()
