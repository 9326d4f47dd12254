"""Relatives and friends: talked about when the person does, never brought up by the agent."""

from dialogue.engine.tree import PEOPLE, Node
from dialogue.engine.turn import Turn


def is_about_people(turn: Turn, node: Node) -> bool:
    """Say whether a topic is about relatives or friends."""
    people = turn.content.tree.by_key.get(PEOPLE)
    return people is not None and (node is people or people.number in node.ancestors)


def unspoken_people(turn: Turn) -> int:
    """Return the topic of relatives and friends where the person does not speak of theirs, else 0.

    The agent does not bring up wives or brothers.
    """
    people = turn.content.tree.by_key.get(PEOPLE)
    if people is None or (turn.node and is_about_people(turn, turn.node)):
        return 0
    return people.number
