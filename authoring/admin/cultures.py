"""The authoring page of cultures."""

from django.contrib import admin

from authoring.admin.base import PlacedAdmin
from dialogue import models


@admin.register(models.Culture)
class CultureAdmin(PlacedAdmin):
    list_display = ("code", "language", "position")
