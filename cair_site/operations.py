"""What load balancers and operators ask: alive, ready, the numbers.

Answered before anything else looks at the request: a probe knows neither our name nor https.
"""

from collections.abc import Callable
from hmac import compare_digest

from django.conf import settings
from django.http import HttpRequest, HttpResponse, JsonResponse

from authoring.addresses import is_own_machine
from cair_site import metrics as numbers
from cair_site.errors import ApiError, error_json
from dialogue.publishing import NothingPublishedError, current

Next = Callable[[HttpRequest], HttpResponse]


def livez(request: HttpRequest) -> HttpResponse:
    """Say that the process answers; the database is not asked."""
    return JsonResponse({"alive": True})


def readyz(request: HttpRequest) -> HttpResponse:
    """Say whether a publication is loaded; a lost database does not make a worker unready.

    Only a worker that has never loaded one looks into the database.
    """
    try:
        number = current().number
    except NothingPublishedError:
        return JsonResponse({"ready": False, "publication": None}, status=503)
    return JsonResponse({"ready": True, "publication": number})


def metrics(request: HttpRequest) -> HttpResponse:
    """Give Prometheus our numbers; to whoever may not read them there is nothing here."""
    if not _may_read(request):
        return JsonResponse(error_json(ApiError("not_found")), status=404)
    response = HttpResponse(numbers.text(), content_type=numbers.CONTENT_TYPE)
    response.headers["Cache-Control"] = "no-store"
    return response


def _may_read(request: HttpRequest) -> bool:
    """Say whether a call has CAIR_METRICS_TOKEN; without such a setting: is of this machine."""
    token = settings.CAIR_METRICS_TOKEN
    if not token:
        return is_own_machine(request)
    scheme, _blank, given = request.META.get("HTTP_AUTHORIZATION", "").partition(" ")
    same = compare_digest(given.strip().encode("utf-8", "surrogatepass"), token.encode())
    return scheme.lower() == "bearer" and same


PAGES = {"/livez": livez, "/readyz": readyz, "/metrics": metrics}


class Operations:
    """Answers these addresses itself; other requests go on."""

    def __init__(self, get_response: Next) -> None:
        self.get_response = get_response

    def __call__(self, request: HttpRequest) -> HttpResponse:
        """Answer, or let the next middleware do it."""
        page = PAGES.get(request.path_info)
        return page(request) if page else self.get_response(request)
