"""tell: a joke, a riddle, a story ... that the person asked for."""

from collections.abc import Mapping

from dialogue.engine.saying import say_from_pool
from dialogue.engine.turn import Turn

#: What can be told; each is a pool, so that no line comes twice in a while.
KINDS = frozenset(
    ("joke", "riddle", "proverb", "curiosity", "story", "poem", "prayer", "breathing")
)


def tell(turn: Turn, parameters: Mapping[str, str | None]) -> bool:
    """Tell something of the kind asked for; the talk stays where it was."""
    kind = parameters.get("kind") or ""
    if kind not in KINDS:
        turn.note("tell", f"There is nothing of the kind {kind!r} to tell.")
        return False
    turn.note("tell", f"A {kind} was asked for.")
    return say_from_pool(turn, kind)
