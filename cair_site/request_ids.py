"""The id of a request: one for each, in its answer and in every line of the log about it."""

import os
import re
from contextvars import ContextVar

HEADER = "X-Request-ID"
META = "HTTP_X_REQUEST_ID"
_SANE = re.compile(r"[A-Za-z0-9._-]{8,64}", re.ASCII)

#: "" outside of requests.
request_id: ContextVar[str] = ContextVar("request_id", default="")


def id_for(given: str) -> str:
    """Return the id that the caller or a proxy gave, 24 hexadecimal digits where it is not sane."""
    return given if _SANE.fullmatch(given) else os.urandom(12).hex()
