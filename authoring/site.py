"""The admin site: the stock one with our pages and their menu."""

from collections.abc import Callable
from functools import partial, update_wrapper
from typing import Any

from django.contrib.admin import AdminSite
from django.core.exceptions import PermissionDenied
from django.http import HttpRequest, HttpResponseBase
from django.urls import URLPattern, URLResolver, path, reverse
from django.utils.translation import gettext_lazy as _

from authoring.login_throttle import LoginForm
from authoring.pages.page import Page, may_see
from authoring.pages.table import PAGES


class CairAdminSite(AdminSite):
    """The admin in which experts write, test and publish."""

    login_form = LoginForm
    site_header = site_title = "CAIR"
    index_title = _("What the robot says")

    def get_urls(self) -> list[URLResolver | URLPattern]:
        """Return the addresses of our pages and of the forms."""
        ours: list[URLResolver | URLPattern] = [
            path(page.path, self.admin_view(_guarded(page)), name=page.name) for page in PAGES
        ]
        return [*ours, *super().get_urls()]

    def each_context(self, request: HttpRequest) -> dict[str, Any]:
        """Return what every page is given: the menu too."""
        return {**super().each_context(request), "menu": menu(request)}


def _guarded(page: Page) -> Callable[..., HttpResponseBase]:
    return update_wrapper(partial(_open, page), page.view)


def _open(page: Page, request: HttpRequest, *args: object, **kwargs: object) -> HttpResponseBase:
    if not may_see(page, request):
        raise PermissionDenied
    return page.view(request, *args, **kwargs)


def menu(request: HttpRequest) -> list[dict[str, object]]:
    """Return the pages that the person may open, in the order of the menu."""
    if not getattr(request, "user", None) or not request.user.is_active:
        return []
    shown = sorted((page for page in PAGES if page.title), key=lambda page: page.order)
    return [
        {"title": page.title, "url": address, "here": request.path == address}
        for page in shown
        if may_see(page, request) and (address := reverse(f"admin:{page.name}"))
    ]
