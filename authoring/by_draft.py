"""What is worked out from the whole draft: once a version of it, for all requests of a worker."""

from collections.abc import Callable
from threading import Lock
from typing import Generic, TypeVar

from dialogue.draft import draft_version

ValueT = TypeVar("ValueT")
_all: list["ByDraft[object]"] = []


class ByDraft(Generic[ValueT]):
    """A value read from the draft; it is read again once the draft has another version."""

    def __init__(self, read: Callable[[], ValueT]) -> None:
        self._read = read
        self._kept: tuple[int, ValueT] | None = None
        self._lock = Lock()
        _all.append(self)  # type: ignore[arg-type]

    def __call__(self) -> ValueT:
        """Return the value; one query where it is known already."""
        with self._lock:
            version = draft_version()
            if self._kept is None or self._kept[0] != version:
                self._kept = (version, self._read())
            return self._kept[1]

    def forget(self) -> None:
        """Read anew at the next call."""
        self._kept = None


def forget_all() -> None:
    """Forget every value: for tests, whose drafts share their version numbers."""
    for value in _all:
        value.forget()
