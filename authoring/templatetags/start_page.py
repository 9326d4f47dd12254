"""`{% start_page as start %}`: what the start page of the admin tells."""

from typing import Any

from django import template

from authoring.start_page import StartPage, page_url
from authoring.start_page import start_page as read_start_page

register = template.Library()


@register.simple_tag(takes_context=True)
def start_page(context: dict[str, Any]) -> StartPage | None:
    """Return it, None for who may not see the content."""
    user = context["request"].user
    return read_start_page(user) if user.has_perm("dialogue.view_topic") else None


@register.simple_tag
def admin_page(name: str) -> str:
    """Return the address of a page of the admin, "" where there is none of that name."""
    return page_url(name)
