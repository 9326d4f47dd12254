"""The least a Django REST framework view can do: give a body back, with the site's settings."""

from django.urls import path
from rest_framework.request import Request
from rest_framework.response import Response
from rest_framework.viewsets import ViewSet

from cair_site import urls

PATH = "/api/v1/echo/"


class EchoViewSet(ViewSet):
    """Answers what it was asked."""

    def create(self, request: Request) -> Response:
        """Return the body."""
        return Response(request.data)


urlpatterns = [*urls.urlpatterns, path(PATH[1:], EchoViewSet.as_view({"post": "create"}))]
handler400, handler404, handler500 = urls.handler400, urls.handler404, urls.handler500
