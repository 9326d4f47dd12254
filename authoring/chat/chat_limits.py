"""How often one person may ask the test chat: so many turns a minute, in each worker."""

import threading
import time
from collections.abc import Callable
from dataclasses import dataclass, field

A_MINUTE = 600
MOST_PEOPLE = 1000


@dataclass
class Limit:
    """The buckets of all persons; `take` says how long one must wait."""

    clock: Callable[[], float] = time.monotonic
    left: dict[int, tuple[float, float]] = field(default_factory=dict)
    lock: threading.Lock = field(default_factory=threading.Lock)

    def take(self, person: int, turns: int) -> int:
        """Take so many turns; return 0, or how many seconds to wait where they are used up."""
        with self.lock:
            now = self.clock()
            if len(self.left) > MOST_PEOPLE:
                self.left.clear()
            left, filled = self.left.get(person, (float(A_MINUTE), now))
            left = min(float(A_MINUTE), left + (now - filled) * A_MINUTE / 60)
            if left < turns:
                self.left[person] = (left, now)
                return int((turns - left) * 60 / A_MINUTE) + 1
            self.left[person] = (left - turns, now)
            return 0


limit = Limit()
