"""Records ↔ database: read the draft, write a knowledge base in one transaction."""

from collections.abc import Iterable, Mapping
from typing import TypeVar

from django.db import models as db
from django.db import transaction

from dialogue import models
from dialogue.bulk import note_about_draft
from dialogue.content import read_knowledge
from dialogue.draft import touch_draft
from dialogue.engine.concepts import ROOT, Frame, Knowledge, Topic
from ontology_io.differences import Differences, changed_topics, differences
from ontology_io.library_store import write_library
from ontology_io.numbering import highest_numbers, numbered, raise_last_numbers
from ontology_io.records import KnowledgeBase
from plans.content import read_library
from plans.recording import in_bulk

Row = TypeVar("Row", bound=db.Model)
BATCH = 400


def read_base() -> KnowledgeBase:
    """Return the whole draft."""
    return KnowledgeBase(knowledge=read_knowledge(), library=read_library())


@transaction.atomic
def write_base(
    base: KnowledgeBase,
    last: Mapping[str, int] | None = None,
    *,
    told: str = "content loaded from files",
) -> Differences:
    """Make the draft say what the knowledge base says; return what that changed.

    Only rows of topics that differ are written; numbers once given are never given again.
    The history gets one line about it, `told`.
    """
    old = read_base()
    raise_last_numbers(last or {})
    new = numbered(base, old)
    with in_bulk():
        _write_cultures(old.knowledge, new.knowledge)
        _write_topics(old.knowledge, new.knowledge)
        _write_pools(old.knowledge, new.knowledge)
        _delete_cultures(new.knowledge)
        write_library(old.library, new.library)
    raise_last_numbers(highest_numbers(new))
    changed = differences(old, new)
    if changed:
        touch_draft()
        note_about_draft(told)
    return changed


def _create(model: type[Row], rows: Iterable[Row]) -> None:
    model._default_manager.bulk_create(rows, batch_size=BATCH)


def _upsert(model: type[Row], rows: list[Row], fields: list[str], key: str = "id") -> None:
    model._default_manager.bulk_create(
        rows, batch_size=BATCH, update_conflicts=True, unique_fields=[key], update_fields=fields
    )


def _write_cultures(old: Knowledge, new: Knowledge) -> None:
    if old.cultures == new.cultures:
        return
    rows = [
        models.Culture(
            code=culture.code, names=culture.names, language=culture.language, position=place
        )
        for place, culture in enumerate(new.cultures)
    ]
    _upsert(models.Culture, rows, ["names", "language", "position"], key="code")


def _delete_cultures(knowledge: Knowledge) -> None:
    """Delete the cultures that are gone, last: no topic is at home there any more."""
    kept = {culture.code for culture in knowledge.cultures}
    codes = set(models.Culture.objects.values_list("code", flat=True))
    if codes - kept:
        models.Culture.objects.filter(code__in=codes - kept).delete()


def _write_topics(old: Knowledge, new: Knowledge) -> None:
    topics = {topic.key: topic for topic in new.topics}
    changed = changed_topics(old, new)
    gone = {topic.number for topic in old.topics} - {topic.number for topic in new.topics}
    _delete_parts([*gone, *(topic.number for topic in changed)])
    cultures = dict(models.Culture.objects.values_list("code", "id"))
    _upsert(
        models.Topic,
        [_topic_row(topic, topics, cultures) for topic in changed],
        ["key", "parent", "home", "gentle", "stop", "pattern", "note"],
    )
    _write_places(new)
    # The frames of a renamed topic are renamed before a topic that is gone takes its own along.
    _write_parts(changed, topics, cultures)
    _write_frames(
        {frame.key: (topic, frame) for topic in changed for frame in topic.frames}, cultures
    )
    _delete_frames(_frame_numbers(old) - _frame_numbers(new))
    for batch in _batches(gone):
        models.Topic.objects.filter(pk__in=batch).update(parent=None)
    for batch in _batches(gone):
        models.Topic.objects.filter(pk__in=batch).delete()


def _topic_row(
    topic: Topic, by_key: Mapping[str, Topic], cultures: Mapping[str, int]
) -> models.Topic:
    return models.Topic(
        id=topic.number,
        key=topic.key,
        parent_id=by_key[topic.is_a].number if topic.is_a != ROOT else None,
        home_id=cultures[topic.of] if topic.of else None,
        gentle=topic.gentle,
        stop=topic.stop,
        pattern=" | ".join(topic.pattern),
        note=topic.note,
    )


def _write_places(knowledge: Knowledge) -> None:
    """Give each topic its place; a topic that only moved is not written otherwise."""
    before = dict(models.Topic.objects.values_list("pk", "position"))
    models.Topic.objects.bulk_update(
        [
            models.Topic(pk=topic.number, position=place)
            for place, topic in enumerate(knowledge.topics)
            if before[topic.number] != place
        ],
        ["position"],
        batch_size=BATCH,
    )


def _frame_numbers(knowledge: Knowledge) -> set[int]:
    return {frame.number for topic in knowledge.topics for frame in topic.frames}


def _batches(numbers: Iterable[int]) -> Iterable[list[int]]:
    ordered = sorted(numbers)
    for start in range(0, len(ordered), BATCH):
        yield ordered[start : start + BATCH]


def _delete_parts(numbers: Iterable[int]) -> None:
    for batch in _batches(numbers):
        for model in (models.TopicName, models.Variable, models.KeywordSet, models.TopicInstance):
            model._default_manager.filter(topic__in=batch).delete()
        models.TopicLink.objects.filter(topic__in=batch).delete()
        models.Topic.also.through.objects.filter(from_topic__in=batch).delete()


def _write_parts(
    topics: Iterable[Topic], by_key: Mapping[str, Topic], cultures: Mapping[str, int]
) -> None:
    topics = tuple(topics)
    _create(models.TopicName, (row for topic in topics for row in _names(topic)))
    _create(
        models.Variable,
        (
            models.Variable(topic_id=topic.number, language=code, name=name, text=text)
            for topic in topics
            for code, texts in topic.variables.items()
            for name, text in texts.items()
        ),
    )
    _create(
        models.KeywordSet,
        (
            models.KeywordSet(
                topic_id=topic.number, language=code, first="|".join(first), second="|".join(second)
            )
            for topic in topics
            for code, (first, second) in topic.keywords.items()
        ),
    )
    _create(
        models.TopicInstance,
        (
            models.TopicInstance(
                topic_id=topic.number,
                culture_id=cultures[code],
                likeliness=f"{value:.3f}",
                name=topic.individuals.get(code, ""),
            )
            for topic in topics
            for code, value in topic.likeliness.items()
        ),
    )
    _create(
        models.TopicLink,
        (
            models.TopicLink(topic_id=topic.number, target_id=by_key[key].number, position=place)
            for topic in topics
            for place, key in enumerate(topic.see)
        ),
    )
    lends = models.Topic.also.through
    _create(
        lends,
        (
            lends(from_topic_id=topic.number, to_topic_id=by_key[key].number)
            for topic in topics
            for key in topic.also
        ),
    )


def _names(topic: Topic) -> Iterable[models.TopicName]:
    for code, fields in topic.names.items():
        rest = {key: text for key, text in fields.items() if key != "name"}
        yield models.TopicName(
            topic_id=topic.number, language=code, name=fields.get("name", ""), fields=rest
        )


def _write_pools(old: Knowledge, new: Knowledge) -> None:
    before = {frame.number for frames in old.pools.values() for frame in frames}
    after = {frame.number for frames in new.pools.values() for frame in frames}
    _delete_frames(before - after)
    if old.pools != new.pools:
        cultures = dict(models.Culture.objects.values_list("code", "id"))
        frames = [frame for frames in new.pools.values() for frame in frames]
        _write_frames({frame.key: (None, frame) for frame in frames}, cultures)


def _delete_frames(numbers: Iterable[int]) -> None:
    for batch in _batches(numbers):
        models.Frame.objects.filter(pk__in=batch).delete()


def _write_frames(
    frames: Mapping[str, tuple[Topic | None, Frame]], cultures: Mapping[str, int]
) -> None:
    for batch in _batches(frame.number for _, frame in frames.values()):
        models.Sentence.objects.filter(frame__in=batch).delete()
        models.Frame.only.through.objects.filter(frame__in=batch).delete()
    _upsert(
        models.Frame,
        [
            models.Frame(
                id=frame.number,
                key=frame.key,
                topic_id=topic.number if topic else None,
                pool="" if topic else frame.type,
                type=frame.type if topic else "",
                scope=frame.scope,
                do=frame.do,
                slot=frame.slot,
                position=place,
            )
            for place, (topic, frame) in enumerate(frames.values())
        ],
        ["key", "topic", "pool", "type", "scope", "do", "slot", "position"],
    )
    _create(
        models.Sentence,
        (
            models.Sentence(frame_id=frame.number, language=code, text=text)
            for _, frame in frames.values()
            for code, text in frame.texts.items()
        ),
    )
    kept = models.Frame.only.through
    _create(
        kept,
        (
            kept(frame_id=frame.number, culture_id=cultures[code])
            for _, frame in frames.values()
            for code in frame.only
        ),
    )
