"""Who stands around a topic, with names in the person's language: what a picture is drawn from."""

from collections.abc import Collection, Mapping, Sequence

from authoring.topic_page.picture import ABOVE, BELOW, FROM, LENDER, LINK
from authoring.topic_page.shape import Shape
from authoring.topic_page.words import own_language
from dialogue.models import Topic, TopicLink, TopicName


def neighbours(shape: Shape, number: int) -> dict[str, list[tuple[int, str]]]:
    """Return number and name by role; four queries."""
    links = TopicLink.objects.filter(topic=number).values_list("target_id", flat=True)
    from_ = TopicLink.objects.filter(target=number).values_list("topic_id", flat=True)
    lent = Topic.also.through.objects.filter(from_topic=number).order_by("id")
    groups: dict[str, Sequence[int]] = {
        ABOVE: shape.above(number)[::-1],
        BELOW: shape.children.get(number, ()),
        LINK: list(links),
        FROM: list(from_.distinct()),
        LENDER: list(lent.values_list("to_topic_id", flat=True)),
    }
    everyone = {number for group in groups.values() for number in group}
    called = names_of(shape, everyone)
    return {role: [(one, called[one]) for one in group] for role, group in groups.items()}


def names_of(shape: Shape, numbers: Collection[int]) -> Mapping[int, str]:
    """Return what topics are called in the person's language, else their keys; one query."""
    rows = TopicName.objects.filter(topic__in=numbers, language=own_language())
    found = dict(rows.values_list("topic_id", "name"))
    return {number: found.get(number) or shape.keys.get(number, "") for number in numbers}
