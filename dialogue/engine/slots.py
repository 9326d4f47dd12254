"""Give each frame a slot: its bit in the state, unique among all that one topic can say."""

from collections.abc import Mapping

from dialogue.engine.concepts import Knowledge, Topic
from dialogue.engine.state import MAX_SLOT


def missing_slots(knowledge: Knowledge) -> dict[int, int]:
    """Return a slot for each frame (by number) that has none yet.

    From the root down, so that what all topics share gets the low slots. A slot already taken by
    a topic above or below is avoided; where more than 128 frames meet, slots are shared, which
    only makes the agent believe that it has said a sentence already.
    """
    return _Slots(knowledge).missing()


class _Slots:
    def __init__(self, knowledge: Knowledge) -> None:
        self.topics: Mapping[str, Topic] = {topic.key: topic for topic in knowledge.topics}
        self.above = {key: self._sources(topic) for key, topic in self.topics.items()}
        self.below: dict[str, set[str]] = {key: {key} for key in self.topics}
        for key, sources in self.above.items():
            for source in sources:
                self.below[source].add(key)
        self.taken: dict[str, set[int]] = {
            key: {frame.slot for frame in topic.frames if frame.slot >= 0}
            for key, topic in self.topics.items()
        }

    def _sources(self, topic: Topic) -> frozenset[str]:
        """Return every topic this one takes sentences from."""
        above: set[str] = set()
        key = topic.is_a
        while key in self.topics and key not in above:
            above.add(key)
            key = self.topics[key].is_a
        return frozenset(above.union(key for key in topic.also if key in self.topics))

    def missing(self) -> dict[int, int]:
        given: dict[int, int] = {}
        for key in sorted(self.topics, key=lambda key: len(self.above[key])):
            frames = [frame for frame in self.topics[key].frames if frame.slot < 0]
            if not frames:
                continue
            taken = self._taken_around(key)
            for frame in frames:
                slot = _free(taken)
                taken.add(slot)
                self.taken[key].add(slot)
                given[frame.number] = slot
        return given

    def _taken_around(self, key: str) -> set[int]:
        """Return the slots of all frames that meet this topic's frames somewhere below."""
        meeting = set(self.above[key])
        for below in self.below[key]:
            meeting |= {below, *self.above[below]}
        return {slot for other in meeting for slot in self.taken[other]}


def _free(taken: set[int]) -> int:
    for slot in range(MAX_SLOT + 1):
        if slot not in taken:
            return slot
    return min(taken, default=0)
