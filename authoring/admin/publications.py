"""The rows of releases: to be read; only an administrator may correct a note.

What can be done with a release stands on its page (authoring.pages.releases).
"""

from django.contrib import admin
from django.db.models import QuerySet
from django.http import HttpRequest
from django.urls import reverse
from django.utils.html import format_html
from django.utils.safestring import SafeString
from django.utils.translation import gettext_lazy as _

from dialogue import models

_COUNTED = {
    "topics": _("topics"),
    "frames": _("sentences written"),
    "sentences": _("sentences by topic"),
    "intents": _("intents"),
}


@admin.register(models.Publication)
class PublicationAdmin(admin.ModelAdmin):
    list_display = ("id", "created", "author", "note", "what_it_holds", "page")
    readonly_fields = ("page", "created", "author", "what_it_holds", "checksum")
    fields = ("note", *readonly_fields)

    def get_queryset(self, request: HttpRequest) -> QuerySet[models.Publication]:
        return super().get_queryset(request).defer("data").select_related("author")

    @admin.display(description=_("what it holds"))
    def what_it_holds(self, row: models.Publication) -> str:
        return ", ".join(
            f"{number} {_COUNTED.get(name, name)}" for name, number in row.counts.items()
        )

    @admin.display(description=_("release"))
    def page(self, row: models.Publication) -> SafeString:
        address = reverse("admin:release", args=[row.pk])
        return format_html('<a href="{}">{}</a>', address, _("What changed, going back, files"))

    def has_add_permission(self, request: HttpRequest) -> bool:
        return False

    def has_delete_permission(self, request: HttpRequest, obj: object = None) -> bool:
        return False
