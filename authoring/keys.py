"""The keys of the API in memory: a turn is let in without asking the database.

Each worker loads the keys once; a thread of its own looks for new and revoked ones every
CAIR_POLL_SECONDS and notes, at most once an hour, on which day each key was last used.
"""

import hashlib
import hmac
import logging
import secrets
import threading
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from django.conf import settings
from django.db import DatabaseError, close_old_connections
from django.utils import timezone

from authoring.models.api_key import ApiKey
from authoring.rates import Rates
from authoring.rates import TooOftenError as TooOftenError

logger = logging.getLogger(__name__)

BEGIN = "cair_"
PREFIX_LENGTH = len(BEGIN) + 8
LONGEST_KEY = 100
NOTED_EVERY = 3600.0
_NO_DIGEST = "0" * 64


class UnknownKeyError(LookupError):
    """There is no such key, or it was revoked."""


class KeysUnreadableError(RuntimeError):
    """The keys have never been read, and cannot be read now."""


def digest_of(key: str) -> str:
    """Return the SHA-256 of a key as 64 hexadecimal digits."""
    return hashlib.sha256(key.encode("utf-8", "surrogatepass")).hexdigest()


def make_key(label: str, rate: int | None, author: Any, ontology: str = "") -> tuple[ApiKey, str]:
    """Make a key; return its row and the key itself, which is kept nowhere.

    Raises ValidationError where the label, the rate or what it may do is wrong.
    """
    key = BEGIN + secrets.token_urlsafe(32)
    row = ApiKey(label=label, rate=rate, created_by=author, ontology=ontology)
    row.prefix, row.digest = key[:PREFIX_LENGTH], digest_of(key)
    row.full_clean()
    row.save()
    return row, key


def revoke(row: ApiKey) -> None:
    """Let nobody in with a key any more; workers hear of it within CAIR_POLL_SECONDS."""
    if row.revoked is None:
        row.revoked = timezone.now()
        row.save(update_fields=["revoked"])


@dataclass(frozen=True, slots=True)
class Known:
    """What is remembered of a key that lets in."""

    number: int
    digest: str
    rate: int | None
    ontology: str = ""


@dataclass
class Ring:
    """The keys of one worker."""

    clock: Callable[[], float] = time.monotonic
    keys: Mapping[str, Known] | None = None
    used: set[int] = field(default_factory=set)
    noted: dict[int, float] = field(default_factory=dict)
    rates: Rates = field(init=False)

    def __post_init__(self) -> None:
        self.rates = Rates(self.clock)

    def let_in(self, key: str) -> Known:
        """Let a call with this key pass. Raises UnknownKeyError or TooOftenError."""
        if self.keys is None:
            self.load()
        known = (self.keys or {}).get(key[:PREFIX_LENGTH])
        given = digest_of(key[:LONGEST_KEY])
        same = hmac.compare_digest(given, known.digest if known else _NO_DIGEST)
        if known is None or not same:
            raise UnknownKeyError
        self.used.add(known.number)
        if known.rate is not None:
            self.rates.take(known.number, known.rate)
        return known

    def load(self) -> None:
        """Read the keys. Raises KeysUnreadableError; those read before stay."""
        try:
            rows = list(ApiKey.objects.filter(revoked=None))
        except DatabaseError as error:
            raise KeysUnreadableError from error
        self.keys = {row.prefix: Known(row.pk, row.digest, row.rate, row.ontology) for row in rows}

    def note_use(self) -> None:
        """Write down the day on which keys were used, each at most once an hour."""
        now = self.clock()
        due = {
            one
            for one in tuple(self.used)
            if now - self.noted.get(one, -NOTED_EVERY) >= NOTED_EVERY
        }
        if due:
            today = timezone.now().date()
            rows = ApiKey.objects.filter(pk__in=due).exclude(last_used=today)
            rows.update(last_used=today)
            self.noted |= dict.fromkeys(due, now)
            self.used -= due


@dataclass(slots=True)
class _Worker:
    ring: Ring = field(default_factory=Ring)
    watcher: threading.Thread | None = None


_worker = _Worker()
_starting = threading.Lock()


def let_in(key: str) -> Known:
    """Let a call pass and return what its key may do; no query once the keys are loaded.

    Raises UnknownKeyError, TooOftenError or KeysUnreadableError.
    """
    if _worker.watcher is None:
        _start()
    return _worker.ring.let_in(key)


def forget() -> None:
    """Begin with no keys, as a new worker does."""
    _worker.ring = Ring()


def _start() -> None:
    with _starting:
        if _worker.watcher is None:
            _worker.watcher = threading.Thread(target=_watch, name="keys", daemon=True)
            _worker.watcher.start()


def _watch() -> None:
    pause = threading.Event()
    while not pause.wait(settings.CAIR_POLL_SECONDS):
        try:
            look()
        except Exception as error:  # noqa: BLE001 - a watch that ends would see nothing ever again
            # The keys known so far go on letting in; the next look may succeed.
            logger.warning("Cannot read the keys: %r", error)


def look() -> None:
    """Take over new and revoked keys, and note which were used."""
    try:
        _worker.ring.load()
        _worker.ring.note_use()
    finally:
        close_old_connections()
