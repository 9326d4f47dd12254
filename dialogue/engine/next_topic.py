"""Next(DT, topic): where the talk goes when a topic is completed (Algorithm 1, line 31)."""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from dialogue.engine.chance import draw
from dialogue.engine.people import is_about_people
from dialogue.engine.tree import Node
from dialogue.engine.turn import Turn

MOST_SIBLINGS = 3
FOLLOW_A_LINK = 0.45
LEAST_LIKELINESS = 0.05
ALREADY_COVERED = 0.2
DISLIKED = 0.2


class Step(NamedTuple):
    """The topic that follows and how it is reached: child, sibling, link or far."""

    node: Node
    way: str


def next_topic(turn: Turn, node: Node | None) -> Step | None:
    """Return a child, else a sibling (three in a row at most), else a linked topic, else a far one.

    None only where the tree has nothing left that may be proposed.
    """
    if node is None:
        return far_topic(turn, None)
    for way, numbers in _ways(turn, node):
        chosen = _draw_topic(turn, numbers, f"{way} of {node.key}")
        if chosen is not None:
            return Step(_down_to_a_concept(turn, chosen), way)
    return far_topic(turn, node)


def _ways(turn: Turn, node: Node) -> Iterable[tuple[str, Sequence[int]]]:
    tree = turn.content.tree
    shown = turn.state.likeliness(node.number)
    if shown is None or shown > DISLIKED:  # Who dislikes tea does not want green tea next.
        yield "child", node.children
    tired = turn.state.siblings >= MOST_SIBLINGS
    link_first = tired or turn.chance.random() < FOLLOW_A_LINK
    if link_first:
        yield "link", node.links
    if not tired:
        yield "sibling", tree.siblings(node)
    if not link_first:
        yield "link", node.links


def another_branch(turn: Turn, node: Node) -> Step | None:
    """Return a topic that has nothing to do with this one: a link out of the branch, or far."""
    tree = turn.content.tree
    outside = [
        number
        for number in node.links
        if (linked := tree.node(number)) and linked.branch != node.branch
    ]
    chosen = _draw_topic(turn, outside, f"link out of the branch of {node.key}")
    if chosen is not None:
        return Step(_down_to_a_concept(turn, chosen), "link")
    return far_topic(turn, node)


def far_topic(turn: Turn, node: Node | None) -> Step | None:
    """Return a topic of another branch, drawn from the root down by likeliness."""
    tree = turn.content.tree
    recent = {
        tree.nodes[number].branch for number in turn.state.topics[-6:] if number in tree.nodes
    }
    here = {node.branch} if node else set()
    for left_out in (recent | here, here, set[int]()):
        branches = [number for number in tree.branches if number not in left_out]
        branch = _draw_topic(turn, branches, "branch near the root")
        if branch is not None:
            return Step(_down_to_a_concept(turn, branch), "far")
    return None


def _down_to_a_concept(turn: Turn, node: Node) -> Node:
    """Return a concrete topic below a branch, group or class: "tea" rather than "drinking"."""
    while node.children:
        below = _draw_topic(turn, node.children, f"below {node.key}")
        if below is None:
            return node
        node = below
    return node


def _draw_topic(turn: Turn, numbers: Sequence[int], what: str) -> Node | None:
    options = [
        (node, weight)
        for number in numbers
        if (node := turn.content.tree.node(number)) and (weight := _weight(turn, node))
    ]
    chosen = draw(options, turn.chance)
    if options and turn.heard.explain:
        likely = [(node, turn.likeliness(node)) for node, _ in options]
        turn.note("next", f"{chosen.key if chosen else 'none'} drawn: {what}", likely)
    return chosen


def _weight(turn: Turn, node: Node) -> float:
    """Return how willingly the agent proposes a topic now; 0 keeps it out.

    The square of likeliness, so that what is at home somewhere comes up there most of the time.
    """
    state = turn.state
    if node.gentle or node.number in state.topics or state.language not in node.names:
        return 0.0
    if state.avoided and state.avoids((node.number, *node.ancestors)):
        return 0.0
    likeliness = turn.likeliness(node)
    if likeliness <= LEAST_LIKELINESS or _would_bring_up_people(turn, node):
        return 0.0
    covered = node.is_leaf and state.used_slots(node.number)
    return likeliness**2 * (ALREADY_COVERED if covered else 1.0)


def _would_bring_up_people(turn: Turn, node: Node) -> bool:
    """Say whether the agent would speak of wives or brothers to someone who did not."""
    return is_about_people(turn, node) and not (turn.node and is_about_people(turn, turn.node))
