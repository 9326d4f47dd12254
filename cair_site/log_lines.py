"""The lines of the log: plain or JSON, with the id of the request, without anybody's words.

What an exception says may quote a person, and so may an address: a line tells where something
broke and at which of our routes.
"""

import logging
from datetime import UTC, datetime
from traceback import format_tb
from types import TracebackType
from typing import TypeAlias

import msgspec

from cair_site.request_ids import request_id

FIELDS = "fields"
_Info: TypeAlias = (
    "tuple[type[BaseException], BaseException, TracebackType | None] | tuple[None, None, None]"
)


def traced(error: BaseException | None) -> str:
    """Return where an exception and its causes were raised; not what they say."""
    told: list[str] = []
    while error is not None and len(told) < 5:
        told.append("".join(format_tb(error.__traceback__)) + type(error).__name__)
        error = error.__cause__ or (None if error.__suppress_context__ else error.__context__)
    return "\nafter\n".join(told)


class WithoutWords(logging.Filter):
    """Replaces what Django tells of a request (address, host, referrer) by status and route."""

    def filter(self, record: logging.LogRecord) -> bool:
        """Let every record pass, some with another message."""
        request = getattr(record, "request", None)
        if request is not None:
            record.msg = "Answered %s at %s"
            record.args = (getattr(record, "status_code", "?"), route_of(request))
        return True


def route_of(request: object) -> str:
    """Return the pattern of the address that was called, "?" for none of ours."""
    match = getattr(request, "resolver_match", None)
    return str(match.route) if match else "?"


class Plain(logging.Formatter):
    """A line for people."""

    def __init__(self) -> None:
        super().__init__("%(asctime)s %(levelname)s %(name)s: %(message)s")

    def formatMessage(self, record: logging.LogRecord) -> str:  # noqa: N802 - of the library
        """Return the line with its fields and the id of the request behind it."""
        fields = getattr(record, FIELDS, {})
        told = [super().formatMessage(record), *(f"{key}={value}" for key, value in fields.items())]
        if number := request_id.get():
            told.append(f"request_id={number}")
        return " ".join(told)

    def formatException(self, ei: _Info) -> str:  # noqa: N802 - of the library
        """Return the places of an exception without its words."""
        return traced(ei[1])


class Json(logging.Formatter):
    """One JSON object a line: time, level, logger, message, request_id, and the line's fields."""

    def format(self, record: logging.LogRecord) -> str:
        """Return the line."""
        line: dict[str, object] = {
            "time": datetime.fromtimestamp(record.created, UTC).isoformat(timespec="milliseconds"),
            "level": record.levelname,
            "logger": record.name,
            "message": record.getMessage(),
        }
        if number := request_id.get():
            line["request_id"] = number
        line |= getattr(record, FIELDS, {})
        if record.exc_info and record.exc_info[1]:
            line["trace"] = traced(record.exc_info[1])
        return msgspec.json.encode(line).decode()


FORMATTERS: dict[str, type[logging.Formatter]] = {"PLAIN": Plain, "JSON": Json}
