"""setlikeliness: the person said how much they like something (Algorithm 1, lines 4-8)."""

from collections.abc import Mapping

from dialogue.engine.find_topic import named_topic
from dialogue.engine.turn import Turn


def set_likeliness(turn: Turn, parameters: Mapping[str, str | None]) -> bool:
    """Set the likeliness of a known topic; the talk goes on.

    A value strictly between 0 and 1 never lowers what the person showed before, unless it is
    below a half: then it is a wish not to hear of the topic.
    """
    node = named_topic(turn, parameters.get("topic") or "")
    value = _number(parameters.get("value"))
    if node is None or value is None:
        turn.note("setlikeliness", f"No topic {parameters.get('topic')!r}: nothing to do.")
        return False
    if 0.5 <= value < 1:
        value = max(turn.likeliness(node), value)
    turn.state = turn.state.with_likeliness(node.number, value)
    turn.note("setlikeliness", f"{node.key}: likeliness {value}")
    return False


def _number(text: str | None) -> float | None:
    try:
        value = float(text or "")
    except ValueError:
        return None
    return value if 0 <= value <= 1 else None
