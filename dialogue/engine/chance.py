"""Chance: every draw takes a Random, so that a seeded talk can be had again."""

from collections.abc import Sequence
from random import Random
from typing import TypeVar

Item = TypeVar("Item")

_SPREAD = 0x9E3779B97F4A7C15  # 2**64 divided by the golden ratio: neighbours fall far apart


def chance_for(seed: int, turn: int) -> Random:
    """Return the chance of one turn: fresh for seed 0, else the same each time."""
    if not seed:
        return Random()
    return Random((seed * _SPREAD + turn) % 2**64)


def draw(options: Sequence[tuple[Item, float]], chance: Random) -> Item | None:
    """Return one option, drawn by weight; None where no weight is above zero."""
    total = sum(weight for _, weight in options)
    if total <= 0:
        return None
    point = chance.random() * total
    for option, weight in options:
        point -= weight
        if point < 0:
            return option
    return next(option for option, weight in reversed(options) if weight > 0)
