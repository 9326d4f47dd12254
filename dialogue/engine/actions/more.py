"""more: the person wants to stay with the topic."""

from collections.abc import Mapping

from dialogue.engine.flow import carry_on
from dialogue.engine.turn import Turn


def more(turn: Turn, parameters: Mapping[str, str | None]) -> bool:
    """Say a remark about the current topic, and ask about it next."""
    turn.change(ordering="cw")
    turn.note("more", "Stay with the topic.")
    carry_on(turn)
    return True
