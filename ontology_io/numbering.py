"""Give stable numbers to what has none: keys keep theirs, new ones get numbers never used."""

from collections.abc import Iterable, Mapping
from typing import Protocol, TypeVar

import msgspec
from django.db import connection, models

from dialogue import models as dialogue_models
from dialogue.engine.concepts import Frame
from ontology_io.records import KnowledgeBase
from plans.models import Intent


class _Keyed(Protocol):
    @property
    def key(self) -> str: ...
    @property
    def number(self) -> int: ...


Keyed = TypeVar("Keyed", bound=_Keyed)
MODELS: Mapping[str, type[models.Model]] = {
    "topic": dialogue_models.Topic,
    "frame": dialogue_models.Frame,
    "intent": Intent,
}


def last_numbers() -> dict[str, int]:
    """Return the highest number ever given, by kind."""
    return {kind: last_number(model) for kind, model in MODELS.items()}


def raise_last_numbers(last: Mapping[str, int]) -> None:
    """Make sure that numbers up to these are never given to anything new."""
    for kind, model in MODELS.items():
        if last.get(kind, 0) > last_number(model):
            set_last_number(model, last[kind])


def numbered(base: KnowledgeBase, old: KnowledgeBase) -> KnowledgeBase:
    """Return the knowledge base with a number for every topic, frame and intent.

    A key that the old one knows keeps its number there (a frame its slot too); else the number it
    brings is kept where nothing else here has it (so a new name in numbers.tsv is a renaming);
    else it gets the next one.
    """
    last = last_numbers()
    topic_numbers = _numbers(base.knowledge.topics, old.knowledge.topics, last["topic"])
    frame_numbers = _numbers(_frames(base), _frames(old), last["frame"])
    intent_numbers = _numbers(base.library.intents, old.library.intents, last["intent"])
    replace = msgspec.structs.replace
    slots = {frame.number: frame.slot for frame in _frames(old) if frame.slot >= 0}
    topics = tuple(
        replace(
            topic,
            number=topic_numbers[topic.key],
            frames=_numbered_frames(topic.frames, frame_numbers, slots),
        )
        for topic in base.knowledge.topics
    )
    pools = {
        name: _numbered_frames(frames, frame_numbers, slots)
        for name, frames in base.knowledge.pools.items()
    }
    intents = tuple(replace(one, number=intent_numbers[one.key]) for one in base.library.intents)
    return KnowledgeBase(
        knowledge=replace(base.knowledge, topics=topics, pools=pools),
        library=replace(base.library, intents=intents),
    )


def highest_numbers(base: KnowledgeBase) -> dict[str, int]:
    """Return the highest number of each kind."""
    kinds: Mapping[str, Iterable[_Keyed]] = {
        "topic": base.knowledge.topics,
        "frame": _frames(base),
        "intent": base.library.intents,
    }
    return {kind: max([row.number for row in rows], default=0) for kind, rows in kinds.items()}


def _numbered_frames(
    frames: tuple[Frame, ...], numbers: Mapping[str, int], slots: Mapping[int, int]
) -> tuple[Frame, ...]:
    return tuple(
        msgspec.structs.replace(
            frame, number=numbers[frame.key], slot=slots.get(numbers[frame.key], frame.slot)
        )
        for frame in frames
    )


def _frames(base: KnowledgeBase) -> list[Frame]:
    frames = [frame for topic in base.knowledge.topics for frame in topic.frames]
    for pool in base.knowledge.pools.values():
        frames += pool
    return frames


def _numbers(new: Iterable[Keyed], old: Iterable[Keyed], last: int) -> dict[str, int]:
    known = {row.key: row.number for row in old}
    rows = list(new)
    numbers = {row.key: known[row.key] for row in rows if row.key in known}
    taken = set(numbers.values())
    for row in rows:
        if row.key not in numbers and row.number and row.number not in taken:
            numbers[row.key] = row.number
            taken.add(row.number)
    following = max([last, *taken, *known.values()])
    for row in rows:
        if row.key not in numbers:
            following += 1
            numbers[row.key] = following
    return numbers


def last_number(model: type[models.Model]) -> int:
    """Return the highest number a table ever gave to a row, 0 where it gave none."""
    table, quote = model._meta.db_table, connection.ops.quote_name
    with connection.cursor() as cursor:
        if connection.vendor == "sqlite":
            cursor.execute("SELECT seq FROM sqlite_sequence WHERE name = %s", [table])
        else:
            cursor.execute(
                "SELECT last_value FROM pg_sequences WHERE pg_get_serial_sequence(%s, %s)"
                " = quote_ident(schemaname) || '.' || quote_ident(sequencename)",
                [quote(table), _column(model)],
            )
        row = cursor.fetchone()
    return int(row[0] or 0) if row else 0


def set_last_number(model: type[models.Model], last: int) -> None:
    """Have the next row get the number after `last`, from 1."""
    table, quote = model._meta.db_table, connection.ops.quote_name
    with connection.cursor() as cursor:
        if connection.vendor == "sqlite":
            cursor.execute("UPDATE sqlite_sequence SET seq = %s WHERE name = %s", [last, table])
            if not cursor.rowcount:
                cursor.execute(
                    "INSERT INTO sqlite_sequence (name, seq) VALUES (%s, %s)", [table, last]
                )
        else:
            cursor.execute(
                "SELECT setval(pg_get_serial_sequence(%s, %s), %s)",
                [quote(table), _column(model), last],
            )


def _column(model: type[models.Model]) -> str:
    return str(model._meta.pk.column)
