"""How often something may happen: buckets that fill up again, in the memory of one worker."""

import threading
import time
from collections import OrderedDict
from collections.abc import Callable, Hashable
from dataclasses import dataclass, field

MOST_BUCKETS = 50_000


class TooOftenError(RuntimeError):
    """The calls of this minute are used up; `seconds` says how long to wait."""

    def __init__(self, seconds: int) -> None:
        super().__init__(f"Wait {seconds} seconds.")
        self.seconds = seconds


@dataclass(slots=True)
class _Bucket:
    left: float
    filled: float


@dataclass
class Rates:
    """A bucket for each name: it holds the calls of one minute and fills up evenly.

    The names used longest ago are forgotten where there are more than MOST_BUCKETS.
    """

    clock: Callable[[], float] = time.monotonic
    buckets: OrderedDict[Hashable, _Bucket] = field(default_factory=OrderedDict)
    lock: threading.Lock = field(default_factory=threading.Lock)

    def take(self, name: Hashable, rate: int) -> None:
        """Take a call from a bucket of `rate` calls a minute. Raises TooOftenError."""
        with self.lock:
            now = self.clock()
            bucket = self.buckets.setdefault(name, _Bucket(float(rate), now))
            self.buckets.move_to_end(name)
            if len(self.buckets) > MOST_BUCKETS:
                self.buckets.popitem(last=False)
            grown = bucket.left + (now - bucket.filled) * rate / 60
            bucket.left, bucket.filled = min(float(rate), grown), now
            if bucket.left < 1:
                raise TooOftenError(int((1 - bucket.left) * 60 / rate) + 1)
            bucket.left -= 1
