"""Our published content, padded with invented topics to the size of the paper's tree."""

from dataclasses import dataclass
from pathlib import Path

from msgspec.structs import replace

from benchmarks.tree import World
from dialogue.engine.concepts import Frame, Knowledge, Topic
from dialogue.snapshot import Snapshot
from ontology_io.files.folder import read_folder

TOPICS = 2_780
ROOT = Path(__file__).resolve().parent.parent.parent
_SCAFFOLD = 16 + 16 * 3 + 16 * 6  # branches, groups and classes of the invented tree


@dataclass(frozen=True, slots=True)
class _Shift:
    """Moves invented topics and sentences to numbers that nobody has."""

    topics: int
    frames: int

    def topic(self, topic: Topic, kept: frozenset[str]) -> Topic:
        frames = tuple(self.frame(one) for one in topic.frames)
        see = tuple(key for key in topic.see if key in kept)
        return replace(topic, number=topic.number + self.topics, frames=frames, see=see)

    def frame(self, frame: Frame) -> Frame:
        return replace(frame, number=frame.number + self.frames)


def padded(folder: Path = ROOT / "content", topics: int = TOPICS) -> Snapshot:
    """Return the content of a folder with so many topics at least: its own, then invented ones."""
    base = read_folder(folder).base
    missing = max(0, topics - len(base.knowledge.topics))
    knowledge = _with(base.knowledge, missing) if missing else base.knowledge
    return Snapshot(knowledge=knowledge, library=base.library)


def _with(knowledge: Knowledge, missing: int) -> Knowledge:
    leaves = 96 * (1 + max(0, missing - _SCAFFOLD) // 96)
    invented = World(leaves, 0).knowledge().topics[:missing]
    kept = frozenset(topic.key for topic in invented)
    shift = _Shift(max(topic.number for topic in knowledge.topics), _last_frame(knowledge))
    return replace(
        knowledge, topics=(*knowledge.topics, *(shift.topic(one, kept) for one in invented))
    )


def _last_frame(knowledge: Knowledge) -> int:
    piles = [topic.frames for topic in knowledge.topics] + list(knowledge.pools.values())
    return max(frame.number for pile in piles for frame in pile)
