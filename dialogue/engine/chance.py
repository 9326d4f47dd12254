"""Chance: every draw takes a Random, so that a seeded talk can be had again."""

from collections.abc import Sequence
from random import Random
from typing import TypeVar

from plans.engine.chance import chance_for as chance_for

Item = TypeVar("Item")


def draw(options: Sequence[tuple[Item, float]], chance: Random) -> Item | None:
    """Return one option, drawn by weight; None where no weight is above zero."""
    total = sum([weight for _, weight in options])
    if total <= 0:
        return None
    point = chance.random() * total
    for option, weight in options:
        point -= weight
        if point < 0:
            return option
    return next(option for option, weight in reversed(options) if weight > 0)
