"""Whether a series of values grows: a straight line through it, and how sure its slope is."""

from dataclasses import dataclass
from math import sqrt
from statistics import fmean, linear_regression

FEWEST = 5
#: The first part of a series is warming up: caches fill, memory is asked for.
WARM_UP = 1 / 4
#: What may grow in an hour without being called growth, as a share of the level.
HARMLESS = 0.02
#: What is seen in less, in hours, is warming up and no trend.
SHORTEST = 0.25
#: Two-sided 95 % of Student's t, for so many degrees of freedom and more.
STUDENT = ((3, 3.18), (5, 2.57), (10, 2.23), (20, 2.09), (60, 2.0))


@dataclass(frozen=True, slots=True)
class Trend:
    """The slope of a series in units an hour, half of its 95 % interval, its level, its hours."""

    slope: float
    margin: float
    level: float
    hours: float

    @property
    def grows(self) -> bool:
        """Say whether it surely grows, and by more than is harmless."""
        long_enough = self.hours >= SHORTEST
        return long_enough and self.slope - self.margin > HARMLESS * self.level

    @property
    def sure(self) -> bool:
        """Say whether the interval is narrow enough to tell growth from none."""
        narrow = self.slope + self.margin < 10 * HARMLESS * self.level
        return self.grows or (self.hours >= SHORTEST and narrow)

    def text(self, unit: str, scale: float = 1.0) -> str:
        """Return it for people, e.g. `+0.1 ± 0.4 MB an hour at 172.0 MB: does not grow`."""
        told = "GROWS" if self.grows else "does not grow" if self.sure else "too short to tell"
        return (
            f"{self.slope / scale:+.2f} ± {self.margin / scale:.2f} {unit} an hour "
            f"at {self.level / scale:.1f} {unit}: {told}"
        )


def trend(seconds: list[float], values: list[float]) -> Trend | None:
    """Return the trend of values after warming up, None where there are too few."""
    first = int(len(values) * WARM_UP)
    hours, kept = [one / 3600 for one in seconds[first:]], values[first:]
    if len(kept) < FEWEST or hours[0] == hours[-1]:
        return None
    slope, start = linear_regression(hours, kept)
    middle = fmean(hours)
    left_over = sum((y - start - slope * x) ** 2 for x, y in zip(hours, kept, strict=True))
    spread = sum((x - middle) ** 2 for x in hours)
    error = sqrt(left_over / (len(kept) - 2) / spread)
    return Trend(slope, _student(len(kept) - 2) * error, fmean(kept), hours[-1] - hours[0])


def _student(degrees: int) -> float:
    return next(value for least, value in reversed(STUDENT) if degrees >= least)
