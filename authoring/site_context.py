"""What all our pages hand to their templates."""

from typing import Any

from django.contrib import admin
from django.http import HttpRequest


def page_context(request: HttpRequest) -> dict[str, Any]:
    """Return what the admin gives every page, the menu too."""
    return admin.site.each_context(request)
