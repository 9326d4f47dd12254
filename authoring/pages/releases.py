"""The pages of releases: the list, one with what it changed, and the ways back."""

from typing import Any

from django.contrib import messages
from django.core.exceptions import PermissionDenied
from django.core.paginator import Paginator
from django.db import DatabaseError
from django.http import Http404, HttpRequest, HttpResponse
from django.shortcuts import redirect, render
from django.urls import NoReverseMatch, reverse
from django.utils.translation import gettext as _
from django.views.decorators.cache import never_cache
from django.views.decorators.http import require_http_methods, require_safe

from authoring.pages.comparison import compared
from authoring.pages.publish import MAY_PUBLISH, busy_words
from authoring.releases import publish_run, releases
from authoring.site_context import page_context
from dialogue.draft import draft_version
from dialogue.models import Publication
from dialogue.publishing import DraftChangedError, roll_back
from dialogue.snapshot import SnapshotError

ON_A_PAGE = 50
#: What one must be allowed to do to write the whole draft anew.
MAY_REWRITE = ("dialogue.change_topic", "dialogue.change_sentence", "plans.change_intent")


@never_cache
@require_safe
def release_list(request: HttpRequest) -> HttpResponse:
    """Show all releases, the newest first."""
    page = Paginator(releases.rows(), ON_A_PAGE).get_page(request.GET.get("page"))
    context = {
        **page_context(request),
        "title": _("Releases"),
        "page": page,
        "served": releases.now_served(),
    }
    return render(request, "authoring/releases.html", context)


@never_cache
@require_safe
def release(request: HttpRequest, number: int) -> HttpResponse:
    """Show one release: what it changed, and what can be done with it."""
    row = _row(number)
    newest = releases.newest()
    context = {
        **_about(request, row),
        **compared(request, lambda: releases.changes_of_release(row)),
        "title": _("Release %(number)s") % {"number": row.pk},
        "before": releases.before(row),
        "is_newest": newest is not None and newest.pk == row.pk,
        "served": releases.now_served() == row.pk,
        "chat": _chat(row),
        "may_publish": request.user.has_perm(MAY_PUBLISH),
        "may_rewrite": _may_rewrite(request),
        "may_export": request.user.has_perm("dialogue.export_content"),
    }
    return render(request, "authoring/release.html", context)


def _row(number: int) -> Publication:
    row = releases.rows().filter(pk=number).first()
    if row is None:
        raise Http404
    return row


def _about(request: HttpRequest, row: Publication) -> dict[str, Any]:
    return {**page_context(request), "release": row}


def _chat(row: Publication) -> str:
    """Return the address of the chat with this release, "" where there is no such page."""
    try:
        return f"{reverse('admin:chat')}?content={row.pk}"
    except NoReverseMatch:
        return ""


def _may_rewrite(request: HttpRequest) -> bool:
    return request.user.has_perms((MAY_PUBLISH, *MAY_REWRITE))


@require_safe
def files(request: HttpRequest, number: int) -> HttpResponse:
    """Send the content files of a release as one .zip."""
    row = _row(number)
    try:
        data = releases.content_files(row)
    except SnapshotError:
        return _damaged(request, row)
    response = HttpResponse(data, content_type="application/zip")
    response["Content-Disposition"] = f'attachment; filename="cair-release-{row.pk}.zip"'
    return response


def _damaged(request: HttpRequest, row: Publication) -> HttpResponse:
    words = _("Release %(number)s is damaged and cannot be read. Choose another one.")
    messages.error(request, words % {"number": row.pk})
    return redirect("admin:release", row.pk)


@never_cache
@require_http_methods(["GET", "HEAD", "POST"])
def back(request: HttpRequest, number: int) -> HttpResponse:
    """Ask, then publish an old release again as a new one."""
    row = _row(number)
    if request.method == "POST":
        return _go_back(request, row)
    newest = releases.newest()
    if newest is not None and newest.checksum == row.checksum:
        messages.info(request, _("Robots are served exactly this already."))
        return redirect("admin:release", row.pk)
    context = {
        **_about(request, row),
        **compared(request, lambda: releases.changes_between(newest, row)),
        "title": _("Go back to release %(number)s") % {"number": row.pk},
        "newest": newest,
    }
    return render(request, "authoring/release_back.html", context)


def _go_back(request: HttpRequest, row: Publication) -> HttpResponse:
    newest = releases.newest()
    if request.POST.get("newest") != str(newest.pk if newest else ""):
        messages.error(request, _("Another release came meanwhile. Look at what would change."))
        return redirect("admin:release_back", row.pk)
    if (busy := publish_run.running()) is not None:
        messages.error(request, busy_words(busy))
        return redirect("admin:release_back", row.pk)
    try:
        made = roll_back(row.pk, author=request.user.pk)
    except SnapshotError:
        return _damaged(request, row)
    words = _("Back to release %(old)s: it is served again, as release %(new)s.")
    messages.success(request, words % {"old": row.pk, "new": made.pk})
    return redirect("admin:release", made.pk)


@never_cache
@require_http_methods(["GET", "HEAD", "POST"])
def take_back(request: HttpRequest, number: int) -> HttpResponse:
    """Ask, then make the draft say what a release said."""
    if not _may_rewrite(request):
        raise PermissionDenied
    row = _row(number)
    if request.method == "POST":
        return _take_back(request, row)
    draft = draft_version()
    context = {
        **_about(request, row),
        **compared(request, lambda: releases.changes_of_taking_back(row)),
        "title": _("Make the draft say what release %(number)s said") % {"number": row.pk},
        "draft": draft,
    }
    return render(request, "authoring/release_draft.html", context)


def _take_back(request: HttpRequest, row: Publication) -> HttpResponse:
    expected = request.POST.get("draft", "")
    known = expected.isascii() and expected.isdecimal() and len(expected) < 19
    try:
        releases.take_back(row, int(expected) if known else -1)
    except SnapshotError:
        return _damaged(request, row)
    except DraftChangedError:
        words = _("The draft has changed meanwhile, so nothing was written. Look again.")
        messages.error(request, words)
        return redirect("admin:release_draft", row.pk)
    except (DatabaseError, KeyError, ValueError):
        words = _("Release %(number)s no longer fits this server, so nothing was written.")
        messages.error(request, words % {"number": row.pk})
        return redirect("admin:release", row.pk)
    words = _("The draft says what release %(number)s said. Robots say it once you publish.")
    messages.success(request, words % {"number": row.pk})
    return redirect("admin:publish")
