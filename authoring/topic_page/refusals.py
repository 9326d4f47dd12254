"""Why a sentence cannot be kept, before it is: read from as few rows as that takes."""

from authoring.topic_page.shape import read_shape
from authoring.topic_page.small_knowledge import read_small, who_says, with_frame
from authoring.topic_page.trial import (
    Problem,
    pool_misfits,
    pool_problems,
    unreadable,
    unsayable,
)
from dialogue.engine.concepts import Frame
from dialogue.models import TopicName

Names = dict[str, dict[str, dict[str, str]]]


def refusals(frame: Frame, owner: int | None, pool: str = "") -> list[Problem]:
    """Return why the frame of a topic (its number) or of a pool cannot be said as it is.

    Every topic that would say it is tried: those below, and those that borrow from it.
    """
    problems = unreadable(frame.texts)
    if problems:
        return problems
    if owner is None:
        return pool_problems(pool, frame.texts) or pool_misfits(frame.texts, _names(frame))
    shape = read_shape()
    if owner not in shape.keys:
        return []
    among = who_says(shape, owner)
    small = with_frame(read_small(shape, among, frames=False), owner, frame)
    return unsayable(small, frame.number, among)


def _names(frame: Frame) -> Names:
    codes = [code for code, text in frame.texts.items() if "Name." in text]
    found: Names = {}
    rows = TopicName.objects.filter(language__in=codes).select_related("topic")
    for row in rows.only("language", "name", "fields", "topic__key") if codes else ():
        fields = {"name": row.name, **row.fields}
        found.setdefault(row.language, {})[row.topic.key] = fields
    return found
