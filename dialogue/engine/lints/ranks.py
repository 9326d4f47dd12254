"""Spearman's rank correlation, with shared ranks for equal values."""

from collections.abc import Sequence
from statistics import StatisticsError, correlation


def rank_correlation(one: Sequence[float], other: Sequence[float]) -> float:
    """Return -1..1; 0 where nothing can be compared: fewer than two values, or all alike."""
    try:
        return correlation(_ranks(one), _ranks(other))
    except StatisticsError:
        return 0.0


def _ranks(values: Sequence[float]) -> list[float]:
    places: dict[float, list[int]] = {}
    for place, value in enumerate(sorted(values)):
        places.setdefault(value, []).append(place)
    return [sum(places[value]) / len(places[value]) for value in values]
