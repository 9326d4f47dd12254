"""One import of an ontology: how it goes on, what it would change, bringing it in or not."""

from collections.abc import Sequence
from typing import Any, NamedTuple

from django.contrib import messages
from django.core.exceptions import PermissionDenied
from django.http import Http404, HttpRequest, HttpResponse, JsonResponse
from django.shortcuts import redirect, render
from django.utils.http import urlencode
from django.utils.translation import gettext as _
from django.utils.translation import gettext_lazy
from django.views.decorators.cache import never_cache
from django.views.decorators.http import require_http_methods, require_safe

from authoring.ontology import comparing, imports, words
from authoring.ontology.imports import Run
from authoring.pages.comparison import compared
from authoring.pages.ontology import EXPORT, may_import, ontology, ontology_file, upload
from authoring.pages.page import Page
from authoring.pages.publish import COMPARED_LATER, MAY_PUBLISH
from authoring.site_context import page_context
from ontology_io.import_runs import NotReadyError

#: So many problems, names and renamed rows stand on the page; the rest is counted.
MOST_SHOWN = 100
#: Above this share of the topics, removing them wants a tick of its own.
MANY = 0.1


def _run(number: int) -> Run:
    run = imports.run(number)
    if run is None:
        raise Http404
    return run


@never_cache
@require_safe
def ontology_import(request: HttpRequest, number: int) -> HttpResponse:
    """Show an import: its steps while it goes on, then what it would change or how it ended."""
    return _page(request, _run(number))


def _page(request: HttpRequest, run: Run, trouble: str = "", status: int = 200) -> HttpResponse:
    context: dict[str, Any] = {
        **page_context(request),
        "title": _("Bring in an ontology"),
        "run": run,
        "mood": words.mood(run),
        "trouble": trouble,
        "may_import": may_import(request),
        "end_words": words.END_WORDS.get(run.step, ""),
    }
    if run.going_on:
        context["steps"] = words.steps(run)
    else:
        context |= _found(run) | (_changes(request, run) if run.ready else {})
    return render(request, "authoring/ontology_import.html", context, status=status)


def _found(run: Run) -> dict[str, Any]:
    """Return what the page shows of the result, bounded."""
    result, problems = run.result, list(run.problems())
    findings = list(run.findings())
    errors = [one for one in problems if one.error]
    notes = [one for one in problems if not one.error]
    total = result.get("problems_total", len(problems))
    return {
        "errors": _part(errors, len(errors) if notes else total),
        "notes": _part(notes, total - len(errors)),
        "to_mend": _part(findings, result.get("findings_total", len(findings))),
        "renamed": _part(result.get("renamed", []), len(result.get("renamed", []))),
        "unknown": sorted(result.get("unknown", {}).items())[:MOST_SHOWN],
        "persons": result.get("persons", 0),
        "used": run.ready or run.applied,
    }


class Part(NamedTuple):
    """What is shown of a list, and how many there are in all."""

    shown: Sequence[Any]
    total: int

    @property
    def hidden(self) -> int:
        """Return how many are counted only."""
        return self.total - len(self.shown)


def _part(found: Sequence[Any], total: int) -> Part:
    return Part(found[:MOST_SHOWN], total)


def _changes(request: HttpRequest, run: Run) -> dict[str, Any]:
    """Return what would change, in numbers and in words; a large draft is compared later."""
    told: dict[str, Any] = {"sums": words.sums(run), "stale": run.stale}
    if run.stale:
        return told
    removed = _part(run.names("topics", "removed"), run.removed)
    told |= {"removed": removed, "topics": imports.topics(), "many_removed": _many(run)}
    if not request.GET.get("whole") and comparing.takes_long(run):
        later = urlencode({**request.GET.dict(), "whole": "1"})
        return {**told, **COMPARED_LATER, "later": f"?{later}"}
    try:
        return {**told, **compared(request, lambda: comparing.changes(run))}
    except NotReadyError:  # Decided in another window just now.
        return {**told, **COMPARED_LATER}


def _many(run: Run) -> bool:
    return run.removed > imports.topics() * MANY


@never_cache
@require_safe
def status(request: HttpRequest, number: int) -> HttpResponse:
    """Tell how an import goes on, as JSON: the step, its place among the steps, its words."""
    run = _run(number)
    answer: dict[str, object] = {"running": run.going_on, "step": run.step}
    if run.going_on:
        states = [step.state for step in words.steps(run)]
        answer["place"] = states.index("now")
        answer["words"] = str(words.steps(run)[states.index("now")].words)
    return JsonResponse(answer)


@never_cache
@require_http_methods(["GET", "HEAD", "POST"])
def bring_in(request: HttpRequest, number: int) -> HttpResponse:
    """Write what was shown into the draft."""
    run = _asked(request, number)
    if request.method != "POST" or not run.ready:
        return redirect("admin:ontology_import", number)
    if _many(run) and not request.POST.get("removing"):
        trouble = _("Tick the box first: more than a tenth of the topics would be removed.")
        return _page(request, run, trouble, 400)
    try:
        imports.apply(number)
    except imports.BusyError as error:
        return _page(request, run, words.busy(error.run), 409)
    return redirect("admin:ontology_import", number)


@never_cache
@require_http_methods(["GET", "HEAD", "POST"])
def discard(request: HttpRequest, number: int) -> HttpResponse:
    """Give an import up; nothing was written."""
    run = _asked(request, number)
    if request.method == "POST" and imports.discard(run.number):
        messages.success(request, _("Discarded: nothing was written."))
        return redirect("admin:ontology")
    return redirect("admin:ontology_import", number)


def _asked(request: HttpRequest, number: int) -> Run:
    if not may_import(request):
        raise PermissionDenied
    return _run(number)


_ONE = "ontology/import/<int:number>/"
ONTOLOGY_PAGES = (
    Page("ontology", "ontology/", ontology, EXPORT, gettext_lazy("Ontology"), 46),
    Page("ontology_file", "ontology/file/", ontology_file, EXPORT),
    Page("ontology_upload", "ontology/import/", upload, MAY_PUBLISH),
    Page("ontology_import", _ONE, ontology_import, EXPORT),
    Page("ontology_status", f"{_ONE}status/", status, EXPORT),
    Page("ontology_apply", f"{_ONE}apply/", bring_in, MAY_PUBLISH),
    Page("ontology_discard", f"{_ONE}discard/", discard, MAY_PUBLISH),
)
