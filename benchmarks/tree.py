"""A synthetic tree of the full size: time to build, memory, and what a turn costs.

python benchmarks/tree.py [--topics 3000] [--frames-per-class 8]
"""

import argparse
import resource
import time
import tracemalloc
from random import Random

import msgspec

from dialogue.engine.concepts import Culture, Frame, Knowledge, Topic
from dialogue.engine.content import Content, build_content
from dialogue.engine.manager import reply, start
from dialogue.engine.pools import POOLS
from dialogue.engine.slots import missing_slots
from dialogue.engine.state import DialogueState
from dialogue.engine.turn import Heard
from dialogue.snapshot import Snapshot, checksum, pack, unpack
from languages.known import LANGUAGES
from plans.engine.intents import Library

SYLLABLES = (
    "ba be bi bo bu ca co cu da de di do du fa fe fi fo la le li lo lu ma me mi mo mu".split()
)
KANA = "アイウエオカキクケコサシスセソタチツテトナニヌネノマミムメモ"
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
            word = "".join(self.chance.choices(SYLLABLES, k=4))  # noqa: TID251
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
        kana = "".join(self.chance.choices(KANA, k=5))  # noqa: TID251
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
    """Return a state in which so many topics were talked about."""
    state = DialogueState("en", "EN", seed=1)
    for number in list(content.tree.nodes)[:topics]:
        state = state.with_likeliness(number, 0.7).with_topic_started(number)
        for line in [lines[0] for lines in content.tree.nodes[number].lines.values()][:4]:
            state = state.with_used(number, line.slot).with_frame(line.number)
    return state


def turn_cost(content: Content, state: DialogueState, turns: int = 300) -> float:
    """Return the CPU microseconds of one turn of the Dialogue Manager (best of five rounds)."""
    best = float("inf")
    for _ in range(5):
        now = state
        before = time.process_time_ns()
        for turn in range(turns):
            now = reply(content, now, Heard(("yes", "no", "I do not know")[turn % 3])).state
        best = min(best, (time.process_time_ns() - before) / 1000 / turns)
    return best


def timed(what: str, limit: str, work: object) -> object:
    """Print how long a step took."""
    before = time.process_time()
    result = work()  # type: ignore[operator]
    print(f"| {what} | {time.process_time() - before:.2f} s | {limit} |")
    return result


def main() -> None:
    """Print the table of docs/figures.md."""
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--topics", type=int, default=3000)
    arguments.add_argument("--frames-per-class", type=int, default=8)
    chosen = arguments.parse_args()
    knowledge = World(chosen.topics, chosen.frames_per_class).knowledge()
    print("| what | figure (CPU) | target |\n| --- | --- | --- |")
    data = timed(
        "pack a snapshot", "", lambda: pack(Snapshot(knowledge=knowledge, library=Library()))
    )
    assert isinstance(data, bytes)
    start_memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    snapshot = timed("read the snapshot", "", lambda: unpack(data, checksum(data)))
    assert isinstance(snapshot, Snapshot)
    content = timed(
        "build tree and keyword indexes",
        "< 5 s",
        lambda: build_content(snapshot.knowledge, Library()),
    )
    assert isinstance(content, Content)
    sentences = sum(len(x) for node in content.tree.nodes.values() for x in node.lines.values())
    grown = (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - start_memory) / 1024
    print(
        f"| topics / sentences a language | {len(content.tree.nodes)} / {sentences} | 3,000 / 25,000 |"
    )
    print(f"| snapshot on disk | {len(data) / 1e6:.2f} MB | |")
    print(f"| peak memory of reading and building | {grown:.0f} MB | |")
    tracemalloc.start()
    again = build_content(unpack(data, checksum(data)).knowledge, Library())
    held = tracemalloc.get_traced_memory()[0] / 1e6
    tracemalloc.stop()
    assert again.tree.nodes
    print(f"| content held, all cultures and languages | {held:.0f} MB | < 150 MB |")
    fresh = turn_cost(content, start(content, "en", "EN", 1).state)
    for covered in (0, 926, 1853, 2780):
        cost = turn_cost(content, cover(content, covered))
        print(f"| a turn, {covered} topics covered | {cost:.0f} µs, {cost / fresh:.2f} × | |")
    print(f"| languages | {', '.join(LANGUAGES)} | |")


if __name__ == "__main__":
    main()
