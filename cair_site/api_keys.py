"""The door of the API: with CAIR_KEYS_REQUIRED, calls need a key that the admin has made.

The ontology needs one always, and one that may have it. The web chat has a pass instead of a key.
With CAIR_ADDRESS_RATE, calls without a key that we know are limited for each address.
"""

import re
from collections.abc import Callable
from http import HTTPStatus

from django.conf import settings
from django.http import HttpRequest, HttpResponse, JsonResponse

from authoring.addresses import caller
from authoring.keys import KeysUnreadableError, Known, TooOftenError, UnknownKeyError, let_in
from authoring.models.api_key import ONTOLOGY, READ, WRITE
from authoring.rates import Rates
from cair_site import chat_pass
from cair_site.errors import ApiError, error_json

Next = Callable[[HttpRequest], HttpResponse]
_GUARDED = re.compile(r"/api/v1/|/(?:[a-z]{2}/)?CAIR_hub")
_ONTOLOGY = re.compile(r"/api/v1/ontology(?:/|$)")
_READING = frozenset(("GET", "HEAD", "OPTIONS"))
SCHEME = "api-key"
KNOWN = "cair.key"

_addresses = Rates()


class ApiKeys:
    """Asks calls of /api/v1/ and /CAIR_hub for their key; other pages pass."""

    def __init__(self, get_response: Next) -> None:
        self.get_response = get_response

    def __call__(self, request: HttpRequest) -> HttpResponse:
        """Answer, or refuse with 401, 403, 429 or 503 in the shape of our errors."""
        if _ONTOLOGY.match(request.path_info):
            needed = READ if request.method in _READING else WRITE
            return _refusal(request, needed) or self.get_response(request)
        if not _GUARDED.match(request.path_info):
            return self.get_response(request)
        if settings.CAIR_KEYS_REQUIRED:
            return _refusal_of_chat(request) or self.get_response(request)
        if settings.CAIR_ADDRESS_RATE:
            return _refusal_of_address(request) or self.get_response(request)
        return self.get_response(request)


def _refusal(request: HttpRequest, needed: str = "") -> HttpResponse | None:
    """Return why a call is not let in; None where it is. `needed` is a row of ONTOLOGY."""
    try:
        request.META[KNOWN] = _let_in(request, needed)
    except TooOftenError as error:
        return _refused(ApiError("key.too_often"), _wait(error))
    except UnknownKeyError:
        return _refused(ApiError("key.unknown"))
    except KeysUnreadableError:
        return _refused(ApiError("key.unchecked"))
    except ApiError as error:
        headers = {"WWW-Authenticate": "Api-Key"} if error.status == HTTPStatus.UNAUTHORIZED else {}
        return _refused(error, headers)
    return None


def _refusal_of_chat(request: HttpRequest) -> HttpResponse | None:
    """Return why a call with neither a key nor a pass is not let in; None where it is."""
    if not _has_key(request):
        try:
            if chat_pass.lets_in(request):
                return None
        except TooOftenError as error:
            return _refused(ApiError("address.too_often"), _wait(error))
    return _refusal(request)


def _refusal_of_address(request: HttpRequest) -> HttpResponse | None:
    """Return why a call is not let in where no key is needed; None where it is."""
    try:
        if _has_key(request):
            let_in(_key(request))
            return None
    except TooOftenError as error:
        return _refused(ApiError("key.too_often"), _wait(error))
    except (UnknownKeyError, KeysUnreadableError):
        pass  # as good as none
    try:
        _addresses.take(caller(request), settings.CAIR_ADDRESS_RATE)
    except TooOftenError as error:
        return _refused(ApiError("address.too_often"), _wait(error))
    return None


def _wait(error: TooOftenError) -> dict[str, str]:
    return {"Retry-After": str(error.seconds)}


def _let_in(request: HttpRequest, needed: str) -> Known:
    known = let_in(_key(request))
    if _rank(known.ontology) < _rank(needed):
        raise ApiError("key.not_enough")
    return known


def key_of(request: HttpRequest) -> Known:
    """Return the key that let a call in. Raises KeyError where none was asked for."""
    known: Known = request.META[KNOWN]
    return known


def _rank(ontology: str) -> int:
    return list(ONTOLOGY).index(ontology)


def _key(request: HttpRequest) -> str:
    """Return the key of a call: `Authorization: Api-Key <key>` or `X-Api-Key: <key>`."""
    given = _given(request)
    if not given:
        raise ApiError("key.missing")
    return given


def _has_key(request: HttpRequest) -> bool:
    return bool(_given(request))


def _given(request: HttpRequest) -> str:
    scheme, _blank, key = request.headers.get("Authorization", "").strip().partition(" ")
    return (key if scheme.lower() == SCHEME else request.headers.get("X-Api-Key", "")).strip()


def _refused(error: ApiError, headers: dict[str, str] | None = None) -> HttpResponse:
    return JsonResponse(error_json(error), status=error.status, headers=headers)
