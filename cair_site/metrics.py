"""What is counted for Prometheus, over all workers; nothing of it comes from what people say.

gunicorn's configuration names a folder in which each worker keeps its numbers in a file that is
mapped into memory; whoever is asked adds them up. Without that folder (tests, runserver) a process
counts for itself. The values of labels are a closed list: the languages, the codes of errors.
"""

import os
import time
from collections.abc import Iterator
from functools import lru_cache

from prometheus_client import CollectorRegistry, Counter, Histogram, generate_latest
from prometheus_client.core import GaugeMetricFamily
from prometheus_client.multiprocess import MultiProcessCollector
from prometheus_client.registry import Collector

from dialogue.publishing import served_number
from languages.known import LANGUAGES

FOLDER = "PROMETHEUS_MULTIPROC_DIR"
CONTENT_TYPE = "text/plain; version=0.0.4; charset=utf-8"
SERVICES = ("hub", "plan", "dialogue", "compat")
OTHER = "other"
SECONDS = (0.0005, 0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.25, 0.5, 1, 2.5, 5)
CHARACTERS = (100, 200, 400, 800, 1600, 3200, 6400, 12_800, 25_600, 64_000)

_ours = CollectorRegistry()
_turns = Counter(
    "cair_turns",
    "Turns answered: by service, language, and whether the answer holds a plan.",
    ("service", "language", "plan"),
    registry=_ours,
)
_seconds = Histogram(
    "cair_turn_seconds",
    "Seconds from the first to the last instruction of the site for a turn.",
    ("service",),
    buckets=SECONDS,
    registry=_ours,
)
_state = Histogram(
    "cair_state_characters",
    "Characters of the dialogue states in the answers.",
    buckets=CHARACTERS,
    registry=_ours,
)
_errors = Counter("cair_errors", "Errors told to clients, by code.", ("code",), registry=_ours)
_slow = Counter(
    "cair_slow_turns", "Turns that took longer than CAIR_SLOW_MS, logged or not.", registry=_ours
)
_logins = Counter("cair_logins", "Logins to the admin, by result.", ("result",), registry=_ours)
_started = time.time()


class _Site(Collector):
    """What is no count: the release of the worker that is asked, and since when the site runs."""

    def collect(self) -> Iterator[GaugeMetricFamily]:
        """Yield the gauges."""
        number = served_number()
        yield GaugeMetricFamily(
            "cair_release",
            "Number of the release that the asked worker serves; 0 for none.",
            value=number or 0,
        )
        yield GaugeMetricFamily(
            "cair_start_time_seconds", "When the site was started (Unix time).", value=_started
        )
        yield GaugeMetricFamily(
            "cair_uptime_seconds", "Seconds since then.", value=time.time() - _started
        )


def count_turn(service: str, language: str, seconds: float, *, plan: bool, state: int) -> None:
    """Count a turn; `state` is the number of characters of the state it answers, 0 for none."""
    _turns_of(service, language if language in LANGUAGES else OTHER, plan).inc()
    _seconds_of(service).observe(seconds)
    if state:
        _state.observe(state)


def count_error(code: str) -> None:
    """Count an error by its code; one of no table is "other"."""
    from cair_site.errors import ERRORS  # The table's module counts errors itself.

    _errors.labels(code if code in ERRORS else OTHER).inc()


def count_slow() -> None:
    """Count a slow turn."""
    _slow.inc()


def count_login(result: str) -> None:
    """Count a login: "done", "failed" or "locked"."""
    _logins.labels(result).inc()


def text() -> bytes:
    """Return all numbers in the text format of Prometheus."""
    if not os.environ.get(FOLDER):
        return generate_latest(_Both())
    registry = CollectorRegistry()
    MultiProcessCollector(registry)  # type: ignore[no-untyped-call]
    registry.register(_Site())
    return generate_latest(registry)


class _Both(CollectorRegistry):
    """The numbers of this process alone."""

    def __init__(self) -> None:
        super().__init__()
        self.register(_ours)
        self.register(_Site())


@lru_cache(len(SERVICES) * 2 * 10)
def _turns_of(service: str, language: str, plan: bool) -> Counter:
    return _turns.labels(service, language, "yes" if plan else "no")


@lru_cache(len(SERVICES))
def _seconds_of(service: str) -> Histogram:
    return _seconds.labels(service)
