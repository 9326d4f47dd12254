"""What changes between two knowledge bases, in names and counts."""

from collections.abc import Mapping
from dataclasses import dataclass, field

import msgspec

from dialogue.engine.concepts import Frame, Topic
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
    return Differences(
        {
            "cultures": _compare(_cultures(old), _cultures(new)),
            "topics": _compare(_topics(old), _topics(new)),
            "sentences": _compare(_frames(old), _frames(new)),
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


def _topics(base: KnowledgeBase) -> dict[str, object]:
    places: dict[str, int] = {}
    topics: dict[str, object] = {}
    for topic in base.knowledge.topics:
        place = places[topic.is_a] = places.get(topic.is_a, 0) + 1
        order = tuple(frame.key for frame in topic.frames)
        topics[topic.key] = (place, order, msgspec.structs.replace(topic, number=0, frames=()))
    return topics


def _frames(base: KnowledgeBase) -> dict[str, object]:
    knowledge = base.knowledge
    frames: list[Frame] = [frame for topic in knowledge.topics for frame in topic.frames]
    for pool in knowledge.pools.values():
        frames += pool
    return {frame.key: msgspec.structs.replace(frame, number=0, slot=-1) for frame in frames}


def _intents(base: KnowledgeBase) -> dict[str, object]:
    return {
        intent.key: (place, msgspec.structs.replace(intent, number=0))
        for place, intent in enumerate(base.library.intents)
    }


def _vocabulary(base: KnowledgeBase) -> dict[str, object]:
    library = base.library
    return {f"<{phrase.key}>": phrase for phrase in library.phrases} | {
        value_list.key: value_list for value_list in library.values
    }


def changed_topics(old: KnowledgeBase, new: KnowledgeBase) -> tuple[Topic, ...]:
    """Return the topics of the new one whose rows (with their sentences) must be written."""
    before = {topic.key: topic for topic in old.knowledge.topics}
    places_old, places_new = _places(old), _places(new)
    return tuple(
        topic
        for topic in new.knowledge.topics
        if before.get(topic.key) != topic or places_old[topic.key] != places_new[topic.key]
    )


def _places(base: KnowledgeBase) -> dict[str, int]:
    return {topic.key: place for place, topic in enumerate(base.knowledge.topics)}
