"""The order in which files hold topics: it follows from the order of siblings alone."""

from collections import defaultdict
from collections.abc import Iterable

from dialogue.engine.concepts import ROOT, Topic
from dialogue.engine.tree_order import in_tree_order


def in_line(topics: Iterable[Topic]) -> tuple[Topic, ...]:
    """Return the topics with each followed by what lies below it, then in tree order.

    Whatever the order of topics that are no siblings was, the same siblings give the same line.
    """
    below: dict[str, list[Topic]] = defaultdict(list)
    keys: dict[str, None] = {}
    for topic in topics:
        below[topic.is_a].append(topic)
        keys[topic.key] = None
    found: dict[str, Topic] = {}
    for start in [ROOT, *(key for key in below if key != ROOT and key not in keys), *keys]:
        waiting = below.get(start, [])[::-1]
        while waiting:
            topic = waiting.pop()
            if topic.key not in found:
                found[topic.key] = topic
                waiting += below.get(topic.key, [])[::-1]
    return in_tree_order(found.values())
