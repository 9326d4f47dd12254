"""The way of an API call: straight to its view, past what only pages need.

Sessions, languages, cookies, messages and static files cost more than a turn of talk.
"""

import re
from collections.abc import Callable
from functools import lru_cache
from typing import cast

from django.conf import settings
from django.core.handlers.exception import convert_exception_to_response
from django.http import HttpRequest, HttpResponse
from django.middleware.security import SecurityMiddleware
from django.template.response import SimpleTemplateResponse
from django.urls import ResolverMatch, resolve

Next = Callable[[HttpRequest], HttpResponse]

# The ontology is no talk: its imports write to the database as pages do.
_API = re.compile(r"/api/v1/(?!ontology(?:/|$))|/(?:[a-z]{2}/)?CAIR_hub")
_MOST_PATHS = 256


class ApiPath:
    """Answers API calls itself, other requests go on through the rest of the middlewares."""

    def __init__(self, get_response: Next) -> None:
        self.pages = get_response
        self.api = SecurityMiddleware(convert_exception_to_response(_answer))

    def __call__(self, request: HttpRequest) -> HttpResponse:
        """Answer on the way that the address asks for."""
        if _API.match(request.path_info):
            return cast(HttpResponse, self.api(request))
        return self.pages(request)


def _answer(request: HttpRequest) -> HttpResponse:
    """Call the view. Raises Http404 and DisallowedHost, which become our errors."""
    request.get_host()
    match = request.resolver_match = _match(settings.ROOT_URLCONF, request.path_info)
    response: HttpResponse = match.func(request, *match.args, **match.kwargs)
    if isinstance(response, SimpleTemplateResponse):
        response.render()
    if not response.streaming and not response.has_header("Content-Length"):
        response.headers["Content-Length"] = str(len(response.content))
    return response


@lru_cache(_MOST_PATHS)
def _match(urlconf: str, path: str) -> ResolverMatch:
    return resolve(path, urlconf)
