"""Try many changed sentences at once: what the page of a sentence refuses, a sheet refuses too."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import msgspec

from authoring.topic_page.shape import Shape, read_shape
from authoring.topic_page.small_knowledge import Small
from authoring.topic_page.sound import sound
from authoring.topic_page.trial import Problem, pool_misfits, pool_problems, unsayable
from dialogue.content import read_part
from dialogue.engine.build import build_tree
from dialogue.engine.concepts import Frame
from dialogue.models import Topic, TopicName

Names = dict[str, dict[str, dict[str, str]]]


@dataclass(frozen=True, slots=True)
class Trial:
    """A frame to be tried: of a topic (its number) or of a pool."""

    frame: Frame
    owner: int | None
    pool: str = ""


def tried_together(trials: Sequence[Trial]) -> dict[int, list[Problem]]:
    """Return what cannot be said, by the number of the frame; about ten queries in all."""
    found: dict[int, list[Problem]] = {}
    of_topics = [one for one in trials if one.owner is not None]
    if of_topics:
        found |= _of_topics(of_topics)
    names = _names([one.frame for one in trials if one.owner is None])
    for one in trials:
        if one.owner is None:
            texts = one.frame.texts
            found[one.frame.number] = pool_problems(one.pool, texts) or pool_misfits(texts, names)
    return found


def _of_topics(trials: Sequence[Trial]) -> dict[int, list[Problem]]:
    shape = read_shape()
    owners = {one.owner for one in trials if one.owner is not None}
    among = _who_says(shape, owners)
    small = _built(shape, {number for one in among.values() for number in one}, trials)
    return {
        one.frame.number: unsayable(small, one.frame.number, among[one.owner])
        for one in trials
        if one.owner is not None and one.frame.number in small.tree.lines
    }


def _who_says(shape: Shape, owners: Iterable[int]) -> dict[int, tuple[int, ...]]:
    """Return for each topic all that may say its sentences: it, those below, its borrowers."""
    borrowers: dict[int, list[int]] = {}
    for borrower, lender in Topic.also.through.objects.values_list("from_topic_id", "to_topic_id"):
        borrowers.setdefault(lender, []).append(borrower)
    return {
        owner: tuple(dict.fromkeys((owner, *shape.below(owner), *borrowers.get(owner, ()))))
        for owner in owners
    }


def _built(shape: Shape, numbers: Iterable[int], trials: Sequence[Trial]) -> Small:
    """Return these topics and all they inherit from, saying the tried frames and nothing else."""
    wanted = set(numbers)
    lenders = Topic.also.through.objects.values_list("from_topic_id", "to_topic_id")
    wanted |= {lender for borrower, lender in lenders if borrower in wanted}
    for number in tuple(wanted):
        wanted.update(shape.above(number))
    frames: dict[int | None, list[Frame]] = {}
    for one in trials:
        frames.setdefault(one.owner, []).append(one.frame)
    knowledge = read_part(wanted, shape.keys, frames=False)
    topics = tuple(
        msgspec.structs.replace(topic, frames=tuple(frames.get(topic.number, ())))
        for topic in knowledge.topics
    )
    sane, findings = sound(msgspec.structs.replace(knowledge, topics=topics))
    return Small(sane, build_tree(sane), tuple(findings))


def _names(frames: Iterable[Frame]) -> Names:
    """Return every topic's name in the languages in which a pool line asks for a form of it."""
    asked: set[str] = set()
    for frame in frames:
        asked |= {code for code, text in frame.texts.items() if "Name." in text}
    found: Names = {}
    rows: Iterable[TopicName] = ()
    if asked:
        rows = TopicName.objects.filter(language__in=asked).select_related("topic")
    for row in rows:
        fields: Mapping[str, str] = row.fields
        found.setdefault(row.language, {})[row.topic.key] = {"name": row.name, **fields}
    return found
