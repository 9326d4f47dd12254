"""The authoring pages of topics and sentences (plain forms)."""

from typing import Any

from django import forms
from django.contrib import admin
from django.db.models import QuerySet
from django.http import HttpRequest

from dialogue import authoring, models
from languages.known import LANGUAGES


class LanguageInline(admin.TabularInline):
    """One row a language; a new page offers all of them."""

    def get_extra(self, request: HttpRequest, obj: Any = None, **kwargs: Any) -> int:
        return 0 if obj else len(LANGUAGES)


class NameInline(LanguageInline):
    model = models.TopicName


class KeywordInline(LanguageInline):
    model = models.KeywordSet


class VariableInline(admin.TabularInline):
    model = models.Variable
    extra = 0


class InstanceInline(admin.TabularInline):
    model = models.TopicInstance
    extra = 0


class LinkInline(admin.TabularInline):
    model = models.TopicLink
    fk_name = "topic"
    extra = 0
    autocomplete_fields = ("target",)


class SentenceInline(LanguageInline):
    model = models.Sentence


class PlacedAdmin(admin.ModelAdmin):
    """A new row is proposed after all others."""

    def get_changeform_initial_data(self, request: HttpRequest) -> dict[str, Any]:
        place = authoring.next_position(self.model)
        return {"position": place, **super().get_changeform_initial_data(request)}


@admin.register(models.Culture)
class CultureAdmin(PlacedAdmin):
    list_display = ("code", "language", "position")


@admin.register(models.Topic)
class TopicAdmin(PlacedAdmin):
    list_display = ("key", "parent", "home", "gentle")
    list_filter = ("gentle", "home")
    list_select_related = ("parent", "home")
    search_fields = ("key", "names__name")
    autocomplete_fields = ("parent", "also")
    inlines = (NameInline, KeywordInline, InstanceInline, VariableInline, LinkInline)

    def save_related(self, request: HttpRequest, form: Any, formsets: Any, change: bool) -> None:
        super().save_related(request, form, formsets, change)
        authoring.give_likeliness(form.instance)
        authoring.rename_frames(form.instance)


class FrameForm(forms.ModelForm):
    """A frame whose key is proposed when it is left empty or no longer fits."""

    key = forms.CharField(
        required=False,
        max_length=140,
        help_text="Stable name; left empty, the next free one is taken. Example: GreenTea.q4",
    )

    def clean(self) -> dict[str, Any]:
        cleaned: dict[str, Any] = super().clean() or self.cleaned_data
        topic, pool = cleaned.get("topic"), cleaned.get("pool", "")
        moved = {"topic", "pool", "type"} & {*self.changed_data}
        proposed = not cleaned.get("key") or (moved and "key" not in self.changed_data)
        if proposed and bool(topic) != bool(pool):
            cleaned["key"] = authoring.next_key(topic, pool, cleaned.get("type", ""))
        return cleaned


@admin.register(models.Frame)
class FrameAdmin(PlacedAdmin):
    form = FrameForm
    list_display = ("key", "topic", "pool", "type", "in_english")
    list_filter = ("type", "pool")
    list_select_related = ("topic",)
    search_fields = ("key", "sentences__text")
    autocomplete_fields = ("topic",)
    inlines = (SentenceInline,)

    def get_queryset(self, request: HttpRequest) -> QuerySet[models.Frame]:
        return super().get_queryset(request).prefetch_related("sentences")

    @admin.display(description="English")
    def in_english(self, frame: models.Frame) -> str:
        return next((one.text for one in frame.sentences.all() if one.language == "en"), "")


@admin.register(models.Publication)
class PublicationAdmin(admin.ModelAdmin):
    list_display = ("id", "created", "author", "note", "counts")
    readonly_fields = ("created", "author", "checksum", "counts")
    exclude = ("data",)

    def get_queryset(self, request: HttpRequest) -> QuerySet[models.Publication]:
        return super().get_queryset(request).defer("data").select_related("author")

    def has_add_permission(self, request: HttpRequest) -> bool:
        return False

    def has_delete_permission(self, request: HttpRequest, obj: object = None) -> bool:
        return False
