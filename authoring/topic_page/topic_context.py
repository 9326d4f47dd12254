"""What the template of the topic page is given besides the form."""

from typing import Any

from django.http import HttpRequest

from authoring.topic_page.panel import Panel, read_panel
from authoring.topic_page.shape import Shape, read_shape
from authoring.topic_page.spread import read_spread, spread
from authoring.topic_page.words import in_own_language, liking_steps
from dialogue.models import Topic


def topic_context(request: HttpRequest, context: dict[str, Any], row: Topic) -> dict[str, Any]:
    """Return the panel for the culture and language asked for, and put spreads beside sliders."""
    shape = read_shape()
    _put_spreads(context, shape, row)
    return {
        **panel_context(request, asked_panel(request, shape, row.pk)),
        "liking_steps": liking_steps(),
    }


def asked_panel(request: HttpRequest, shape: Shape, number: int) -> Panel:
    """Return the panel of a topic for the culture and language that the address names."""
    return read_panel(
        shape, number, request.GET.get("culture", ""), request.GET.get("language", "")
    )


def panel_context(request: HttpRequest, panel: Panel) -> dict[str, Any]:
    """Return the panel with what the person may do in it."""
    return {
        "panel": panel,
        "may_change_sentence": request.user.has_perm("dialogue.change_sentence"),
        "may_add_frame": request.user.has_perm("dialogue.add_frame"),
    }


def _put_spreads(context: dict[str, Any], shape: Shape, row: Topic) -> None:
    branch = shape.branch(row.pk)
    counts = read_spread([branch, *shape.below(branch)])
    for inline in context.get("inline_admin_formsets", ()):
        if getattr(inline.opts, "tab", "") == "likeliness":
            for form in inline.formset.forms:
                culture, own = form.instance.culture_id, form.instance.likeliness
                seen = counts.get(culture, {})
                form.spread = spread(seen, float(own) if own is not None else None)
                form.culture_name = _culture_name(form.instance) if culture else ""


def _culture_name(instance: Any) -> str:
    names = instance.culture.names
    return in_own_language(names if isinstance(names, dict) else {}, instance.culture.code)
