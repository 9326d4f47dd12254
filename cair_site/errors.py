"""Every error a client can get, in one shape: a stable code, what happened, what to do."""

import logging
from traceback import format_tb
from typing import Any, NamedTuple

import msgspec
from django.core.exceptions import DisallowedHost, RequestDataTooBig
from django.http import Http404, HttpRequest, JsonResponse
from rest_framework.exceptions import APIException, MethodNotAllowed, NotFound
from rest_framework.response import Response

from dialogue.engine.codec import StateError
from dialogue.publishing import NothingPublishedError
from plans.choices import UnknownChoiceError

logger = logging.getLogger(__name__)


class Kind(NamedTuple):
    """One row of the table of errors."""

    status: int
    message: str
    hint: str


ERRORS: dict[str, Kind] = {
    "body.too_large": Kind(
        413, "The body is too large.", "Send less than CAIR_LONGEST_BODY bytes."
    ),
    "body.inflates_too_large": Kind(
        413, "The body becomes too large when inflated.", "Send less than CAIR_LONGEST_INFLATED."
    ),
    "body.not_compressed": Kind(
        400, "The body looks compressed but cannot be inflated.", "Send whole zlib, gzip or JSON."
    ),
    "body.not_json": Kind(400, "The body is no JSON.", "Send a JSON object in UTF-8."),
    "body.not_an_object": Kind(
        400, "The body is JSON but no object.", 'Send an object, e.g. {"client_sentence": "Hello"}.'
    ),
    "body.too_deep": Kind(400, "The JSON is nested too deeply.", "Send a flat object."),
    "body.invalid": Kind(400, "A field of the body is wrong.", "See /api/docs/ for the fields."),
    "state.unreadable": Kind(
        400, "The dialogue state cannot be read.", "Send it as you got it, or none to start again."
    ),
    "state.damaged": Kind(
        400, "The dialogue state is damaged or not ours.", "Send no state to start again."
    ),
    "state.version": Kind(
        400, "The dialogue state is of another version.", "Send no state to start again."
    ),
    "state.too_large": Kind(
        413, "The dialogue state is too large.", "Send no state to start again."
    ),
    "language.unknown": Kind(400, "There is no such language.", "See GET /api/v1/hub/options/."),
    "culture.unknown": Kind(400, "There is no such culture.", "See GET /api/v1/hub/options/."),
    "content.not_published": Kind(
        503, "Nothing is published yet.", "Ask again later; operators: run manage.py publish."
    ),
    "service.unreachable": Kind(
        503, "The Dialogue Manager does not answer.", "Ask again in a moment with the same state."
    ),
    "host.unknown": Kind(
        400, "This server does not answer to that name.", "Operators: add it to CAIR_HOSTS."
    ),
    "key.missing": Kind(
        401, "This server wants a key.", "Send Authorization: Api-Key <key>, or X-Api-Key: <key>."
    ),
    "key.unknown": Kind(
        403, "There is no such key, or it was revoked.", "Ask whoever runs this server for one."
    ),
    "key.not_enough": Kind(
        403, "This key may not do that.", "Ask whoever runs this server for one that may."
    ),
    "key.too_often": Kind(
        429, "This key is used too often.", "Wait as many seconds as Retry-After says."
    ),
    "address.too_often": Kind(
        429, "Too many calls from this address.", "Wait as many seconds as Retry-After says."
    ),
    "key.unchecked": Kind(503, "Keys cannot be checked just now.", "Ask again in a moment."),
    "release.unknown": Kind(404, "There is no such release.", "Leave it out to get the draft."),
    "release.damaged": Kind(500, "The release is damaged.", "Choose another release."),
    "ontology.no_file": Kind(
        400,
        "The body is no file.",
        "Send the OWL file itself, with Content-Type: application/rdf+xml.",
    ),
    "ontology.damaged": Kind(
        400, "The gzip file is damaged or becomes too large.", "Compress it again."
    ),
    "ontology.busy": Kind(
        409, "Somebody is bringing in an ontology.", "Wait until that import has ended."
    ),
    "ontology.unknown_import": Kind(404, "There is no such import.", "Send the file again."),
    "not_found": Kind(404, "There is nothing at this address.", "See /api/docs/."),
    "method.not_allowed": Kind(405, "This address does not know that method.", "See /api/docs/."),
    "request.refused": Kind(400, "The request was refused.", "See /api/docs/."),
    "server.error": Kind(500, "Something broke here; nothing of yours is lost.", "Send it again."),
}


class ApiError(Exception):
    """An error of the table, raised anywhere below a view."""

    def __init__(self, code: str, message: str = "", hint: str = "") -> None:
        kind = ERRORS[code]
        super().__init__(message or kind.message)
        self.code = code
        self.status = kind.status
        self.message = message or kind.message
        self.hint = hint or kind.hint


def error_json(error: ApiError) -> dict[str, dict[str, str]]:
    """Return the one shape of errors."""
    return {"error": {"code": error.code, "message": error.message, "hint": error.hint}}


#: Exceptions of libraries and of the layers below, the more special ones first.
_CODES: tuple[tuple[type[Exception], str], ...] = (
    (msgspec.ValidationError, "body.invalid"),
    (NothingPublishedError, "content.not_published"),
    (RequestDataTooBig, "body.too_large"),
    (DisallowedHost, "host.unknown"),
    (MethodNotAllowed, "method.not_allowed"),
    (NotFound, "not_found"),
    (Http404, "not_found"),
    (APIException, "request.refused"),
)
_TELLING = frozenset(("body.invalid", "method.not_allowed", "not_found", "request.refused"))


def named(error: Exception) -> ApiError | None:
    """Return the error of the table for an exception, None for a fault of ours."""
    if isinstance(error, ApiError):
        return error
    if isinstance(error, StateError):
        return ApiError(error.code)
    if isinstance(error, UnknownChoiceError):
        return ApiError(f"{error.kind}.unknown", str(error), error.hint)
    for kind, code in _CODES:
        if isinstance(error, kind):
            return ApiError(code, str(error) if code in _TELLING else "")
    return None


def answer_error(error: Exception, context: dict[str, Any]) -> Response:
    """Turn any exception below an API view into an answer; faults of ours are logged."""
    known = named(error)
    if known is None:
        log_fault(error)
        known = ApiError("server.error")
    return Response(error_json(known), status=known.status)


def log_fault(error: Exception) -> None:
    """Log where something of ours broke; not the exception's words, which may quote a person."""
    places = "".join(format_tb(error.__traceback__))
    logger.error("A turn failed: %s\n%s", type(error).__name__, places)


def bad_request(request: HttpRequest, exception: Exception) -> JsonResponse:
    """Answer what Django itself refuses, such as a name of this server it does not know."""
    error = named(exception) or ApiError("request.refused")
    return JsonResponse(error_json(error), status=error.status)


def not_found(request: HttpRequest, exception: Exception) -> JsonResponse:
    """Answer an unknown address."""
    return JsonResponse(error_json(ApiError("not_found")), status=404)


def server_error(request: HttpRequest) -> JsonResponse:
    """Answer after a fault outside the API."""
    return JsonResponse(error_json(ApiError("server.error")), status=500)
