"""One page of the admin besides the forms: a row of the table in authoring.pages.table."""

from collections.abc import Callable
from typing import NamedTuple

from django.http import HttpRequest, HttpResponseBase
from django.utils.functional import Promise

View = Callable[..., HttpResponseBase]


class Page(NamedTuple):
    """A page: its name for `reverse("admin:<name>")`, its path below admin/, who may see it.

    `permission` is a Django permission ("dialogue.view_topic"). A page with a `title` stands in
    the menu; one without is reached from another page. `order` sorts the menu.
    """

    name: str
    path: str
    view: View
    permission: str
    title: str | Promise = ""
    order: int = 0


def may_see(page: Page, request: HttpRequest) -> bool:
    """Say whether the person who is logged in may open a page."""
    return request.user.has_perm(page.permission)
