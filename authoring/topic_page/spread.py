"""How likeliness is spread over a branch in each culture, and where one topic stands."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass

from django.db.models import Count

from dialogue.models import TopicInstance

STEP = 0.05
BARS = 21
_WIDTH, _HEIGHT = 8, 40


@dataclass(frozen=True, slots=True)
class Bar:
    """One bar of the picture, in the picture's units; `here` is the topic's own."""

    x: int
    y: float
    height: float
    here: bool


@dataclass(frozen=True, slots=True)
class Spread:
    """The spread of a branch in one culture; numbers are likeliness from 0 to 1."""

    least: float
    middle: float
    most: float
    topics: int
    bars: tuple[Bar, ...]

    @property
    def width(self) -> int:
        """Return the width of the picture."""
        return BARS * _WIDTH

    @property
    def bar_width(self) -> int:
        """Return the width of a bar, with a gap to the next one."""
        return _WIDTH - 2

    @property
    def height(self) -> int:
        """Return the height of the picture."""
        return _HEIGHT


def spread(counts: Mapping[float, int], own: float | None) -> Spread | None:
    """Return the spread of values with how often each comes; None where there are none."""
    total = sum(counts.values())
    if not total:
        return None
    heights = [0] * BARS
    for value, count in counts.items():
        heights[_place(value)] += count
    highest = max(heights)
    values = sorted(counts)
    return Spread(
        values[0],
        _middle(counts, total),
        values[-1],
        total,
        tuple(
            _bar(place, count / highest, here=own is not None and place == _place(own))
            for place, count in enumerate(heights)
        ),
    )


def _place(value: float) -> int:
    return min(max(round(value / STEP), 0), BARS - 1)


def _bar(place: int, share: float, *, here: bool) -> Bar:
    least = 3 if share or here else 1
    height = max(round(share * _HEIGHT, 1), least)
    return Bar(place * _WIDTH, _HEIGHT - height, height, here)


def _middle(counts: Mapping[float, int], total: int) -> float:
    passed = 0
    for value in sorted(counts):
        passed += counts[value]
        if passed * 2 >= total:
            return value
    return 0.0


def read_spread(numbers: Collection[int]) -> dict[int, dict[float, int]]:
    """Return by culture how often each likeliness comes among these topics; one query."""
    rows = TopicInstance.objects.filter(topic__in=numbers).values("culture", "likeliness")
    found: dict[int, dict[float, int]] = {}
    for row in rows.annotate(count=Count("pk")).order_by():
        found.setdefault(row["culture"], {})[float(row["likeliness"])] = row["count"]
    return found
