"""Pages for people: the web chat and the API's documentation."""

from collections.abc import Callable
from functools import wraps

from django.http import HttpRequest, HttpResponse, HttpResponseBase, JsonResponse
from django.shortcuts import render
from django.views.decorators.csrf import csrf_exempt
from drf_spectacular.views import SpectacularAPIView, SpectacularRedocView

from cair_site import chat_pass
from cair_site.errors import ApiError, error_json
from cair_site.hub import options_json
from dialogue.publishing import NothingPublishedError


def chat(request: HttpRequest) -> HttpResponse:
    """Show the web chat; the talk itself stays in the browser."""
    try:
        options = options_json()
    except NothingPublishedError:
        return render(request, "not_published.html", status=503)
    response = render(request, "chat.html", options)
    if chat_pass.wanted():
        chat_pass.give(response)
    return response


#: ReDoc styles its page inline and runs a worker: the policy of this page allows just that.
DOCS_POLICY = (
    "default-src 'self'; style-src 'self' 'unsafe-inline'; script-src 'self'; "
    "img-src 'self' data:; worker-src 'self' blob:; font-src 'self'; object-src 'none'; "
    "frame-ancestors 'none'"
)
Page = Callable[[HttpRequest], HttpResponseBase]


def only_read(page: Page) -> Page:
    """Return the page with the API's own answer to methods that would change something."""

    @csrf_exempt
    @wraps(page)
    def answer(request: HttpRequest) -> HttpResponseBase:
        if request.method in {"GET", "HEAD", "OPTIONS"}:
            return page(request)
        return JsonResponse(error_json(ApiError("method.not_allowed")), status=405)

    return answer


schema = only_read(SpectacularAPIView.as_view())
_redoc = SpectacularRedocView.as_view(url_name="schema")


@only_read
def docs(request: HttpRequest) -> HttpResponse:
    """Show the API's documentation."""
    response = _redoc(request)
    response.headers["Content-Security-Policy"] = DOCS_POLICY
    return response
