"""Whether the topics of a sheet still make one tree."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from django.utils.translation import gettext as _

from authoring.topic_page.shape import Shape
from dialogue.engine.concepts import ROOT


class Change(NamedTuple):
    """What a line makes of a topic: the key above it, whether it is new or goes."""

    key: str
    above: str
    is_new: bool
    gone: bool


def misplaced(shape: Shape, changes: Sequence[Change]) -> Iterator[tuple[str, str]]:
    """Yield key and message of each topic that cannot stand where its line puts it.

    A line that leans on a refused one is refused too.
    """
    left = {one.key: one for one in changes}
    while True:
        found = dict(_misplaced(shape, left))
        yield from found.items()
        for key in found:
            del left[key]
        if not found:
            return


def _misplaced(shape: Shape, changes: dict[str, Change]) -> Iterator[tuple[str, str]]:
    above = {
        key: shape.keys.get(shape.parents[number] or 0, ROOT) for number, key in shape.keys.items()
    }
    gone = {one.key for one in changes.values() if one.gone}
    above |= {one.key: one.above for one in changes.values() if not one.gone}
    kept = {key: parent for key, parent in above.items() if key not in gone}
    orphans = {parent: key for key, parent in kept.items() if parent in gone}
    for one in changes.values():
        if one.gone and one.key in orphans:
            words = _("%s stands below it. Move or delete that first.")
            yield one.key, words % orphans[one.key]
        elif not one.gone and one.above != ROOT and one.above not in kept:
            words = _("%s, the topic above it, is deleted or has a mistake in its own line.")
            yield one.key, words % one.above
        elif not one.gone and _in_circle(one.key, kept):
            words = _("%s would lie below itself. Choose a topic that is not below it.")
            yield one.key, words % one.key


def _in_circle(key: str, above: dict[str, str]) -> bool:
    place, passed = above.get(key, ROOT), set[str]()
    while place != ROOT and place not in passed:
        if place == key:
            return True
        passed.add(place)
        place = above.get(place, ROOT)
    return False
