"""Pages for people: the web chat and the API's documentation."""

from django.http import HttpRequest, HttpResponse
from django.shortcuts import render
from drf_spectacular.views import SpectacularRedocView

from cair_site.hub import options_json
from dialogue.publishing import NothingPublishedError


def chat(request: HttpRequest) -> HttpResponse:
    """Show the web chat; the talk itself stays in the browser."""
    try:
        options = options_json()
    except NothingPublishedError:
        return render(request, "not_published.html", status=503)
    return render(request, "chat.html", options)


#: ReDoc draws its page with inline styles and a worker: the policy of this page allows just that.
DOCS_POLICY = (
    "default-src 'self'; style-src 'self' 'unsafe-inline'; script-src 'self' 'unsafe-inline'; "
    "img-src 'self' data:; worker-src 'self' blob:; font-src 'self'; object-src 'none'; "
    "frame-ancestors 'none'"
)
_redoc = SpectacularRedocView.as_view(url_name="schema")


def docs(request: HttpRequest) -> HttpResponse:
    """Show the API's documentation."""
    response = _redoc(request)
    response.headers["Content-Security-Policy"] = DOCS_POLICY
    return response
