"""The order of rows: as the file says, new ones last, and nothing moved that need not move."""

from collections import defaultdict
from collections.abc import Hashable, Iterable, Mapping, Sequence
from typing import NamedTuple, TypeVar

from dialogue.engine.concepts import Topic
from dialogue.engine.tree_order import in_tree_order
from ontology_io.owl.line import in_line

T = TypeVar("T", bound=Hashable)
_LAST = 1_000_000_000


class Place(NamedTuple):
    """Where the file puts a row, and where the draft has it; from 1, 0 where one says nothing."""

    order: int
    before: int


def in_order(rows: Iterable[tuple[T, Place]]) -> list[T]:
    """Return the rows as the file orders them.

    Rows of one number keep the order of the draft, what is new before them; what the file gives
    no number follows the one before it in the draft; what is new and has none comes last, in the
    order given here.
    """
    found = list(enumerate(rows))
    keys: dict[int, tuple[int, bool, int, int]] = {}
    last = 0
    for index, (_, place) in sorted(found, key=lambda one: one[1][1].before or _LAST):
        if place.before:
            last = place.order or last
            keys[index] = (last, True, place.before, index)
        else:
            keys[index] = (place.order or _LAST, False, 0, index)
    return [row for index, (row, _) in sorted(found, key=lambda one: keys[one[0]])]


def places(keys: Iterable[T]) -> dict[T, int]:
    """Return the place of each, from 1."""
    return {key: place for place, key in enumerate(keys, 1)}


def sibling_places(topics: Iterable[Topic]) -> dict[str, int]:
    """Return the place of each topic among those below the same parent, from 1."""
    counts: dict[str, int] = defaultdict(int)
    found = {}
    for topic in topics:
        counts[topic.is_a] += 1
        found[topic.key] = counts[topic.is_a]
    return found


def topics_in_order(
    topics: Iterable[Topic],
    orders: Mapping[str, int],
    old_keys: Mapping[str, str],
    draft: Sequence[Topic],
) -> tuple[Topic, ...]:
    """Return the topics in tree order.

    `orders` are the places among siblings that the file gives, by key; `old_keys` the key in the
    draft of each topic it has. Topics of the draft stay where they are; only siblings that stand
    in another order change places with one another.
    """
    by_key = {topic.key: topic for topic in topics}
    before = _stayed(by_key, old_keys, draft)
    below: dict[str, list[tuple[str, Place]]] = defaultdict(list)
    for key in sorted(by_key):
        place = Place(orders.get(key, 0), before.get(key, 0))
        below[by_key[key].is_a].append((key, place))
    siblings = {parent: in_order(rows) for parent, rows in below.items()}
    new = places(
        topic.key for topic in in_line(by_key[key] for keys in siblings.values() for key in keys)
    )
    line = places(topic.key for topic in draft)
    base = sorted(by_key, key=lambda key: (line.get(old_keys.get(key, ""), _LAST), new[key]))
    following = {parent: iter(keys) for parent, keys in siblings.items()}
    return in_tree_order(by_key[next(following[by_key[key].is_a])] for key in base)


def _stayed(
    topics: Mapping[str, Topic], old_keys: Mapping[str, str], draft: Sequence[Topic]
) -> dict[str, int]:
    """Return the place among its siblings in the draft of each that is still below the same."""
    new_keys = {old: key for key, old in old_keys.items()}
    parents = {topic.key: new_keys.get(topic.is_a, topic.is_a) for topic in draft}
    found = sibling_places(draft)
    return {
        key: found[old_keys[key]]
        for key, topic in topics.items()
        if key in old_keys and parents[old_keys[key]] == topic.is_a
    }
