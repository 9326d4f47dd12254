"""list: the person asks what there is to talk about."""

from collections.abc import Mapping

from dialogue.engine.next_topic import far_topic
from dialogue.engine.saying import say_from_pool
from dialogue.engine.turn import Turn

HOW_MANY = 3


def list_topics(turn: Turn, parameters: Mapping[str, str | None]) -> bool:
    """Name a few topics of different branches and leave the choice to the person."""
    names: dict[int, str] = {}
    for _ in range(4 * HOW_MANY):
        step = far_topic(turn, turn.node)
        if step and len(names) < HOW_MANY:
            names.setdefault(step.node.branch, step.node.names[turn.state.language].forms[""])
    if not names:
        return False
    joined = turn.language.listed(tuple(names.values()))
    return say_from_pool(turn, "list", words={"list": joined})
