"""Start-up checks: a mistake in the settings is told with what to do about it."""

from collections.abc import Iterable
from typing import Any

from django.conf import settings
from django.core.checks import CheckMessage, Error, Warning, register, run_checks

from languages.known import LANGUAGES

TAG = "cair"
SHORTEST, FEWEST_DIFFERENT = 32, 8
_OWN = ("127.", "localhost", "[::1]", "unix:", "fd://")


@register(TAG)
def language_is_known(**kwargs: Any) -> list[CheckMessage]:
    """Check that the default language is one the service speaks."""
    if settings.CAIR_LANGUAGE in LANGUAGES:
        return []
    hint = f"Set CAIR_LANGUAGE to one of {', '.join(LANGUAGES)}."
    return [Error(f"CAIR_LANGUAGE is {settings.CAIR_LANGUAGE!r}.", hint=hint, id="cair.E001")]


@register(TAG)
def state_keys_are_long(**kwargs: Any) -> list[CheckMessage]:
    """Check that states are signed with keys that cannot be guessed."""
    if not any(_weak(key) for key in settings.CAIR_STATE_KEYS):
        return []
    hint = "Give keys of 32 characters or more; `openssl rand -hex 32` makes one."
    return [
        Error("A key in CAIR_STATE_KEYS is too short or too simple.", hint=hint, id="cair.E002")
    ]


@register(TAG)
def services_have_addresses(**kwargs: Any) -> list[CheckMessage]:
    """Check that addresses of other services are http or https."""
    wrong = [
        name
        for name in ("CAIR_PLAN_MANAGER_URL", "CAIR_DIALOGUE_MANAGER_URL")
        if (url := getattr(settings, name)) and not url.startswith(("http://", "https://"))
    ]
    hint = "Write http://host:port/api/v1/plan/ or …/dialogue/."
    return [Error(f"{name} is no web address.", hint=hint, id="cair.E003") for name in wrong]


@register(TAG)
def debug_is_off(**kwargs: Any) -> list[CheckMessage]:
    """Warn where debug pages would show too much."""
    if not settings.DEBUG:
        return []
    return [Warning("CAIR_DEBUG is on.", hint="Never serve people with it.", id="cair.W001")]


@register(TAG)
def secret_keys_are_long(**kwargs: Any) -> list[CheckMessage]:
    """Check that sessions are signed with keys that cannot be guessed."""
    keys = (settings.SECRET_KEY, *settings.SECRET_KEY_FALLBACKS)
    if not any(_weak(key) for key in keys):
        return []
    hint = "Give keys of 32 characters or more; `openssl rand -hex 32` makes one."
    told = "A key in CAIR_SECRET_KEY or CAIR_SECRET_KEYS is too short or too simple."
    return [Error(told, hint=hint, id="cair.E004")]


@register(TAG)
def tokens_are_long(**kwargs: Any) -> list[CheckMessage]:
    """Check that the token of /metrics cannot be guessed, where one is set."""
    token = settings.CAIR_METRICS_TOKEN
    if not token or not _weak(token, 20):
        return []
    hint = "Give 20 characters or more; `openssl rand -hex 32` makes one."
    return [Error("CAIR_METRICS_TOKEN is too short.", hint=hint, id="cair.E005")]


def _weak(key: str, shortest: int = SHORTEST) -> bool:
    default = key.startswith("django-insecure-") or "changeme" in key.lower().replace("-", "")
    return len(key) < shortest or len(set(key)) < FEWEST_DIFFERENT or default


def refuse_to_serve(addresses: Iterable[str]) -> str:
    """Return why this site must not be served at these addresses, "" where it may be.

    `addresses` are those of gunicorn: "127.0.0.1:8000", "[::]:80", "unix:/run/cair".
    """
    found = [f"{one.msg} {one.hint}" for one in run_checks(tags=[TAG]) if one.is_serious()]
    open_to_all = [one for one in addresses if not one.startswith(_OWN)]
    if settings.DEBUG and open_to_all:
        found.append(f"CAIR_DEBUG is on, and {open_to_all[0]} is open to others.")
    return " ".join(found)
