"""The form of a regression conversation: its title and note; its turns come from the test chat."""

from django.contrib import admin
from django.http import HttpRequest
from django.urls import reverse
from django.utils.html import format_html
from django.utils.safestring import SafeString
from django.utils.translation import gettext as _
from django.utils.translation import gettext_lazy

from authoring.models.conversation import Conversation


@admin.register(Conversation)
class ConversationAdmin(admin.ModelAdmin):
    list_display = ("title", "language", "culture", "passed", "ran", "created_by")
    list_filter = ("language", "culture", "passed")
    list_select_related = ("created_by",)
    search_fields = ("title", "note")
    fields = ("title", "note", "replay", "language", "culture", "seed", "topic", "created_by")
    readonly_fields = ("replay", "language", "culture", "seed", "topic", "created_by")

    def has_add_permission(self, request: HttpRequest) -> bool:
        return False  # A talk is saved from the test chat.

    @admin.display(description=gettext_lazy("turns"))
    def replay(self, row: Conversation) -> SafeString:
        address = reverse("admin:conversation", args=[row.pk])
        return format_html('<a href="{}">{}</a>', address, _("Look at it and try it again"))
