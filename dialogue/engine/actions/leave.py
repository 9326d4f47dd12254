"""leave: the person does not want to talk about something."""

from collections.abc import Mapping

from dialogue.engine.find_topic import named_topic
from dialogue.engine.flow import carry_on
from dialogue.engine.saying import say_from_pool
from dialogue.engine.tree import Node
from dialogue.engine.turn import Turn

STAY_OUT = 20  # turns


def leave(turn: Turn, parameters: Mapping[str, str | None]) -> bool:
    """Leave the topic (none given: this one) and stay out of it and of what is below it."""
    words = parameters.get("topic") or ""
    node = named_topic(turn, words) if words else turn.node
    if not turn.heard.plan_said:
        turn.announced = _say(turn, node)
    if node is not None:
        turn.state = turn.state.with_avoided(node.number, turn.state.turn + STAY_OUT)
        turn.note("leave", f"{node.key} stays out for {STAY_OUT} turns.")
    current = turn.node
    if node is None or (current and (current.gentle or node.branch == current.branch)):
        turn.moving = True
        turn.change(ordering="", noes=2)
    carry_on(turn)
    return True


def _say(turn: Turn, node: Node | None) -> bool:
    if node is None:
        return say_from_pool(turn, "change_asked")
    return say_from_pool(turn, "leave", {"hasName": node.names[turn.state.language]})
