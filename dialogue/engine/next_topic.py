"""Next(DT, topic): where the talk goes when a topic is completed (Algorithm 1, line 31)."""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from dialogue.engine.chance import draw
from dialogue.engine.people import unspoken_people
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
    options = _weighed(turn, numbers)
    chosen = draw(options, turn.chance)
    if options and turn.heard.explain:
        likely = [(node, turn.likeliness(node)) for node, _ in options]
        turn.note("next", f"{chosen.key if chosen else 'none'} drawn: {what}", likely)
    return chosen


def _weighed(turn: Turn, numbers: Iterable[int]) -> list[tuple[Node, float]]:
    """Return the topics that may be proposed now, with how willingly.

    The square of likeliness, so that what is at home somewhere comes up there most of the time.
    A class may have hundreds of topics, so what is the same for all of them is looked up once.
    """
    state, nodes = turn.state, turn.content.tree.nodes
    started, people = frozenset(state.topics), unspoken_people(turn)
    options = []
    for number in numbers:
        node = nodes.get(number)
        if node is None or node.gentle or number in started or state.language not in node.names:
            continue
        path = (number, *node.ancestors)
        if people in path or (state.avoided and state.avoids(path)):
            continue
        likeliness = turn.likeliness(node)
        if likeliness > LEAST_LIKELINESS:
            covered = node.is_leaf and state.used_slots(number)
            options.append((node, likeliness**2 * (ALREADY_COVERED if covered else 1.0)))
    return options
