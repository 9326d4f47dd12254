"""The parts of the topic page that come later or alone: said, picture, one sentence, previews."""

from typing import Any
from urllib.parse import urlencode

from django.contrib import admin
from django.db import connection, transaction
from django.http import (
    Http404,
    HttpRequest,
    HttpResponse,
    HttpResponseRedirect,
    JsonResponse,
)
from django.shortcuts import get_object_or_404, render
from django.urls import reverse
from django.utils.translation import gettext as _
from django.views.decorators.http import require_GET, require_http_methods, require_POST

from authoring.history.conflicts import written
from authoring.pages.page import Page
from authoring.topic_page.in_place import TextsForm
from authoring.topic_page.name_words import NAME_FIELDS, forms_of, without_empty
from authoring.topic_page.neighbours import names_of, neighbours
from authoring.topic_page.picture import BELOW, BOX, FROM, LENDER, LINK, TALL, draw
from authoring.topic_page.preview import preview, read_draft
from authoring.topic_page.shape import Shape, read_shape
from authoring.topic_page.topic_context import asked_panel, panel_context
from dialogue.models import Frame
from languages.known import LANGUAGES
from languages.language import FormError
from languages.name_fields import LONGEST


def _known(number: int) -> Shape:
    shape = read_shape()
    if number not in shape.keys:
        raise Http404(_("There is no such topic any more."))
    return shape


def _page(
    request: HttpRequest, part: str, context: dict[str, Any], status: int = 200
) -> HttpResponse:
    """Show a part alone where a script asks for it, else a page of its own."""
    if request.GET.get("part"):
        return render(request, part, context, status=status)
    whole = {**admin.site.each_context(request), **context, "part": part}
    return render(request, "admin/dialogue/topic/part_page.html", whole, status=status)


@require_GET
def said(request: HttpRequest, number: int) -> HttpResponse:
    """Show what the robot says about a topic to people of a culture in a language."""
    panel = asked_panel(request, _known(number), number)
    context = {**panel_context(request, panel), "title": panel.key, "topic_number": number}
    return _page(request, "admin/dialogue/topic/said.html", context)


@require_GET
def picture(request: HttpRequest, number: int) -> HttpResponse:
    """Show the neighbourhood of a topic."""
    shape = _known(number)
    called = names_of(shape, [number])
    drawn = draw((number, called[number]), neighbours(shape, number))
    captions = {
        BELOW: _("below"),
        LINK: _("leads to"),
        FROM: _("comes from"),
        LENDER: _("lends sentences"),
    }
    context = {
        "title": _("Picture of %(topic)s") % {"topic": called[number]},
        "drawn": drawn,
        "box": BOX,
        "tall": TALL,
        "captions": [(one, captions[one.role]) for one in drawn.captions],
        "groups": _listed(drawn, captions),
        "topic_number": number,
        "name": called[number],
    }
    return _page(request, "admin/dialogue/topic/picture.html", context)


def _listed(drawn: Any, captions: dict[str, str]) -> list[dict[str, Any]]:
    """Return the same as a list: a group a role, from above to below."""
    words = {"above": _("above"), **captions}
    return [
        {
            "title": words[role],
            "boxes": [box for box in drawn.boxes if box.role == role],
            "more": drawn.hidden.get(role, 0),
        }
        for role in words
        if any(box.role == role for box in drawn.boxes)
    ]


@require_http_methods(["GET", "POST"])
def sentence(request: HttpRequest, number: int, frame: int) -> HttpResponse:
    """Show the small form of a sentence; save what it sends."""
    if request.method == "POST":
        with transaction.atomic():
            return _save_sentence(request, number, frame)
    row = get_object_or_404(Frame.objects.filter(topic=number), pk=frame)
    return _sentence_form(request, TextsForm(row))


def _save_sentence(request: HttpRequest, number: int, frame: int) -> HttpResponse:
    rows = Frame.objects.filter(topic=number)
    if connection.features.has_select_for_update:  # SQLite lets all writers wait anyway.
        rows = rows.select_for_update()
    row = rows.filter(pk=frame).first()
    if row is None:
        return _sentence_gone(request, number)
    form = TextsForm(row, request.POST)
    if not form.is_valid():
        return _sentence_form(request, form, 409 if form.conflict else 200)
    form.save()
    if request.GET.get("part"):
        return JsonResponse({"saved": True})
    return HttpResponseRedirect(_topic_address(request, number, frame))


def _sentence_form(request: HttpRequest, form: TextsForm, status: int = 200) -> HttpResponse:
    row = form.frame
    number = row.topic_id or 0
    context = {
        "title": _("Sentence %(key)s") % {"key": row.key},
        "form": form,
        "frame": row,
        "topic_number": number,
        "back": _topic_address(request, number, row.pk),
        "query": urlencode(_view(request)),
    }
    return _page(request, "admin/dialogue/topic/sentence_form.html", context, status)


def _sentence_gone(request: HttpRequest, number: int) -> HttpResponse:
    """Give the words back of which the sentence was deleted meanwhile, or moved away."""
    texts = [text for name, text in written(request.POST) if not name.endswith("-seen")]
    if not texts:
        raise Http404(_("There is no such sentence any more."))
    context = {
        "title": _("It was deleted while you wrote"),
        "texts": texts,
        "topic_number": number,
    }
    return _page(request, "admin/dialogue/topic/sentence_gone.html", context, 409)


def _view(request: HttpRequest) -> dict[str, str]:
    return {key: request.GET[key][:8] for key in ("culture", "language") if key in request.GET}


def _topic_address(request: HttpRequest, number: int, frame: int) -> str:
    address = reverse("admin:dialogue_topic_change", args=[number])
    return f"{address}?{urlencode(_view(request))}#s{frame}"


@require_POST
def try_sentence(request: HttpRequest) -> JsonResponse:
    """Return as JSON how words that are being written will sound."""
    return JsonResponse(preview(read_draft(request.POST.dict())))


@require_POST
def name_forms(request: HttpRequest) -> JsonResponse:
    """Return as JSON every form of a name that is being written, or what is wrong with it."""
    language = request.POST.get("language", "")
    if language not in LANGUAGES:
        return JsonResponse({"problem": _("Choose a language."), "field": "language", "forms": []})
    fields = {row.key: request.POST.get(row.key, "") for row in NAME_FIELDS[language]}
    name = request.POST.get("name", "")
    if any(len(text) > LONGEST for text in (name, *fields.values())):
        told = _("Use at most %(most)d characters.") % {"most": LONGEST}
        return JsonResponse({"problem": told, "field": "name", "forms": []})
    try:
        made = forms_of(language, name.strip(), without_empty(fields))
    except FormError as error:
        told = f"{error.message} {error.hint}"
        return JsonResponse({"problem": told, "field": error.field, "forms": []})
    return JsonResponse({"problem": "", "field": "", "forms": [one._asdict() for one in made]})


_VIEW, _CHANGE = "dialogue.view_topic", "dialogue.change_sentence"

TOPIC_PAGES = (
    Page("topic_said", "dialogue/topic/<int:number>/said/", said, _VIEW),
    Page("topic_picture", "dialogue/topic/<int:number>/picture/", picture, _VIEW),
    Page(
        "topic_sentence",
        "dialogue/topic/<int:number>/sentence/<int:frame>/",
        sentence,
        _CHANGE,
    ),
    Page("try_sentence", "dialogue/try-sentence/", try_sentence, _VIEW),
    Page("name_forms", "dialogue/name-forms/", name_forms, _VIEW),
)
