"""A list of changes as pages show it: fifty at a time, with the way back for who may go it."""

from dataclasses import dataclass
from typing import Any

from django.http import HttpRequest
from django.urls import NoReverseMatch, reverse

from authoring.history.history import Change, Wanted, changes, count

EACH = 50
MOST_PAGES = 100_000


@dataclass(frozen=True, slots=True)
class Shown:
    """A change with the addresses it leads to; empty where the person may not go."""

    change: Change
    back: str
    edit: str


def shown_changes(request: HttpRequest, wanted: Wanted) -> dict[str, Any]:
    """Return what templates/authoring/changes.html needs; three queries."""
    number = page_number(request)
    found = changes(wanted, (number - 1) * EACH, number * EACH)
    total = count(wanted)
    return {
        "changes": [Shown(one, _back(request, one), _edit(request, one)) for one in found],
        "total": total,
        "page_number": number,
        "before": _page(request, number - 1) if number > 1 else "",
        "after": _page(request, number + 1) if number * EACH < total else "",
    }


def page_number(request: HttpRequest) -> int:
    """Return the number of the page that is asked for, 1 for nonsense."""
    text = request.GET.get("p", "1")
    known = text.isascii() and text.isdecimal() and len(text) < 7
    return max(1, min(int(text), MOST_PAGES)) if known else 1


def _page(request: HttpRequest, number: int) -> str:
    query = request.GET.copy()
    query["p"] = str(number)
    return f"?{query.urlencode()}"


def _back(request: HttpRequest, change: Change) -> str:
    app, _point, model = change.model.partition(".")
    verb = "add" if change.kind == "-" else "change"
    if not change.can_go_back or not request.user.has_perm(f"{app}.{verb}_{model}"):
        return ""
    return reverse("admin:audit_back", args=(change.model, change.record))


def _edit(request: HttpRequest, change: Change) -> str:
    """Return the form of the row, where it has one of its own."""
    app, _point, model = change.model.partition(".")
    if change.kind == "-" or not request.user.has_perm(f"{app}.view_{model}"):
        return ""
    try:
        return reverse(f"admin:{app}_{model}_change", args=(change.row,))
    except NoReverseMatch:
        return ""
