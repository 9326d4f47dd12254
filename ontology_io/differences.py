"""What changes between two knowledge bases, in names and counts."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field

import msgspec

from dialogue.engine.concepts import Frame, Knowledge, Topic
from ontology_io.records import KnowledgeBase


@dataclass(frozen=True, slots=True)
class Kind:
    """What is added, changed and removed of one kind of row, by key."""

    added: tuple[str, ...] = ()
    changed: tuple[str, ...] = ()
    removed: tuple[str, ...] = ()

    @property
    def total(self) -> int:
        """Return how many rows differ."""
        return len(self.added) + len(self.changed) + len(self.removed)


@dataclass(frozen=True, slots=True)
class Differences:
    """The differences of each kind; falsy where there are none."""

    kinds: Mapping[str, Kind] = field(default_factory=dict)

    def __bool__(self) -> bool:
        return any(kind.total for kind in self.kinds.values())

    def lines(self, longest: int = 8) -> list[str]:
        """Return one line a kind and a change, with the first names."""
        return [
            f"{len(keys):6} {name} {word}: {_some(keys, longest)}"
            for name, kind in self.kinds.items()
            for word, keys in (
                ("added", kind.added),
                ("changed", kind.changed),
                ("removed", kind.removed),
            )
            if keys
        ]


def _some(keys: tuple[str, ...], longest: int) -> str:
    more = f" and {len(keys) - longest} more" if len(keys) > longest else ""
    return ", ".join(keys[:longest]) + more


def differences(old: KnowledgeBase, new: KnowledgeBase) -> Differences:
    """Return what must change for the old one to become the new one; numbers do not count."""
    both = {topic.key for topic in old.knowledge.topics} & {
        topic.key for topic in new.knowledge.topics
    }
    return Differences(
        {
            "cultures": _compare(_cultures(old), _cultures(new)),
            "topics": _compare(_topics(old, both), _topics(new, both)),
            "sentences": _compare(_frames(old), _frames(new)),
            "orders of pools": _compare(_pools(old), _pools(new)),
            "intents": _compare(_intents(old), _intents(new)),
            "phrases and values": _compare(_vocabulary(old), _vocabulary(new)),
        }
    )


def _compare(old: Mapping[str, object], new: Mapping[str, object]) -> Kind:
    return Kind(
        added=tuple(key for key in new if key not in old),
        changed=tuple(key for key, value in new.items() if key in old and old[key] != value),
        removed=tuple(key for key in old if key not in new),
    )


def _cultures(base: KnowledgeBase) -> dict[str, object]:
    return {culture.code: (place, culture) for place, culture in enumerate(base.knowledge.cultures)}


def _topics(base: KnowledgeBase, both: Collection[str]) -> dict[str, object]:
    """Return the topics with their places among those that are in both knowledge bases."""
    places: dict[str, int] = {}
    topics: dict[str, object] = {}
    for topic in base.knowledge.topics:
        place = places[topic.is_a] = places.get(topic.is_a, 0) + (topic.key in both)
        order = tuple(frame.key for frame in topic.frames)
        topics[topic.key] = (place, order, msgspec.structs.replace(topic, number=0, frames=()))
    return topics


def _frames(base: KnowledgeBase) -> dict[str, object]:
    knowledge = base.knowledge
    frames: list[Frame] = [frame for topic in knowledge.topics for frame in topic.frames]
    for pool in knowledge.pools.values():
        frames += pool
    return {frame.key: msgspec.structs.replace(frame, number=0, slot=-1) for frame in frames}


def _pools(base: KnowledgeBase) -> dict[str, object]:
    pools = base.knowledge.pools
    return {name: tuple(frame.key for frame in frames) for name, frames in pools.items()}


def _intents(base: KnowledgeBase) -> dict[str, object]:
    return {
        intent.key: (place, msgspec.structs.replace(intent, number=0))
        for place, intent in enumerate(base.library.intents)
    }


def _vocabulary(base: KnowledgeBase) -> dict[str, object]:
    library = base.library
    return {f"<{one.key}>": (place, one) for place, one in enumerate(library.phrases)} | {
        one.key: (place, one) for place, one in enumerate(library.values)
    }


def changed_topics(old: Knowledge, new: Knowledge) -> tuple[Topic, ...]:
    """Return the topics of the new one whose rows (with their sentences) must be written."""
    before = {topic.key: topic for topic in old.topics}
    return tuple(topic for topic in new.topics if before.get(topic.key) != topic)
