"""forget: the person wants the agent to forget what it learned about them."""

from collections.abc import Mapping

from dialogue.engine.saying import say_from_pool
from dialogue.engine.turn import Turn


def forget(turn: Turn, parameters: Mapping[str, str | None]) -> bool:
    """Take every learned likeliness out of the state."""
    turn.state = turn.state.forgotten()
    turn.note("forget", "All learned likeliness is gone.")
    return turn.heard.plan_said or say_from_pool(turn, "forget")
