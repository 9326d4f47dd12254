"""The authoring pages of topics and sentences (plain forms)."""

from django.contrib import admin
from django.db.models import QuerySet
from django.http import HttpRequest

from dialogue import models


class NameInline(admin.TabularInline):
    model = models.TopicName
    extra = 0


class KeywordInline(admin.TabularInline):
    model = models.KeywordSet
    extra = 0


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


class SentenceInline(admin.TabularInline):
    model = models.Sentence
    extra = 0


@admin.register(models.Culture)
class CultureAdmin(admin.ModelAdmin):
    list_display = ("code", "language", "position")


@admin.register(models.Topic)
class TopicAdmin(admin.ModelAdmin):
    list_display = ("key", "parent", "home", "gentle")
    list_filter = ("gentle", "home")
    list_select_related = ("parent", "home")
    search_fields = ("key", "names__name")
    autocomplete_fields = ("parent", "also")
    inlines = (NameInline, KeywordInline, InstanceInline, VariableInline, LinkInline)


@admin.register(models.Frame)
class FrameAdmin(admin.ModelAdmin):
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
