"""The shape of the tree of topics: who is above whom, without anything they say."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from dialogue.models import Topic


@dataclass(frozen=True, slots=True)
class Shape:
    """Keys and parents by number, in the order of lists; a branch's parent is None."""

    keys: Mapping[int, str]
    parents: Mapping[int, int | None]
    children: Mapping[int | None, tuple[int, ...]]

    def above(self, number: int) -> tuple[int, ...]:
        """Return the topics above one, the nearest first; a circle ends where it closes."""
        found: list[int] = []
        place = self.parents.get(number)
        while place is not None and place not in found and place != number:
            found.append(place)
            place = self.parents.get(place)
        return tuple(found)

    def branch(self, number: int) -> int:
        """Return the branch that a topic belongs to."""
        return (number, *self.above(number))[-1]

    def below(self, number: int) -> tuple[int, ...]:
        """Return every topic below one, those nearer first."""
        found = dict.fromkeys(self.children.get(number, ()))
        waiting = list(found)
        for place in waiting:
            fresh = [child for child in self.children.get(place, ()) if child not in found]
            found |= dict.fromkeys(fresh)
            waiting += fresh
        return tuple(found)

    @property
    def branches(self) -> tuple[int, ...]:
        """Return the topics directly below the root."""
        return self.children.get(None, ())


def read_shape() -> Shape:
    """Return the shape of the draft; one query."""
    rows = list(Topic.objects.values_list("pk", "key", "parent_id"))
    children: dict[int | None, list[int]] = {}
    for number, _key, parent in rows:
        children.setdefault(parent, []).append(number)
    return Shape(
        keys={number: key for number, key, _parent in rows},
        parents={number: parent for number, _key, parent in rows},
        children={parent: tuple(below) for parent, below in children.items()},
    )


def path_of(shape: Shape, number: int) -> Iterator[tuple[int, str]]:
    """Yield number and key of the topics above one and of itself, the branch first."""
    for place in (*shape.above(number)[::-1], number):
        yield place, shape.keys[place]
