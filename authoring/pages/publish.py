"""The page "Publish": what would change, what the checks say, and the button."""

from typing import Any

from django.contrib import messages
from django.core.exceptions import PermissionDenied
from django.http import Http404, HttpRequest, HttpResponse, JsonResponse
from django.shortcuts import redirect, render
from django.urls import NoReverseMatch, reverse
from django.utils.http import urlencode
from django.utils.translation import gettext as _
from django.utils.translation import gettext_lazy
from django.views.decorators.cache import never_cache
from django.views.decorators.http import require_http_methods, require_safe

from authoring.checks.findings import Checked, last_check
from authoring.models import PublishRun
from authoring.pages.checks import grouped
from authoring.pages.comparison import compared
from authoring.releases import publish_run, releases
from authoring.site_context import page_context
from dialogue.draft import draft_version
from dialogue.publishing import STEPS

MAY_PUBLISH = "dialogue.publish_draft"
LONGEST_NOTE = 300
MOST_SEEN = 1000
#: So many errors stand here; the page of the checks has all.
MOST_ERRORS = 20

STEP_WORDS = {
    "reading": gettext_lazy("Reading the draft"),
    "checking": gettext_lazy("Checking it"),
    "building": gettext_lazy("Building the dialogue tree"),
    "conversations": gettext_lazy("Trying the saved conversations"),
    "storing": gettext_lazy("Storing the release"),
}
END_WORDS = {
    publish_run.DONE: gettext_lazy("Published: release %(number)s is served to robots now."),
    publish_run.SAME: gettext_lazy(
        "Nothing was new: release %(number)s says exactly this already."
    ),
    publish_run.REFUSED: gettext_lazy(
        "Not published: the draft has errors. Mend them and publish again."
    ),
    publish_run.LOOK: gettext_lazy(
        "Not published yet: saved conversations go another way now. Look at them, tick the box "
        "and publish."
    ),
    publish_run.CHANGED: gettext_lazy(
        "Not published: the draft has changed meanwhile. Look at the changes and publish again."
    ),
    publish_run.FAILED: gettext_lazy(
        "Not published: something unforeseen went wrong, and nothing has changed. Try again; if "
        "it stays so, ask your administrator to look into the log."
    ),
    publish_run.LOST: gettext_lazy("Not published: the server stopped in between. Publish again."),
}
#: What the page shows of changes that its script fetches.
COMPARED_LATER: dict[str, Any] = {"damaged": False, "groups": [], "headlines": [], "total": 0}
#: Ends after which the page explains what to do.
_TO_EXPLAIN = frozenset(END_WORDS) - {publish_run.DONE, publish_run.SAME}


@never_cache
@require_http_methods(["GET", "HEAD", "POST"])
def publish(request: HttpRequest) -> HttpResponse:
    """Show what publishing would change; a POST publishes."""
    if request.method == "POST":
        return _publish(request)
    return _page(request)


def _page(
    request: HttpRequest, trouble: str = "", note: str = "", status: int = 200
) -> HttpResponse:
    draft, newest, busy = draft_version(), releases.newest(), publish_run.running()
    last = publish_run.last_run()
    stopped = last if last and last.draft == draft and last.step in _TO_EXPLAIN else None
    checked = last_check()
    later = not request.GET.get("whole") and releases.takes_long(newest)
    changes = COMPARED_LATER
    if not later:
        changes = compared(request, lambda: releases.changes_of_draft(newest))
    known = newest is not None and not later and not changes["damaged"]
    nothing_new = known and not changes["total"]
    context = {
        **page_context(request),
        **changes,
        "title": _("Publish"),
        "nothing_new": nothing_new,
        "later": f"?{urlencode({**request.GET.dict(), 'whole': '1'})}" if later else "",
        "draft": draft,
        "newest": newest,
        "busy": busy,
        "busy_url": reverse("admin:publish_status", args=[busy.pk]) if busy else "",
        "stopped": stopped,
        "stopped_words": END_WORDS[stopped.step] if stopped else "",
        "failing": _failing(stopped),
        "checked": checked,
        "current": checked is not None and checked.draft == draft,
        "blocking": _blocking(checked),
        "steps": [(name, STEP_WORDS[name]) for name in STEPS],
        "trouble": trouble,
        "note": note or (stopped.note if stopped else ""),
        "may_publish": request.user.has_perm(MAY_PUBLISH),
        "longest_note": LONGEST_NOTE,
    }
    return render(request, "authoring/publish.html", context, status=status)


def _failing(stopped: PublishRun | None) -> list[tuple[int, str, str, str]]:
    """Return number, title, reason and address of each conversation that must be looked at."""
    problems = stopped.problems if stopped and stopped.step == publish_run.LOOK else []
    return [(*one, _conversation(one[0])) for one in problems]


def _conversation(number: int) -> str:
    for name in ("conversation", "authoring_conversation_change"):
        try:
            return reverse(f"admin:{name}", args=[number])
        except NoReverseMatch:
            continue
    return ""


def _blocking(checked: Checked | None) -> Any:
    return grouped([one for one in checked.found if one.blocks], MOST_ERRORS) if checked else []


def _publish(request: HttpRequest) -> HttpResponse:
    if not request.user.has_perm(MAY_PUBLISH):
        raise PermissionDenied
    note = " ".join(request.POST.get("note", "").replace("\0", "").split())
    draft = request.POST.get("draft", "")
    if len(note) > LONGEST_NOTE:
        words = _("The note is too long: write at most %(n)s letters.") % {"n": LONGEST_NOTE}
        return _refuse(request, words, note[:LONGEST_NOTE])
    if draft != str(draft_version()):
        return _refuse(request, str(END_WORDS[publish_run.CHANGED]), note, 409)
    try:
        run = publish_run.begin(request.user.pk, note, int(draft))
    except publish_run.BusyError as error:
        return _refuse(request, busy_words(error.run), note, 409)
    if request.headers.get("Accept", "").startswith("application/json"):
        publish_run.start(run, _seen(request))
        return JsonResponse({"status": reverse("admin:publish_status", args=[run.pk])}, status=202)
    publish_run.carry_out(run, _seen(request))
    return redirect("admin:publish_result", run.pk)


def _seen(request: HttpRequest) -> frozenset[int]:
    """Return the conversations whose new way the person has seen."""
    if not request.POST.get("seen"):
        return frozenset()
    numbers = request.POST.getlist("conversation")[:MOST_SEEN]
    return frozenset(int(one) for one in numbers if one.isascii() and one.isdecimal())


def busy_words(run: PublishRun | None) -> str:
    """Return who is publishing."""
    who = _person(run)
    if not who:
        return _("Somebody else is publishing right now. Wait a moment, then look again.")
    return _("%(who)s is publishing right now. Wait a moment, then look again.") % {"who": who}


def _person(run: PublishRun | None) -> str:
    user = run.author if run else None
    return (user.get_full_name() or user.get_username()) if user else ""


def _refuse(request: HttpRequest, words: str, note: str, status: int = 400) -> HttpResponse:
    if request.headers.get("Accept", "").startswith("application/json"):
        return JsonResponse({"trouble": words}, status=status)
    return _page(request, words, note, status)


def _run(number: int) -> PublishRun:
    run = PublishRun.objects.select_related("author").filter(pk=number).first()
    if run is None:
        raise Http404
    return run


@never_cache
@require_safe
def status(request: HttpRequest, number: int) -> HttpResponse:
    """Tell how a run goes on, as JSON: the step, its place, and where to go when it has ended."""
    run = _run(number)
    going_on = run.step in STEPS and publish_run.running() == run
    answer: dict[str, object] = {"running": going_on, "step": run.step}
    if going_on:
        answer |= {"place": STEPS.index(run.step), "words": str(STEP_WORDS[run.step])}
    else:
        answer["url"] = reverse("admin:publish_result", args=[run.pk])
    return JsonResponse(answer)


@never_cache
@require_safe
def result(request: HttpRequest, number: int) -> HttpResponse:
    """Say how a run ended, on the page of the release or on the one to publish."""
    run = _run(number)
    if run.step in (publish_run.DONE, publish_run.SAME) and run.publication_id:
        told = END_WORDS[run.step] % {"number": run.publication_id}
        messages.success(request, told)
        return redirect("admin:release", run.publication_id)
    return redirect("admin:publish")
