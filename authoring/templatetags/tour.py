"""`{% tour_steps as steps %}`: the quick tour for the person who is logged in."""

from typing import Any

from django import template

from authoring.tour import Step
from authoring.tour import tour_steps as read_steps

register = template.Library()


@register.simple_tag(takes_context=True)
def tour_steps(context: dict[str, Any]) -> list[Step]:
    """Return the steps whose places stand in the menu of the page."""
    return read_steps({page["url"] for page in context.get("menu", ())})
