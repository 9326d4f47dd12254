"""The page "Checks": what is wrong in the draft or worth a look, and where to mend it."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from datetime import timedelta
from typing import Any

from django.contrib import messages
from django.http import HttpRequest, HttpResponse
from django.shortcuts import redirect, render
from django.urls import NoReverseMatch, reverse
from django.utils import timezone
from django.utils.translation import gettext as _
from django.utils.translation import ngettext
from django.views.decorators.http import require_http_methods

from authoring.checks.findings import Checked, Found, check_now, counts_by, last_check
from authoring.checks.findings_words import hint_of, kind_name, plain
from authoring.language_names import language_name
from authoring.site_context import page_context
from dialogue.draft import draft_version

#: So many findings stand on one page; the filters reach the others.
MOST_SHOWN = 300
#: The same draft is not checked twice within so short a time.
SOON = timedelta(seconds=30)
FILTERS = ("kind", "branch", "language")
NO_BRANCH, NO_LANGUAGE = "-", "-"


@dataclass(frozen=True, slots=True)
class Shown:
    """One finding as the page shows it."""

    where: str
    url: str
    language: str
    message: str
    hint: str


@dataclass(frozen=True, slots=True)
class Group:
    """The findings of one kind in one branch ("" for what stands in no branch)."""

    kind: str
    branch: str
    count: int
    shown: tuple[Shown, ...]


@require_http_methods(["GET", "HEAD", "POST"])
def checks(request: HttpRequest) -> HttpResponse:
    """Show the last check; a POST checks again."""
    if request.method == "POST":
        return _check_again(request)
    checked = last_check()
    asked = {name: request.GET.get(name, "")[:140] for name in FILTERS}
    found = _wanted(checked.found if checked else (), asked)
    blocking = [one for one in found if one.blocks]
    context = {
        **page_context(request),
        "title": _("Checks"),
        "checked": checked,
        "since": max(0, draft_version() - checked.draft) if checked else 0,
        "asked": asked,
        "choices": _choices(checked.found if checked else (), asked),
        "blocking": grouped(blocking, MOST_SHOWN),
        "looking": grouped(
            [one for one in found if not one.blocks], max(0, MOST_SHOWN - len(blocking))
        ),
        "hidden": max(0, len(found) - MOST_SHOWN),
        "most": MOST_SHOWN,
        "number": len(found),
    }
    return render(request, "authoring/checks.html", context)


def _check_again(request: HttpRequest) -> HttpResponse:
    checked = last_check()
    if checked is None or not _fresh(checked):
        checked = check_now()
    if checked.total:
        errors = ngettext("%(n)s error", "%(n)s errors", checked.errors) % {"n": checked.errors}
        number = checked.warnings
        warnings = ngettext("%(n)s warning", "%(n)s warnings", number) % {"n": number}
        told = _("Checked: %(errors)s, %(warnings)s.") % {"errors": errors, "warnings": warnings}
        messages.warning(request, told)
    else:
        messages.success(request, _("Checked: nothing was found."))
    return redirect("admin:checks")


def _fresh(checked: Checked) -> bool:
    return checked.draft == draft_version() and timezone.now() - checked.when < SOON


def _wanted(found: Iterable[Found], asked: Mapping[str, str]) -> list[Found]:
    kind, branch, language = (asked[name] for name in FILTERS)
    return [
        one
        for one in found
        if kind in ("", one.code)
        and branch in ("", one.branch or NO_BRANCH)
        and language in ("", one.language or NO_LANGUAGE)
    ]


def _choices(found: tuple[Found, ...], asked: Mapping[str, str]) -> list[dict[str, Any]]:
    """Return the filters: each with its choices (value, words, number)."""
    kinds, branches = counts_by(found, "code"), counts_by(found, "branch")
    languages = counts_by(found, "language")
    return [
        {
            "name": "kind",
            "title": _("Kind"),
            "asked": asked["kind"],
            "choices": [(code, kind_name(code), number) for code, number in kinds.items()],
        },
        {
            "name": "branch",
            "title": _("Branch"),
            "asked": asked["branch"],
            "choices": [
                (key or NO_BRANCH, key or _("in no branch"), number)
                for key, number in sorted(branches.items())
            ],
        },
        {
            "name": "language",
            "title": _("Language"),
            "asked": asked["language"],
            "choices": [
                (code or NO_LANGUAGE, language_name(code) or _("no language"), number)
                for code, number in sorted(languages.items())
            ],
        },
    ]


def grouped(found: list[Found], most: int) -> list[Group]:
    """Return findings by kind and branch, at most so many of them."""
    counts: dict[tuple[str, str], int] = {}
    for one in found:
        counts[one.code, one.branch] = counts.get((one.code, one.branch), 0) + 1
    shown: dict[tuple[str, str], list[Shown]] = {}
    for one in found[:most]:
        shown.setdefault((one.code, one.branch), []).append(show(one))
    return [
        Group(kind_name(code), branch, counts[code, branch], tuple(these))
        for (code, branch), these in shown.items()
    ]


def show(one: Found) -> Shown:
    """Return a finding in words, with the address of its row."""
    return Shown(
        where=one.where,
        url=_url(one),
        language=language_name(one.language),
        message=plain(one.code, one.message),
        hint=hint_of(one.code, one.hint),
    )


def _url(one: Found) -> str:
    if not one.number:
        return ""
    try:
        return reverse(f"admin:{one.row.replace('.', '_')}_change", args=[one.number])
    except NoReverseMatch:
        return ""
