"""Just the knowledge from which follows what the robot says about a few topics."""

from collections.abc import Collection, Iterable
from dataclasses import dataclass

import msgspec
from django.db.models import Value

from authoring.topic_page.shape import Shape
from authoring.topic_page.sound import sound
from dialogue.content import read_part
from dialogue.engine.build import build_tree
from dialogue.engine.concepts import Frame, Knowledge
from dialogue.engine.findings import Finding
from dialogue.engine.tree import Node, Tree
from dialogue.models import Topic, TopicLink


@dataclass(frozen=True, slots=True)
class Small:
    """A few topics with all above them and their lenders, built by the engine."""

    knowledge: Knowledge
    tree: Tree
    findings: tuple[Finding, ...]

    def node(self, number: int) -> Node:
        """Return a topic of the tree."""
        return self.tree.nodes[number]


def read_small(shape: Shape, numbers: Collection[int], *, frames: bool = True) -> Small:
    """Return these topics with all they inherit or borrow; about ten queries."""
    lenders = Topic.also.through.objects.filter(from_topic__in=numbers)
    wanted = {*numbers, *lenders.values_list("to_topic_id", flat=True)}
    for number in numbers:
        wanted.update(shape.above(number))
    return _built(read_part(wanted, shape.keys, frames=frames))


def read_small_with_next(shape: Shape, number: int) -> tuple[Small, int | None]:
    """Return a topic with all it says, and the first topic that it leads to, if any."""
    lenders = Topic.also.through.objects.filter(from_topic=number).order_by()
    links = TopicLink.objects.filter(topic=number).order_by()
    lent = lenders.values_list("to_topic_id", Value(-1), Value(0))
    rows = list(lent.union(links.values_list("target_id", "position", "pk"), all=True))
    linked = sorted(row[1:] + row[:1] for row in rows if row[1] >= 0)
    following = linked[0][2] if linked else None
    wanted = {number, *shape.above(number), *(row[0] for row in rows if row[1] < 0)}
    if following is not None:
        wanted |= {following, *shape.above(following)}
    return _built(read_part(wanted, shape.keys)), following


def with_frame(small: Small, owner: int, frame: Frame) -> Small:
    """Return the same with one frame written anew (or added) in the place of its old texts."""
    topics = []
    for topic in small.knowledge.topics:
        kept = tuple(one for one in topic.frames if one.number != frame.number)
        frames = (*kept, frame) if topic.number == owner else kept
        topics.append(msgspec.structs.replace(topic, frames=frames))
    return _built(msgspec.structs.replace(small.knowledge, topics=tuple(topics)))


def who_says(shape: Shape, owner: int) -> tuple[int, ...]:
    """Return every topic that may say the sentences of one: it, those below, its borrowers."""
    borrowers = Topic.also.through.objects.filter(to_topic=owner)
    return tuple(
        dict.fromkeys(
            (owner, *shape.below(owner), *borrowers.values_list("from_topic_id", flat=True))
        )
    )


def _built(knowledge: Knowledge) -> Small:
    sane, findings = sound(knowledge)
    return Small(sane, build_tree(sane), tuple(findings))


def saying(small: Small, number: int, among: Iterable[int]) -> list[Node]:
    """Return those topics that say the frame of this number."""
    nodes = [small.tree.nodes[one] for one in among if one in small.tree.nodes]
    return [
        node
        for node in nodes
        if any(line.number == number for lines in node.lines.values() for line in lines)
    ]
