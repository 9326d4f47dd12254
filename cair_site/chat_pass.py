"""The pass of the web chat: where calls need a key, the page's own calls need this cookie.

It is signed, of a quarter of an hour, unreadable for scripts, sent to our API alone and by our
pages alone, and good for what the chat does. The page is fetched again when it has ended. It does
not say who somebody is; calls are limited for each pass and for each address.
"""

import secrets

from django.conf import settings
from django.core.signing import BadSignature, TimestampSigner
from django.http import HttpRequest, HttpResponse

from authoring.addresses import caller
from authoring.rates import Rates

COOKIE = "cair_chat"
SECONDS = 900
PATHS = frozenset(("/api/v1/hub/", "/api/v1/dialogue/explain/"))
#: People behind one address, at most, who talk as fast as one may.
PEOPLE = 10

_rates = Rates()


def wanted() -> bool:
    """Say whether the chat needs a pass and the operator lets it have one."""
    return bool(settings.CAIR_KEYS_REQUIRED and settings.CAIR_CHAT_RATE)


def give(response: HttpResponse) -> None:
    """Send a new pass with the page, which nobody may keep."""
    response.set_cookie(
        COOKIE,
        _signer().sign(secrets.token_urlsafe(9)),
        max_age=SECONDS,
        path="/api/v1/",
        secure=settings.CAIR_HTTPS,
        httponly=True,
        samesite="Strict",
    )
    response.headers["Cache-Control"] = "no-store"


def lets_in(request: HttpRequest) -> bool:
    """Say whether a call has a pass that is good for it. Raises TooOftenError."""
    given = request.COOKIES.get(COOKIE, "") if wanted() else ""
    if not given or request.path_info not in PATHS:
        return False
    try:
        visitor = _signer().unsign(given, max_age=SECONDS)
    except BadSignature:
        return False
    _rates.take(("address", caller(request)), PEOPLE * settings.CAIR_CHAT_RATE)
    _rates.take(("visitor", visitor), settings.CAIR_CHAT_RATE)
    return True


def _signer() -> TimestampSigner:
    return TimestampSigner(salt="cair.chat")
