"""The first and last hand on every request: its id, its counts, its line in the log if any.

For a turn this costs some microseconds (docs/performance.md): no lock is held, nothing is written.
"""

import logging
import re
import time
from collections.abc import Callable

from django.conf import settings
from django.http import HttpRequest, HttpResponse

from authoring.rates import Rates, TooOftenError
from cair_site import metrics
from cair_site.log_lines import FIELDS, route_of
from cair_site.request_ids import HEADER, META, id_for, request_id
from cair_site.turn_facts import Facts, error_code_of, facts_of
from dialogue.publishing import served_number
from plans import timing

Next = Callable[[HttpRequest], HttpResponse]
RELEASE = "X-CAIR-Release"
FAULT = 400

access = logging.getLogger("cair.access")
slow = logging.getLogger("cair.slow")
_LAP = re.compile(r"(\w+);dur=([0-9.]+)")
_slow_rate = Rates()


class Observed:
    """Gives each answer the id of its request, counts turns and errors, tells of slow turns."""

    def __init__(self, get_response: Next) -> None:
        self.get_response = get_response

    def __call__(self, request: HttpRequest) -> HttpResponse:
        """Answer, and keep count."""
        began = time.perf_counter()
        number = id_for(request.META.get(META, ""))
        token = request_id.set(number)
        try:
            response = self.get_response(request)
            response.headers[HEADER] = number
            _observe(request, response, began)
        finally:
            request_id.reset(token)
        return response


def _observe(request: HttpRequest, response: HttpResponse, began: float) -> None:
    if response.status_code >= FAULT:
        if code := error_code_of(response):
            metrics.count_error(code)
    elif facts := facts_of(request, response):
        release = served_number()
        response.headers[RELEASE] = str(release)
        seconds = time.perf_counter() - began
        metrics.count_turn(
            facts.service, facts.language, seconds, plan=facts.plan, state=facts.state
        )
        if 0 < settings.CAIR_SLOW_MS <= seconds * 1000:
            _tell_slow(request, response, facts, seconds)
    if settings.CAIR_ACCESS_LOG:
        _tell_access(request, response, time.perf_counter() - began)


def _tell_slow(request: HttpRequest, response: HttpResponse, facts: Facts, seconds: float) -> None:
    metrics.count_slow()
    try:
        _slow_rate.take("slow", settings.CAIR_SLOW_A_MINUTE)
    except TooOftenError:
        return
    laps = _LAP.findall(response.headers.get(timing.HEADER, ""))
    fields = {
        "ms": round(seconds * 1000, 3),
        **{f"{name}_ms": float(value) for name, value in laps},
        "service": facts.service,
        "language": facts.language,
        "plan": facts.plan,
        "release": served_number(),
        "bytes_in": _length(request),
        "bytes_out": len(response.content),
        "state_characters": facts.state,
    }
    slow.warning("A slow turn", extra={FIELDS: fields})


def _length(request: HttpRequest) -> int:
    length = request.META.get("CONTENT_LENGTH") or "0"
    return int(length) if length.isdecimal() else 0


def _tell_access(request: HttpRequest, response: HttpResponse, seconds: float) -> None:
    """Log a request by its route: an address, its query and its values may hold a name."""
    fields = {
        "method": request.method if request.method in _METHODS else "?",
        "route": route_of(request),
        "status": response.status_code,
        "ms": round(seconds * 1000, 3),
    }
    access.info("Answered", extra={FIELDS: fields})


_METHODS = frozenset(("GET", "HEAD", "POST", "PUT", "PATCH", "DELETE", "OPTIONS"))
