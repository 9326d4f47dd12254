"""The page "History": all changes of the draft, found by person, day, kind and topic."""

from datetime import UTC, datetime, timedelta
from typing import Any

from django.contrib import messages
from django.contrib.auth import get_user_model
from django.core.exceptions import ObjectDoesNotExist, PermissionDenied
from django.http import Http404, HttpRequest, HttpResponse
from django.shortcuts import redirect, render
from django.urls import NoReverseMatch, reverse
from django.utils.translation import gettext as _
from django.views.decorators.http import require_http_methods, require_safe

from authoring.history.history import Wanted, models_with_history
from authoring.history.history_back import CannotGoBackError, find, go_back, permission, preview
from authoring.history.history_words import KINDS
from authoring.pages.changes import shown_changes
from authoring.site_context import page_context

LONGEST_SOUGHT = 140


@require_safe
def audit(request: HttpRequest) -> HttpResponse:
    """Show the changes that are asked for, the latest first."""
    asked = {name: request.GET.get(name, "")[:LONGEST_SOUGHT] for name in FILTERS}
    wanted, trouble = _wanted(asked)
    kinds = [(label, KINDS[label]) for label in models_with_history()]
    context = {
        **page_context(request),
        **shown_changes(request, wanted),
        "title": _("History"),
        "asked": asked,
        "trouble": trouble,
        "people": _people(),
        "kinds": kinds,
    }
    return render(request, "authoring/audit.html", context)


FILTERS = ("person", "day", "model", "topic")


def _people() -> list[tuple[str, str]]:
    users = get_user_model()._default_manager.filter(is_staff=True).order_by("username")
    return [(str(user.pk), user.get_full_name() or user.get_username()) for user in users[:500]]


def _wanted(asked: dict[str, str]) -> tuple[Wanted, str]:
    """Return what is asked for, and what of it could not be understood."""
    person, model = asked["person"], asked["model"]
    known = person.isascii() and person.isdecimal() and len(person) < 10
    since, trouble = _day(asked["day"])
    return Wanted(
        person=int(person) if known else None,
        since=since,
        until=since + timedelta(days=1) if since else None,
        model=model if model in models_with_history() else "",
        topic=asked["topic"].strip().replace("\0", ""),
    ), trouble


def _day(text: str) -> tuple[datetime | None, str]:
    if not text:
        return None, ""
    try:
        day = datetime.strptime(text, "%Y-%m-%d").replace(tzinfo=UTC)
    except ValueError:
        return None, _("The day could not be read. Write it like 2026-01-31.")
    return (day, "") if day.year < 9999 else (None, _("That day is too far away."))


@require_http_methods(["GET", "HEAD", "POST"])
def back(request: HttpRequest, model: str, record: int) -> HttpResponse:
    """Show what going back before a change would do; do it on POST."""
    try:
        kind, row = find(model, record)
    except ObjectDoesNotExist as error:
        raise Http404(_("There is no such change.")) from error
    if not request.user.has_perm(permission(kind, row)):
        raise PermissionDenied
    try:
        if request.method == "POST":
            return _went_back(request, kind, row)
        shown, trouble = preview(kind, row), ""
    except CannotGoBackError as error:
        shown, trouble = None, str(error)
    context = {
        **page_context(request),
        "title": _("Go back"),
        "preview": shown,
        "trouble": trouble,
        "from_where": _from_where(request),
    }
    return render(request, "authoring/back.html", context, status=409 if trouble else 200)


def _went_back(request: HttpRequest, kind: Any, row: Any) -> HttpResponse:
    done = go_back(kind, row)
    words = (
        _("%(row)s is back.") if row.history_type == "-" else _("%(row)s says again what it did.")
    )
    messages.success(request, words % {"row": done})
    return redirect(_address(done) or _from_where(request))


def _address(row: Any) -> str:
    """Return the history of a row that has a form of its own, else of what it belongs to."""
    for each in (row, getattr(row, "topic", None), getattr(row, "frame", None), _intent(row)):
        if each is not None:
            name = f"{each._meta.app_label}_{each._meta.model_name}_history"
            try:
                return reverse(f"admin:{name}", args=(each.pk,))
            except NoReverseMatch:
                continue
    return ""


def _intent(row: Any) -> Any:
    return getattr(row, "intent", None)


def _from_where(request: HttpRequest) -> str:
    """Return a page that the person may open: the audit page is not for all."""
    name = "audit" if request.user.has_perm("dialogue.publish_draft") else "index"
    return reverse(f"admin:{name}")
