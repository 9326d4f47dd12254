"""Bodies in and out: JSON, plain or compressed, within limits."""

import re
import zlib
from collections.abc import Mapping
from typing import IO, Any, Protocol

import msgspec
from django.conf import settings
from rest_framework.negotiation import BaseContentNegotiation
from rest_framework.parsers import BaseParser
from rest_framework.renderers import BaseRenderer
from rest_framework.request import Request

from cair_site.errors import ApiError
from cair_site.turn_facts import LANGUAGE
from languages.known import LANGUAGES
from plans.timing import DECODE, lap

DEFLATE, GZIP = "deflate", "gzip"
MOST_DIGITS = 12  # of a Content-Length
# Possessive: nothing is tried twice, so nothing is remembered, however long a text is.
_TEXTS = re.compile(rb'"(?:[^"\\]++|\\.)*+"?', re.DOTALL)
_NO_BRACKETS = bytes(set(range(256)) - set(b"[]{}"))


class Readable(Protocol):
    """What a body is read from."""

    def read(self, size: int, /) -> bytes:
        """Return up to so many bytes."""


class BodyParser(BaseParser):
    """Any media type, or none: clients that exist send JSON without saying so."""

    media_type = "*/*"

    def parse(
        self,
        stream: IO[bytes],
        media_type: str | None = None,
        parser_context: Mapping[str, Any] | None = None,
    ) -> Any:
        """Return the JSON object of the body; ApiError where it is none or too large."""
        request = (parser_context or {})["request"]
        with lap(DECODE):
            body, encoding = inflated(read_bytes(request, stream))
            request._request.cair_encoding = encoding
            message = parse_json(body)
        _note_language(request, message)
        return message


def _note_language(request: Any, message: Mapping[str, Any]) -> None:
    """Keep which language was asked for, for the counts: one of ours, else the default."""
    given = message.get("language")
    code = given[:2].lower() if isinstance(given, str) else ""
    request.META[LANGUAGE] = code if code in LANGUAGES else settings.CAIR_LANGUAGE


def read_bytes(request: Any, stream: Readable) -> bytes:
    """Return the raw body, refused before it is read where it is too long."""
    length = request.META.get("CONTENT_LENGTH") or "0"
    if (
        not length.isdecimal()
        or len(length) > MOST_DIGITS
        or int(length) > settings.CAIR_LONGEST_BODY
    ):
        raise ApiError("body.too_large")
    return stream.read(int(length))


def inflated(body: bytes) -> tuple[bytes, str]:
    """Return the body without its compression, which is told by its first bytes."""
    if body[:1] == b"\x78":
        return _inflate(body, zlib.MAX_WBITS), DEFLATE
    if body[:2] == b"\x1f\x8b":
        return _inflate(body, zlib.MAX_WBITS | 16), GZIP
    return body, ""


def _inflate(body: bytes, window: int) -> bytes:
    machine = zlib.decompressobj(window)
    try:
        text = machine.decompress(body, settings.CAIR_LONGEST_INFLATED)
    except zlib.error as error:
        raise ApiError("body.not_compressed") from error
    if machine.unconsumed_tail:
        raise ApiError("body.inflates_too_large")
    if not machine.eof:
        raise ApiError("body.not_compressed")
    return text


def deflated(body: bytes, encoding: str) -> bytes:
    """Return the body in the encoding of the request."""
    if encoding == DEFLATE:
        return zlib.compress(body, 6)
    machine = zlib.compressobj(6, zlib.DEFLATED, zlib.MAX_WBITS | 16)
    return machine.compress(body) + machine.flush()


def parse_json(body: bytes) -> dict[str, Any]:
    """Return the object a body holds; ApiError where it holds something else."""
    if not body.strip():
        return {}
    if too_deep(body, settings.CAIR_DEEPEST_JSON):
        raise ApiError("body.too_deep")
    try:
        data = msgspec.json.decode(body)
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError) as error:
        raise ApiError("body.not_json") from error
    if not isinstance(data, dict):
        raise ApiError("body.not_an_object")
    return data


def too_deep(body: bytes, deepest: int) -> bool:
    """Say whether brackets nest deeper than allowed; linear, brackets in texts do not count."""
    if body.count(b"[") + body.count(b"{") <= deepest:
        return False
    depth = 0
    for bracket in _TEXTS.sub(b"", body).translate(None, _NO_BRACKETS):
        depth += 1 if bracket in b"[{" else -1
        if depth > deepest:
            return True
    return False


class JSONRenderer(BaseRenderer):
    """JSON as compact as it gets, compressed where the request was."""

    media_type = "application/json"
    format = "json"
    charset = None
    render_style = "binary"

    def render(
        self,
        data: Any,
        accepted_media_type: str | None = None,
        renderer_context: Mapping[str, Any] | None = None,
    ) -> bytes:
        """Return the bytes of an answer."""
        body = msgspec.json.encode(data) if data is not None else b""
        context = renderer_context or {}
        encoding = getattr(getattr(context.get("request"), "_request", None), "cair_encoding", "")
        if not encoding:
            return body
        context["response"]["Content-Encoding"] = encoding
        return deflated(body, encoding)


class AlwaysJSON(BaseContentNegotiation):
    """No negotiation: robots send odd Accept headers and always want JSON."""

    def select_parser(self, request: Request, parsers: Any) -> Any:
        """Return the only parser."""
        return parsers[0]

    def select_renderer(self, request: Request, renderers: Any, format_suffix: Any = None) -> Any:
        """Return the first renderer of the view."""
        return renderers[0], renderers[0].media_type
