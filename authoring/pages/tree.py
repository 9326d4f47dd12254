"""The page "Tree": browse, search and move topics. Pieces of it are fetched as they are opened."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from django.contrib import messages
from django.core.exceptions import PermissionDenied
from django.http import Http404, HttpRequest, HttpResponse
from django.shortcuts import redirect, render
from django.urls import NoReverseMatch, reverse
from django.utils.http import urlencode
from django.utils.translation import gettext as _
from django.utils.translation import gettext_lazy
from django.views.decorators.http import require_http_methods, require_safe

from authoring.pages.page import Page
from authoring.site_context import page_context
from authoring.topic_page.neighbours import names_of
from authoring.topic_page.shape import Shape, path_of, read_shape
from authoring.topic_page.words import KINDS
from authoring.tree import moving
from authoring.tree.topic_search import LONGEST, Hit, paths, search
from authoring.tree.tree_browser import children_of, summary

MOVE = "dialogue.change_topic"
#: The value of `to` for the root: a key is one word of letters and digits.
ROOT = "-"


@dataclass(frozen=True, slots=True)
class Place:
    """A topic as breadcrumbs name it."""

    key: str
    name: str


@dataclass(frozen=True, slots=True)
class Found:
    """A hit of the search: the topic, those above it, the word that led to it if another."""

    topic: Place
    above: tuple[Place, ...]
    word: str


@require_safe
def tree(request: HttpRequest) -> HttpResponse:
    """Show the tree: the branches, opened down to `?open=Key`; `?q=` searches."""
    shape = read_shape()
    number = _number(shape, request.GET.get("open", ""))
    open_ = [] if number is None else [number, *shape.above(number)]
    searched, called = _searched(request, shape, open_)
    context = {
        **page_context(request),
        "title": _("Tree"),
        "nodes": children_of(shape, None, open_),
        "selected": shape.keys[number] if number is not None else "",
        "unknown": request.GET.get("open", "")[:LONGEST] if number is None else "",
        "may_move": request.user.has_perm(MOVE),
        **searched,
        **(_panel(request, shape, number, called) if number is not None else {}),
    }
    return render(request, "authoring/tree.html", context)


@require_safe
def below(request: HttpRequest, key: str) -> HttpResponse:
    """Return the nodes below a topic, as a piece of the page."""
    shape = read_shape()
    number = _known(shape, key)
    nodes = children_of(shape, number)
    context = {"nodes": nodes, "key": key, "may_move": request.user.has_perm(MOVE)}
    return render(request, "authoring/tree_nodes.html", context)


@require_safe
def panel(request: HttpRequest, key: str) -> HttpResponse:
    """Return what the side panel tells about a topic, as a piece of the page."""
    shape = read_shape()
    number = _known(shape, key)
    called = names_of(shape, paths(shape, [number]))
    context = _panel(request, shape, number, called)
    return render(request, "authoring/tree_panel.html", context)


@require_safe
def found(request: HttpRequest) -> HttpResponse:
    """Return the hits of a search, as a piece of the page."""
    context, _called = _searched(request, read_shape())
    return render(request, "authoring/tree_hits.html", context)


@require_http_methods(["GET", "HEAD", "POST"])
def move(request: HttpRequest, key: str) -> HttpResponse:
    """Choose a new place (`?q=` searches), see what would change (`?to=Key`), move on POST."""
    if not request.user.has_perm(MOVE):
        raise PermissionDenied
    shape = read_shape()
    number = _known(shape, key)
    if request.method == "POST":
        return _moved(request, shape, number)
    to = request.GET.get("to", "")
    return _move_page(request, shape, number, to[:LONGEST])


def _moved(request: HttpRequest, shape: Shape, number: int) -> HttpResponse:
    to, seen = request.POST.get("to", ""), request.POST.get("seen", "")
    target = _number(shape, to)
    if target is None and to != ROOT:
        trouble = _("There is no topic %(key)s. Search for the place to move to.")
        return _move_page(request, shape, number, "", trouble % {"key": to[:LONGEST]})
    try:
        told = request.POST.get("told", "")
        row = moving.move(number, target, _number(shape, seen), told)
    except moving.CannotMoveError as error:
        return _move_page(request, read_shape(), number, to, str(error))
    where = shape.keys[target] if target is not None else _("the root, as a branch")
    words = _("%(key)s now stands below %(where)s. Robots notice after the next publication.")
    messages.success(request, words % {"key": row.key, "where": where})
    return redirect(f"{reverse('admin:tree')}?{urlencode({'open': row.key})}")


def _move_page(
    request: HttpRequest, shape: Shape, number: int, to: str, trouble: str = ""
) -> HttpResponse:
    shown, target = None, _number(shape, to)
    if to and target is None and to != ROOT:
        trouble = trouble or _("There is no topic %(key)s. Search for it below.") % {"key": to}
    elif to:
        try:
            shown = moving.preview(shape, number, target)
        except moving.CannotMoveError as error:
            trouble = trouble or str(error)
    searched, called = _searched(
        request, shape, [one for one in (number, target) if one is not None]
    )
    parent = shape.parents.get(number)
    context = {
        **page_context(request),
        "title": _("Move %(name)s") % {"name": called[number]},
        "topic": Place(shape.keys[number], called[number]),
        "trail_of_topic": _places(shape, called, number)[:-1],
        "trail_of_target": _places(shape, called, target) if target is not None else (),
        "seen": shape.keys[parent] if parent is not None else ROOT,
        "to": to,
        "root": ROOT,
        "is_branch": parent is None,
        "preview": shown,
        "trouble": trouble,
        **searched,
        "moving": shape.keys[number],
    }
    return render(request, "authoring/tree_move.html", context, status=409 if trouble else 200)


def _places(shape: Shape, called: Mapping[int, str], number: int) -> tuple[Place, ...]:
    return tuple(Place(key, called[place]) for place, key in path_of(shape, number))


def _searched(
    request: HttpRequest, shape: Shape, shown: Iterable[int] = ()
) -> tuple[dict[str, object], Mapping[int, str]]:
    """Return what a page shows of a search, and the names of its hits and of `shown` topics."""
    text = request.GET.get("q", "")[:LONGEST].strip()
    hits, total = search(text) if text else ([], 0)
    known = [hit for hit in hits if hit.number in shape.keys]
    named = paths(shape, [*shown, *(hit.number for hit in known)])
    called = names_of(shape, named) if named else {}
    moved = request.GET.get("moving", "")[:LONGEST]
    return {
        "q": text,
        "hits": [_hit(shape, called, hit) for hit in known],
        "total": total,
        "moving": moved if moved in shape.keys.values() else "",
    }, called


def _hit(shape: Shape, called: Mapping[int, str], hit: Hit) -> Found:
    *above, topic = _places(shape, called, hit.number)
    return Found(topic, tuple(above), "" if hit.word in (topic.name, topic.key) else hit.word)


def _panel(
    request: HttpRequest, shape: Shape, number: int, called: Mapping[int, str]
) -> dict[str, object]:
    """Return what the side panel shows; `called` names the topic and those above it."""
    user, told = request.user, summary(shape, number)
    key = shape.keys[number]
    return {
        "summary": told,
        "trail": _places(shape, called, number),
        "kinds": [(KINDS[kind].name, count) for kind, count in told.own_kinds if kind in KINDS],
        "page_of_topic": reverse("admin:dialogue_topic_change", args=(number,)),
        "add": _add(number) if user.has_perm("dialogue.add_topic") else "",
        "chat": _chat(key),
        "move": reverse("admin:tree_move", args=(key,)) if user.has_perm(MOVE) else "",
    }


def _add(number: int) -> str:
    return f"{reverse('admin:dialogue_topic_add')}?{urlencode({'parent': number})}"


def _chat(key: str) -> str:
    try:
        return f"{reverse('admin:chat')}?{urlencode({'topic': key})}"
    except NoReverseMatch:
        return ""


def _number(shape: Shape, key: str) -> int | None:
    if not key:
        return None
    return next((number for number, one in shape.keys.items() if one == key), None)


def _known(shape: Shape, key: str) -> int:
    number = _number(shape, key)
    if number is None:
        raise Http404(_("There is no topic of that name."))
    return number


VIEW = "dialogue.view_topic"
TREE_PAGES = (
    Page("tree", "tree/", tree, VIEW, gettext_lazy("Tree"), 10),
    Page("tree_found", "tree/found/", found, VIEW),
    Page("tree_below", "tree/below/<str:key>/", below, VIEW),
    Page("tree_panel", "tree/panel/<str:key>/", panel, VIEW),
    Page("tree_move", "tree/move/<str:key>/", move, MOVE),
)
