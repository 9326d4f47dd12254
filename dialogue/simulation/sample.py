"""A sample of filled sentences for a reader who did not write them: so many of each class."""

from collections.abc import Iterator
from random import Random
from typing import NamedTuple

from dialogue.engine.content import Content
from dialogue.engine.tree import Node


class Heard(NamedTuple):
    """One sentence as people hear it: the frame, the topic, the culture, the words."""

    frame: str
    topic: str
    culture: str
    text: str


def sample(content: Content, language: str, count: int, seed: int) -> Iterator[Heard]:
    """Yield `count` sentences, the classes in turn; the same seed gives the same sample."""
    chance = Random(f"sample {language} {seed}")
    classes = _classes(content)
    waiting: list[list[Node]] = []
    for number in range(count):
        if not waiting:
            waiting = [list(leaves) for leaves in classes]
            chance.shuffle(waiting)
        node = chance.choice(waiting.pop())
        culture = content.cultures[number % len(content.cultures)]
        lines = [
            line for lines in node.lines.values() for line in lines if line.fits(language, culture)
        ]
        line = chance.choice(lines)
        to = chance.choice([content.tree.nodes[one] for one in node.links] or [node])
        names = {"hasName": node.names[language], "toName": to.names[language]}
        words = node.variables.get(language, {})
        yield Heard(line.key, node.key, culture, line.templates[language].fill(names, words))


def _classes(content: Content) -> list[list[Node]]:
    """Return the leaves below each topic that has leaves and says something itself."""
    below: dict[int, list[Node]] = {}
    for node in content.tree.nodes.values():
        if node.is_leaf and node.parent:
            below.setdefault(node.parent, []).append(node)
    return [leaves for _number, leaves in sorted(below.items())]
