"""The body of an ontology that a program sends: a file as it is, within its own limit."""

from collections.abc import Mapping
from typing import IO, Any

from django.conf import settings
from rest_framework.parsers import BaseParser

from cair_site.errors import ApiError
from cair_site.messages import MOST_DIGITS

LIMIT = "Send less than CAIR_LONGEST_ONTOLOGY bytes."
#: Forms: what curl says where it is told nothing, having joined the lines of the file.
FORMS = ("application/x-www-form-urlencoded", "multipart/form-data")


class OwlParser(BaseParser):
    """Any media type but forms; the file may be gzipped."""

    media_type = "*/*"

    def parse(
        self,
        stream: IO[bytes],
        media_type: str | None = None,
        parser_context: Mapping[str, Any] | None = None,
    ) -> Any:
        """Return the bytes of the file; ApiError where it is none, or (not read then) too long."""
        if (media_type or "").partition(";")[0].strip().lower() in FORMS:
            raise ApiError("ontology.no_file")
        length = (parser_context or {})["request"].META.get("CONTENT_LENGTH") or "0"
        longest = settings.CAIR_LONGEST_ONTOLOGY
        known = length.isascii() and length.isdecimal() and len(length) <= MOST_DIGITS
        if not known or int(length) > longest:
            raise ApiError("body.too_large", hint=LIMIT)
        return stream.read(int(length))
