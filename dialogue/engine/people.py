"""Relatives and friends: talked about when the person does, never brought up by the agent."""

from dialogue.engine.tree import PEOPLE, Node
from dialogue.engine.turn import Turn


def is_about_people(turn: Turn, node: Node) -> bool:
    """Say whether a topic is about relatives or friends."""
    people = turn.content.tree.by_key.get(PEOPLE)
    return people is not None and (node is people or people.number in node.ancestors)
