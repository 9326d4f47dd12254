"""Which catalogue the Plan Manager answers from: that of the publication being served."""

from collections.abc import Callable
from dataclasses import dataclass

from plans.engine.catalogue import Catalogue

Source = Callable[[], Catalogue]


@dataclass(slots=True)
class _Served:
    source: Source | None = None


_served = _Served()


def serve_from(source: Source) -> None:
    """Take the catalogue from here from now on; the app that publishes calls this at the start."""
    _served.source = source


def current() -> Catalogue:
    """Return the catalogue of the newest publication."""
    if _served.source is None:
        raise LookupError("No publication can be served: the dialogue app is not installed.")
    return _served.source()
