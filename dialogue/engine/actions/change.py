"""change: the person wants another subject, whichever."""

from collections.abc import Mapping

from dialogue.engine.flow import carry_on
from dialogue.engine.saying import say_from_pool
from dialogue.engine.turn import Turn


def change(turn: Turn, parameters: Mapping[str, str | None]) -> bool:
    """Go to another branch of the tree."""
    if not turn.heard.plan_said:
        turn.announced = say_from_pool(turn, "change_asked")
    turn.moving = True
    turn.change(ordering="", noes=2)
    carry_on(turn)
    return True
