"""How cost grows: a ratio within one run, never seconds on a clock."""

import time
from collections.abc import Callable

FACTOR = 8


def grows_like_a_line(work: Callable[[int], object], size: int) -> bool:
    """Say whether eight times the size costs far less than the 64 times of a square."""
    small, large = _least(work, size), _least(work, FACTOR * size)
    return large <= FACTOR * 3 * small + 2_000_000


def _least(work: Callable[[int], object], size: int) -> int:
    costs = []
    for _ in range(3):
        before = time.process_time_ns()
        work(size)
        costs.append(time.process_time_ns() - before)
    return min(costs)
