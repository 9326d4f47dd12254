"""The page "Conversations": the list, each one replayed, before and now side by side."""

from collections.abc import Mapping
from dataclasses import dataclass

from django.contrib import messages
from django.core.exceptions import PermissionDenied
from django.http import Http404, HttpRequest, HttpResponse
from django.shortcuts import redirect, render
from django.urls import reverse
from django.utils.translation import gettext as _
from django.utils.translation import ngettext
from django.views.decorators.http import require_http_methods

from authoring.chat.chat_contents import DRAFT, PUBLISHED, Chosen, UnknownContentError, content_of
from authoring.chat.chat_troubles import findings_json
from authoring.chat.conversation_turns import ANY, EXACT, PLAN, TOPIC, WORDS, Turn
from authoring.chat.conversations import (
    MOST_CONVERSATIONS,
    ChangedMeanwhileError,
    Result,
    TurnResult,
    accept,
    run,
    run_all,
)
from authoring.models.conversation import Conversation
from authoring.site_context import page_context
from authoring.word_marks import Piece, word_marks
from dialogue.publishing import NothingPublishedError, NotPublishableError
from dialogue.snapshot import SnapshotError


@dataclass(frozen=True, slots=True)
class Shown:
    """A turn as the page shows it: both texts with their marks, what must hold in words."""

    place: int
    turn: TurnResult
    before: str
    now: str
    marks: tuple[Piece, ...]
    must: str

    @property
    def changed(self) -> bool:
        """Say whether it says or does something else than when it was saved."""
        return self.before != self.now or self.turn.before.plan != self.turn.now.plan


@require_http_methods(["GET", "HEAD", "POST"])
def conversations(request: HttpRequest) -> HttpResponse:
    """Show all conversations; on POST run them all, or the one that is named."""
    if request.method != "POST":
        return _list(request)
    if not request.user.has_perm("authoring.change_conversation"):
        raise PermissionDenied
    name = request.POST.get("content", DRAFT)
    chosen, trouble = _content(name)
    if chosen is None:
        return _list(request, status=409, **trouble)
    one = request.POST.get("one", "")
    only = [int(one)] if one.isascii() and one.isdecimal() and len(one) < 10 else None
    _tell(request, run_all(chosen.content, write=True, only=only))
    return redirect("admin:conversations")


def _list(request: HttpRequest, status: int = 200, **trouble: object) -> HttpResponse:
    rows = Conversation.objects.defer("turns", "note").select_related("created_by")
    context = {
        **page_context(request),
        **trouble,
        "title": _("Conversations"),
        "rows": rows[:MOST_CONVERSATIONS],
        "may_run": request.user.has_perm("authoring.change_conversation"),
        "may_delete": request.user.has_perm("authoring.delete_conversation"),
    }
    return render(request, "authoring/conversations.html", context, status=status)


def _tell(request: HttpRequest, results: tuple[Result, ...]) -> None:
    failed = [one.title for one in results if not one.passed]
    good = len(results) - len(failed)
    if good:
        words = ngettext("%(n)s conversation holds.", "%(n)s conversations hold.", good)
        messages.success(request, words % {"n": good})
    if failed:
        words = ngettext(
            "%(n)s conversation does not hold any more: %(titles)s",
            "%(n)s conversations do not hold any more: %(titles)s",
            len(failed),
        )
        titles = ", ".join(failed[:5]) + (" …" if len(failed) > 5 else "")
        messages.warning(request, words % {"n": len(failed), "titles": titles})
    if not results:
        messages.info(request, _("There is no conversation to try."))


def _content(name: str) -> tuple[Chosen | None, dict[str, object]]:
    """Return the content to run on, else what the page must tell."""
    try:
        return content_of(name), {}
    except NotPublishableError as error:
        trouble = _("The draft cannot be tried yet: these errors must be mended first.")
        found = findings_json(error.findings)
        return None, {"trouble": trouble, "findings": found}
    except NothingPublishedError:
        return None, {"trouble": _("Nothing is published yet. Choose the draft.")}
    except (UnknownContentError, SnapshotError):
        return None, {"trouble": _("There is no such release. Choose another one.")}


@require_http_methods(["GET", "HEAD", "POST"])
def conversation(request: HttpRequest, number: int) -> HttpResponse:
    """Replay one conversation; on POST take new replies as right, or keep the old ones."""
    row = Conversation.objects.select_related("created_by").filter(pk=number).first()
    if row is None:
        raise Http404(_("There is no such conversation."))
    name = (request.POST if request.method == "POST" else request.GET).get("content", DRAFT)
    chosen, trouble = _content(name)
    if chosen is None:
        return _replayed(request, row, name, None, trouble)
    if request.method == "POST":
        return _decided(request, row, name, chosen)
    return _replayed(request, row, name, run(chosen.content, row), {"chosen": chosen})


def _decided(request: HttpRequest, row: Conversation, name: str, chosen: Chosen) -> HttpResponse:
    if not request.user.has_perm("authoring.change_conversation"):
        raise PermissionDenied
    address = f"{reverse('admin:conversation', args=[row.pk])}?content={_name(name)}"
    place = request.POST.get("right", "")
    if not place:
        run_all(chosen.content, write=True, only=[row.pk])
        text = _("The conversation stays as it is: mend what the robot says and try it again.")
        messages.info(request, text)
        return redirect(address)
    known = place.isascii() and place.isdecimal() and len(place) < 4
    try:
        seen = request.POST.get("seen", "")
        accept(chosen.content, row.pk, seen, int(place) if known else None)
    except (ChangedMeanwhileError, Conversation.DoesNotExist):
        text = _("The replies have changed meanwhile. Nothing was saved: look at them again.")
        messages.warning(request, text)
        return redirect(address)
    messages.success(request, _("Saved: this is right from now on."))
    return redirect(address)


def _name(text: str) -> str:
    return text if text in (DRAFT, PUBLISHED) or (text.isascii() and text.isdecimal()) else DRAFT


def _replayed(
    request: HttpRequest,
    row: Conversation,
    name: str,
    result: Result | None,
    more: Mapping[str, object],
) -> HttpResponse:
    turns = result.turns if result else ()
    context = {
        **page_context(request),
        **more,
        "title": row.title,
        "row": row,
        "content_name": _name(name),
        "result": result,
        "turns": [_shown(place, turn, row.language) for place, turn in enumerate(turns)],
        "may_change": request.user.has_perm("authoring.change_conversation"),
        "may_delete": request.user.has_perm("authoring.delete_conversation"),
    }
    status = 409 if result is None and request.method == "POST" else 200
    return render(request, "authoring/conversation.html", context, status=status)


def _shown(place: int, turn: TurnResult, language: str) -> Shown:
    before, now = turn.before.text(language), turn.now.text(language)
    return Shown(place, turn, before, now, tuple(word_marks(before, now)), must(turn.expected))


def must(turn: Turn) -> str:
    """Return in words what must hold of a turn."""
    words = {
        EXACT: _("exactly this reply"),
        TOPIC: _("the topic %(value)s"),
        PLAN: _("the plan %(value)s"),
        WORDS: _("the words %(value)s"),
        ANY: _("anything"),
    }[turn.kind]
    return words % {"value": turn.value or _("none")}
