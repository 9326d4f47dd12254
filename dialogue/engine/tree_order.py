"""The one order of topics: branch after branch, classes before leaves, else as experts put them."""

from collections.abc import Iterable, Mapping

from dialogue.engine.concepts import ROOT, Topic


def in_tree_order(topics: Iterable[Topic]) -> tuple[Topic, ...]:
    """Return the topics as files and publications hold them; neighbours keep their order."""
    topics = tuple(topics)
    branch_of = branches(topics)
    classes = {topic.is_a for topic in topics}
    return tuple(sorted(topics, key=lambda topic: (branch_of[topic.key], topic.key not in classes)))


def branches(topics: Iterable[Topic]) -> Mapping[str, str]:
    """Return the branch of each topic, by key; one in a circle stands alone (a check names it)."""
    above = {topic.key: topic.is_a for topic in topics}
    found: dict[str, str] = {}
    for key in above:
        path: list[str] = []
        place = key
        while place not in found and above.get(place, ROOT) != ROOT and place not in path:
            path.append(place)
            place = above[place]
        branch = key if place in path else found.get(place, place)
        found |= dict.fromkeys([key, *path], branch)
    return found
