"""Server-Timing (W3C): how long the server worked on an answer, and on which part of it.

`total` is from the first to the last instruction of the view; `decode` reads body and state,
`match` is the Plan Manager, `dialogue` the Dialogue Manager, `encode` writes state and body.
"""

import time
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar

HEADER = "Server-Timing"
DECODE, MATCH, DIALOGUE, ENCODE = "decode", "match", "dialogue", "encode"

_laps: ContextVar[dict[str, float] | None] = ContextVar("laps", default=None)


class lap:  # noqa: N801 (used like a function: `with lap(MATCH):`)
    """Counts the time of what runs inside as a part of the answer being made, if one is."""

    __slots__ = ("_began", "_laps", "_name")

    def __init__(self, name: str) -> None:
        self._name = name

    def __enter__(self) -> None:
        self._laps = _laps.get()
        self._began = time.perf_counter()

    def __exit__(self, *_error: object) -> None:
        laps = self._laps
        if laps is not None:
            laps[self._name] = laps.get(self._name, 0.0) + time.perf_counter() - self._began


@contextmanager
def timed() -> Iterator[dict[str, float]]:
    """Measure an answer: the parts in seconds, "total" once it is there."""
    laps: dict[str, float] = {}
    token = _laps.set(laps)
    began = time.perf_counter()
    try:
        yield laps
    finally:
        _laps.reset(token)
        laps["total"] = time.perf_counter() - began


def header(laps: dict[str, float]) -> str:
    """Return the value of the header, in milliseconds: `match;dur=0.052, total;dur=0.61`."""
    return ", ".join(f"{name};dur={1000 * seconds:.3f}" for name, seconds in laps.items())
