"""Start-up checks: a mistake in the settings is told with what to do about it."""

from typing import Any

from django.conf import settings
from django.core.checks import CheckMessage, Error, Warning, register

from languages.known import LANGUAGES


@register
def language_is_known(**kwargs: Any) -> list[CheckMessage]:
    """Check that the default language is one the service speaks."""
    if settings.CAIR_LANGUAGE in LANGUAGES:
        return []
    hint = f"Set CAIR_LANGUAGE to one of {', '.join(LANGUAGES)}."
    return [Error(f"CAIR_LANGUAGE is {settings.CAIR_LANGUAGE!r}.", hint=hint, id="cair.E001")]


@register
def state_keys_are_long(**kwargs: Any) -> list[CheckMessage]:
    """Check that states are signed with keys that cannot be guessed."""
    if all(len(key) >= 32 for key in settings.CAIR_STATE_KEYS):
        return []
    hint = "Give keys of 32 characters or more; `openssl rand -hex 32` makes one."
    return [Error("A key in CAIR_STATE_KEYS is too short.", hint=hint, id="cair.E002")]


@register
def services_have_addresses(**kwargs: Any) -> list[CheckMessage]:
    """Check that addresses of other services are http or https."""
    wrong = [
        name
        for name in ("CAIR_PLAN_MANAGER_URL", "CAIR_DIALOGUE_MANAGER_URL")
        if (url := getattr(settings, name)) and not url.startswith(("http://", "https://"))
    ]
    hint = "Write http://host:port/api/v1/plan/ or …/dialogue/."
    return [Error(f"{name} is no web address.", hint=hint, id="cair.E003") for name in wrong]


@register
def debug_is_off(**kwargs: Any) -> list[CheckMessage]:
    """Warn where debug pages would show too much."""
    if not settings.DEBUG:
        return []
    return [Warning("CAIR_DEBUG is on.", hint="Never serve people with it.", id="cair.W001")]
