"""What the person answered to a yes/no question, and what that does to likeliness.

The rule: a strong yes 1.0; a yes 0.9, or one tenth more where it was already that high; a little
0.6; it depends 0.5; not really 0.2; a no 0.1; a strong no 0.0. (The predecessor knew 1.0 and 0.0.)
"""

from collections.abc import Mapping
from types import MappingProxyType

from dialogue.engine.tree import Node
from dialogue.engine.turn import Turn
from languages.language import Attitude

_LIKELINESS: Mapping[Attitude, float] = MappingProxyType(
    {
        Attitude.YES_STRONG: 1.0,
        Attitude.YES: 0.9,
        Attitude.A_LITTLE: 0.6,
        Attitude.DEPENDS: 0.5,
        Attitude.NOT_REALLY: 0.2,
        Attitude.NO: 0.1,
        Attitude.NO_STRONG: 0.0,
    }
)
FAVOURABLE = frozenset({Attitude.YES_STRONG, Attitude.YES, Attitude.A_LITTLE})
UNFAVOURABLE = frozenset({Attitude.NOT_REALLY, Attitude.NO, Attitude.NO_STRONG})


def learn(turn: Turn, node: Node, attitude: Attitude) -> None:
    """Move the likeliness of a topic by an answer."""
    if attitude not in _LIKELINESS:
        return
    value = _LIKELINESS[attitude]
    if attitude is Attitude.YES and turn.likeliness(node) >= value:
        value = 1.0
    turn.state = turn.state.with_likeliness(node.number, value)
    turn.note("learn", f"{attitude.name} to {node.key}: likeliness {value}")


def reaction(attitude: Attitude) -> str:
    """Return the type that fits the answer: p, n, or "" where it is neither yes nor no."""
    if attitude in FAVOURABLE:
        return "p"
    return "n" if attitude in UNFAVOURABLE else ""
