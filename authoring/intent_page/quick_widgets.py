"""Inputs that are made without a template: a page of an intent has more than a thousand of them."""

from collections.abc import Mapping
from functools import lru_cache
from typing import Any

from django import forms
from django.template.loader import render_to_string
from django.utils.html import escape
from django.utils.safestring import SafeString, mark_safe
from django.utils.translation import get_language


class QuickHidden(forms.HiddenInput):
    """A hidden input."""

    def render(
        self, name: str, value: Any, attrs: dict[str, Any] | None = None, renderer: Any = None
    ) -> SafeString:
        """Return its HTML."""
        shown = self.format_value(value)
        extra = {} if shown is None else {"value": str(shown)}
        return _input("hidden", name, extra | self.build_attrs(self.attrs, attrs))


class QuickBox(forms.CheckboxInput):
    """A box to be ticked."""

    def render(
        self, name: str, value: Any, attrs: dict[str, Any] | None = None, renderer: Any = None
    ) -> SafeString:
        """Return its HTML."""
        shown = self.format_value(value)
        extra: dict[str, Any] = {} if shown is None else {"value": str(shown)}
        ticked = {"checked": True} if self.check_test(value) else {}
        return _input("checkbox", name, extra | self.build_attrs(self.attrs, attrs) | ticked)


def _input(kind: str, name: str, attrs: dict[str, Any]) -> SafeString:
    written = "".join(
        f" {key}" if value is True else f' {key}="{escape(value)}"'
        for key, value in attrs.items()
        if value is not False and value is not None
    )
    return mark_safe(f'<input type="{kind}" name="{escape(name)}"{written}>')  # noqa: S308


def quicken(fields: dict[str, forms.Field]) -> None:
    """Give plain hidden inputs and boxes their quick widgets."""
    for field in fields.values():
        widget = field.widget
        for plain, quick in ((forms.HiddenInput, QuickHidden), (forms.CheckboxInput, QuickBox)):
            if type(widget) is plain:
                made = quick(widget.attrs)
                made.is_required, made.is_localized = widget.is_required, widget.is_localized
                field.widget = made


def filled(template: str, texts: Mapping[str, str], **context: object) -> SafeString:
    """Return a small template with these safe texts for its variables of these names.

    It is rendered once for each language and `context`; afterwards the texts are put in.
    """
    names = tuple(sorted(texts))
    html = _rendered(template, get_language() or "", names, tuple(sorted(context.items())))
    for name in names:
        html = html.replace(_mark(name), texts[name])
    return mark_safe(html)  # noqa: S308


def _mark(name: str) -> str:
    return f"\0{name}\0"


@lru_cache(maxsize=100)
def _rendered(
    template: str, _language: str, names: tuple[str, ...], context: tuple[tuple[str, object], ...]
) -> str:
    marks = {name: mark_safe(_mark(name)) for name in names}  # noqa: S308
    return render_to_string(template, {**dict(context), **marks})
