"""more: the person wants to stay with the topic."""

from collections.abc import Mapping

from dialogue.engine.actions.tell import KINDS, tell
from dialogue.engine.flow import carry_on
from dialogue.engine.turn import Turn


def more(turn: Turn, parameters: Mapping[str, str | None]) -> bool:
    """Tell another one after a joke or a story; else a remark about the topic, then ask."""
    last = turn.content.tree.lines.get(turn.state.frames[-1]) if turn.state.frames else None
    if last and last.type in KINDS:
        return tell(turn, {"kind": last.type})
    turn.change(ordering="cw")
    turn.note("more", "Stay with the topic.")
    carry_on(turn)
    return True
