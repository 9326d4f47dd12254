"""The rows of API keys: their label and limit; making and revoking is done on the page of keys."""

from django.contrib import admin
from django.http import HttpRequest

from authoring.models.api_key import ApiKey


@admin.register(ApiKey)
class ApiKeyAdmin(admin.ModelAdmin):
    list_display = ("label", "prefix", "ontology", "created", "created_by", "last_used", "revoked")
    list_select_related = ("created_by",)
    search_fields = ("label", "prefix")
    readonly_fields = ("prefix", "created", "created_by", "last_used", "revoked")

    def has_add_permission(self, request: HttpRequest) -> bool:
        return False  # A form could not show the key.
