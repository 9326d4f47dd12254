"""The forms of value lists and phrases."""

from typing import Any

from django import forms
from django.utils.translation import gettext_lazy as _

from authoring.intent_page.list_widgets import Wordings, WordsByValue
from languages.known import LANGUAGES
from plans import models
from plans.engine.patterns import PatternError, parse_options
from plans.engine.rules import phrase_breaches
from plans.engine.sayings import is_saying


class ValueListForm(forms.ModelForm):  # type: ignore[type-arg]
    class Meta:
        model = models.ValueList
        fields = ("key", "values", "position")
        widgets = {"values": WordsByValue(), "position": forms.HiddenInput()}
        labels = {"key": _("Name"), "values": _("Values and their words")}
        help_texts = {
            "values": _(
                "The value is what a robot is given (small letters); beside it all words that "
                "mean it, one a line. Empty a row to remove it."
            )
        }


class PhraseForm(forms.ModelForm):  # type: ignore[type-arg]
    class Meta:
        model = models.Phrase
        fields = ("key", "texts", "position")
        widgets = {"texts": Wordings(), "position": forms.HiddenInput()}
        labels = {"key": _("Name"), "texts": _("Wordings")}
        help_texts = {
            "texts": _("One wording a line. Written in trigger sentences by its name in < >.")
        }

    def clean(self) -> dict[str, Any]:
        """Refuse a wording that cannot be read, with the place."""
        cleaned: dict[str, Any] = super().clean() or self.cleaned_data
        texts = cleaned.get("texts")
        if isinstance(texts, dict) and not is_saying(cleaned.get("key") or ""):
            for code, text in texts.items():
                known = code in LANGUAGES and isinstance(text, str) and text
                message = phrase_fault(text) if known else ""
                if message:
                    self.add_error("texts", f"{LANGUAGES[code].own_name}: {message}")
        return cleaned


def phrase_fault(text: str) -> str:
    """Return why a phrase cannot be used, "" where all is well."""
    try:
        sequence = parse_options(text)
    except PatternError as error:
        return str(error)
    return next((breach.message for breach in phrase_breaches(sequence)), "")
