"""View sets whose answers tell how long they took."""

from typing import Any

from django.http import HttpRequest
from django.http.response import HttpResponseBase
from rest_framework.response import Response
from rest_framework.viewsets import ViewSet

from plans.timing import ENCODE, HEADER, header, lap, timed


class TimedViewSet(ViewSet):
    """A view set whose answers tell how long they took."""

    def dispatch(self, request: HttpRequest, *args: Any, **kwargs: Any) -> HttpResponseBase:
        """Answer, write the body at once, and say how long it took."""
        with timed() as laps:
            response = super().dispatch(request, *args, **kwargs)
            if isinstance(response, Response):
                with lap(ENCODE):
                    response.render()
        response.headers[HEADER] = header(laps)
        return response
