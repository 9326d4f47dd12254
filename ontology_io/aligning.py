"""Two knowledge bases side by side: rows are the same where their numbers are."""

from collections.abc import Iterable, Mapping
from typing import Protocol

import msgspec

from dialogue.engine.concepts import Frame, Topic
from ontology_io.records import KnowledgeBase

replace = msgspec.structs.replace


class _Row(Protocol):
    @property
    def key(self) -> str: ...
    @property
    def number(self) -> int: ...


def aligned(old: KnowledgeBase, new: KnowledgeBase) -> KnowledgeBase:
    """Return the old one with each row named as the new one names it, if it has it still.

    Frames keep the topic they belong to; only their keys follow.
    """
    topics = _names(old.knowledge.topics, new.knowledge.topics)
    frames = _names(_frames(old), _frames(new))
    intents = _names(old.library.intents, new.library.intents)
    knowledge, library = old.knowledge, old.library
    if topics or frames:
        knowledge = replace(
            knowledge,
            topics=tuple(_topic(topic, topics, frames) for topic in knowledge.topics),
            pools={
                name: tuple(_frame(frame, frames) for frame in rows)
                for name, rows in knowledge.pools.items()
            },
        )
    if intents:
        library = replace(
            library,
            intents=tuple(
                replace(one, key=intents.get(one.key, one.key)) for one in library.intents
            ),
        )
    return KnowledgeBase(knowledge=knowledge, library=library)


def _frames(base: KnowledgeBase) -> list[Frame]:
    frames = [frame for topic in base.knowledge.topics for frame in topic.frames]
    for rows in base.knowledge.pools.values():
        frames += rows
    return frames


def _names(old: Iterable[_Row], new: Iterable[_Row]) -> dict[str, str]:
    """Return the new key of each old one that has another one now."""
    now = {row.number: row.key for row in new}
    return {row.key: now[row.number] for row in old if now.get(row.number, row.key) != row.key}


def _topic(topic: Topic, topics: Mapping[str, str], frames: Mapping[str, str]) -> Topic:
    def called(key: str) -> str:
        return topics.get(key, key)

    return replace(
        topic,
        key=called(topic.key),
        is_a=called(topic.is_a),
        also=tuple(map(called, topic.also)),
        see=tuple(map(called, topic.see)),
        frames=tuple(_frame(frame, frames) for frame in topic.frames),
    )


def _frame(frame: Frame, frames: Mapping[str, str]) -> Frame:
    return replace(frame, key=frames[frame.key]) if frame.key in frames else frame
