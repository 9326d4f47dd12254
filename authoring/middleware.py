"""What requests of the admin pass besides: rows they write are recorded as their person's."""

from collections.abc import Callable

from django.http import HttpRequest, HttpResponse

from plans.recording import recorded_for

Next = Callable[[HttpRequest], HttpResponse]
ADMIN = "/admin/"


class Recording:
    """Records rows written below /admin/; other requests pass as they are."""

    def __init__(self, get_response: Next) -> None:
        self.get_response = get_response

    def __call__(self, request: HttpRequest) -> HttpResponse:
        """Answer, with the person known to the history."""
        if not request.path_info.startswith(ADMIN):
            return self.get_response(request)
        with recorded_for(request):
            return self.get_response(request)
