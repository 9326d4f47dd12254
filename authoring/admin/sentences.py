"""The authoring page of sentences."""

from typing import Any
from urllib.parse import urlencode

from django import forms
from django.contrib import admin
from django.db.models import QuerySet
from django.http import HttpRequest, HttpResponse, HttpResponseRedirect
from django.urls import reverse
from django.utils.translation import gettext_lazy as _

from authoring.admin.base import PlacedAdmin
from authoring.admin.filters import FRAME_FILTERS
from authoring.admin.sentence_forms import (
    CulturesField,
    FrameForm,
    SentenceForm,
    SentenceFormSet,
)
from authoring.admin.topic_filters import KindFilter, MissingSentenceFilter, TopicBranchFilter
from authoring.admin.topic_forms import KnownAutocomplete
from authoring.admin.topics import LanguageInline
from authoring.topic_page.words import KINDS, in_own_language, own_language
from dialogue import models


class SentenceInline(LanguageInline):
    model = models.Sentence
    form = SentenceForm
    formset = SentenceFormSet
    template = "admin/dialogue/frame/sentences.html"


@admin.register(models.Frame)
class FrameAdmin(PlacedAdmin):
    form = FrameForm
    list_display = ("key", "topic", "pool", "kind", "said", "for_cultures")
    list_filter = (
        KindFilter,
        TopicBranchFilter,
        MissingSentenceFilter,
        "only",
        "pool",
        *FRAME_FILTERS,
    )
    list_select_related = ("topic",)
    list_per_page = 50
    search_fields = ("key", "sentences__text")
    search_help_text = _("Words of the sentence in any language, or its name.")
    autocomplete_fields = ("topic",)
    fieldsets = (
        (None, {"fields": ("topic", "type", "scope", "only")}),
        (_("For proposals"), {"fields": ("do",)}),
        (_("More"), {"fields": ("pool", "key", "position")}),
    )
    inlines = (SentenceInline,)

    def get_queryset(self, request: HttpRequest) -> QuerySet[models.Frame]:
        rows: QuerySet[models.Frame] = super().get_queryset(request)
        rows = rows.select_related("topic")
        if request.resolver_match and request.resolver_match.url_name == self._list_name():
            return rows.prefetch_related("sentences", "only")
        return rows

    def _list_name(self) -> str:
        return f"{self.opts.app_label}_{self.opts.model_name}_changelist"

    def formfield_for_foreignkey(self, db_field: Any, request: HttpRequest, **kwargs: Any) -> Any:
        if db_field.name == "topic":
            kwargs["widget"] = KnownAutocomplete(db_field, self.admin_site)
        return super().formfield_for_foreignkey(db_field, request, **kwargs)

    def formfield_for_manytomany(self, db_field: Any, request: HttpRequest, **kwargs: Any) -> Any:
        if db_field.name != "only":
            return super().formfield_for_manytomany(db_field, request, **kwargs)
        return CulturesField(
            models.Culture.objects.all(),
            required=False,
            label=_("Only in these cultures"),
            help_text=_("None ticked: in all of them. Example: tick Japanese for a local custom."),
            widget=forms.CheckboxSelectMultiple,
        )

    def get_changeform_initial_data(self, request: HttpRequest) -> dict[str, Any]:
        """Begin with what the address says, or like the sentence it says to begin from."""
        given = super().get_changeform_initial_data(request)
        source = _source(request)
        if source is not None:
            given |= {"do": source.do, "only": [one.pk for one in source.only.all()]}
        return given

    def get_formset_kwargs(
        self, request: HttpRequest, obj: Any, inline: Any, prefix: str
    ) -> dict[str, Any]:
        """Propose the words of the sentence to begin from."""
        kwargs: dict[str, Any] = super().get_formset_kwargs(request, obj, inline, prefix)
        source = None if obj.pk else _source(request)
        if source is not None and isinstance(inline, SentenceInline):
            rows = source.sentences.order_by("language")
            kwargs["initial"] = [{"language": row.language, "text": row.text} for row in rows]
        return kwargs

    def render_change_form(
        self, request: HttpRequest, context: dict[str, Any], *args: Any, **kwargs: Any
    ) -> HttpResponse:
        """Show where one comes from, and for which cultures the sentence can be tried."""
        context |= {
            "back": _back(request),
            "source": _source(request) if context.get("add") else None,
            "kinds": KINDS.values(),
        }
        return super().render_change_form(request, context, *args, **kwargs)

    def response_post_save_change(self, request: HttpRequest, obj: Any) -> HttpResponseRedirect:
        """Go back to the topic's page where one came from there."""
        back = _back(request)
        if back:
            return HttpResponseRedirect(f"{back}#s{obj.pk}")
        return super().response_post_save_change(request, obj)

    def response_post_save_add(self, request: HttpRequest, obj: Any) -> HttpResponseRedirect:
        """Go back to the topic's page where one came from there."""
        back = _back(request)
        if back:
            return HttpResponseRedirect(f"{back}#s{obj.pk}")
        return super().response_post_save_add(request, obj)

    @admin.display(description=_("kind"), ordering="type")
    def kind(self, frame: models.Frame) -> str:
        return str(KINDS[frame.type].name) if frame.type in KINDS else ""

    @admin.display(description=_("what it says"))
    def said(self, frame: models.Frame) -> str:
        texts = {one.language: one.text for one in frame.sentences.all()}
        return texts.get(own_language()) or next(iter(texts.values()), "")

    @admin.display(description=_("only for"))
    def for_cultures(self, frame: models.Frame) -> str:
        return ", ".join(in_own_language(one.names, one.code) for one in frame.only.all())


def _back(request: HttpRequest) -> str:
    """Return the topic page that the address says one came from, or nothing."""
    number = request.GET.get("back", "")
    if not (number.isascii() and number.isdigit() and len(number) < 10):
        return ""
    view = {key: request.GET[key][:8] for key in ("culture", "language") if key in request.GET}
    address = reverse("admin:dialogue_topic_change", args=[number])
    return f"{address}?{urlencode(view)}" if view else address


def _source(request: HttpRequest) -> models.Frame | None:
    number = request.GET.get("from", "")
    if not (number.isascii() and number.isdigit() and len(number) < 10):
        return None
    return models.Frame.objects.filter(pk=number).first()
