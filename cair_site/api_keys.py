"""The door of the API: with CAIR_KEYS_REQUIRED, calls need a key that the admin has made."""

import re
from collections.abc import Callable

from django.conf import settings
from django.http import HttpRequest, HttpResponse, JsonResponse

from authoring.keys import KeysUnreadableError, TooOftenError, UnknownKeyError, let_in
from cair_site.errors import ApiError, error_json

Next = Callable[[HttpRequest], HttpResponse]
_GUARDED = re.compile(r"/api/v1/|/(?:[a-z]{2}/)?CAIR_hub")
SCHEME = "api-key"


class ApiKeys:
    """Asks calls of /api/v1/ and /CAIR_hub for their key; other pages pass."""

    def __init__(self, get_response: Next) -> None:
        self.get_response = get_response

    def __call__(self, request: HttpRequest) -> HttpResponse:
        """Answer, or refuse with 401, 403, 429 or 503 in the shape of our errors."""
        if not settings.CAIR_KEYS_REQUIRED or not _GUARDED.match(request.path_info):
            return self.get_response(request)
        return _refusal(request) or self.get_response(request)


def _refusal(request: HttpRequest) -> HttpResponse | None:
    """Return why a call is not let in; None where it is."""
    try:
        let_in(_key(request))
    except TooOftenError as error:
        return _refused(ApiError("key.too_often"), {"Retry-After": str(error.seconds)})
    except UnknownKeyError:
        return _refused(ApiError("key.unknown"))
    except KeysUnreadableError:
        return _refused(ApiError("key.unchecked"))
    except ApiError as error:
        return _refused(error, {"WWW-Authenticate": "Api-Key"})
    return None


def _key(request: HttpRequest) -> str:
    """Return the key of a call: `Authorization: Api-Key <key>` or `X-Api-Key: <key>`."""
    scheme, _blank, key = request.headers.get("Authorization", "").strip().partition(" ")
    given = key if scheme.lower() == SCHEME else request.headers.get("X-Api-Key", "")
    if not given.strip():
        raise ApiError("key.missing")
    return given.strip()


def _refused(error: ApiError, headers: dict[str, str] | None = None) -> HttpResponse:
    return JsonResponse(error_json(error), status=error.status, headers=headers)
