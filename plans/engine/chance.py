"""The chance of one turn, the same in both managers."""

from random import Random

_SPREAD = 0x9E3779B97F4A7C15  # 2**64 divided by the golden ratio: neighbours fall far apart


def chance_for(seed: int, turn: int) -> Random:
    """Return the chance of one turn: fresh for seed 0, else the same each time."""
    if not seed:
        return Random()
    return Random((seed * _SPREAD + turn) % 2**64)
