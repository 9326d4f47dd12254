"""The forms of a sentence: what it is, and its words in each language."""

from collections.abc import Mapping
from typing import Any

from django import forms
from django.utils.text import format_lazy
from django.utils.translation import gettext_lazy as _

from authoring.admin.topic_forms import KnownAutocomplete, LanguageForm, OnePerLanguageFormSet
from authoring.topic_page.refusals import refusals
from authoring.topic_page.words import KINDS, in_own_language
from dialogue import authoring, models
from dialogue.engine import concepts


class CulturesField(forms.ModelMultipleChoiceField):
    """Cultures to tick, by their names in the person's language."""

    def label_from_instance(self, obj: models.Culture) -> str:
        """Return what a culture is called."""
        return in_own_language(obj.names if isinstance(obj.names, dict) else {}, obj.code)


_WORDS = {
    "topic": (_("Topic"), _("What it is about. Example: Tea")),
    "type": (_("Kind"), _("What the sentence does. Example: a yes/no question opens a subject.")),
    "scope": (
        _("Where it is said"),
        _("Example: only what is below, for “Would you like a cup of $hasName?”"),
    ),
    "pool": (_("Pool"), _("For lines without a topic. Example: start, the first sentence.")),
}


class FrameForm(forms.ModelForm):
    """A frame whose key is proposed when it is left empty or no longer fits."""

    key = forms.CharField(
        required=False,
        max_length=140,
        label=_("Name"),
        help_text=format_lazy(
            "{told} {example}",
            told=_("Stays the same for ever. Left empty, the next free one is taken."),
            example=format_lazy(_("Example: {key}"), key="GreenTea.q4"),
        ),
    )

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        if "type" in self.fields:
            kinds = [(kind.letter, kind.name) for kind in KINDS.values()]
            kind_field: Any = self.fields["type"]
            kind_field.choices = [("", "---------"), *kinds]
        for name, (label, told) in _WORDS.items():
            if name in self.fields:
                self.fields[name].label, self.fields[name].help_text = label, told
        if "topic" in self.fields and self.instance.topic_id:
            widget = getattr(self.fields["topic"].widget, "widget", None)
            if isinstance(widget, KnownAutocomplete):
                widget.known = self.instance.topic

    def clean(self) -> dict[str, Any]:
        """Propose the key."""
        cleaned: dict[str, Any] = super().clean() or self.cleaned_data
        topic, pool = cleaned.get("topic"), cleaned.get("pool", "")
        moved = {"topic", "pool", "type"} & {*self.changed_data}
        proposed = not cleaned.get("key") or (moved and "key" not in self.changed_data)
        if proposed and bool(topic) != bool(pool):
            cleaned["key"] = authoring.next_key(topic, pool, cleaned.get("type", ""))
        return cleaned


class SentenceForm(LanguageForm):
    """The words in one language."""

    class Meta:
        model = models.Sentence
        fields = ("language", "text")
        widgets = {"text": forms.Textarea(attrs={"rows": 3, "class": "sentence"})}

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        if "text" in self.fields:
            self.fields["text"].widget.attrs |= {"data-language": self.code, "lang": self.code}

    def has_changed(self) -> bool:
        """Count words that were proposed (those of an inherited sentence) as written."""
        if super().has_changed():
            return True
        proposed = self.is_bound and not self.instance.pk
        return proposed and bool(str(self.data.get(self.add_prefix("text")) or "").strip())


class SentenceFormSet(OnePerLanguageFormSet):
    """The words in all languages, tried together: what cannot be said is refused at its place."""

    def clean(self) -> None:
        """Refuse words that a topic which would say them cannot say."""
        super().clean()
        frame = self.instance
        if any(self.errors) or not (frame.topic_id or frame.pool):
            return
        written = {
            form.cleaned_data["language"]: form
            for form in self.forms
            if form.cleaned_data.get("text") and not form.cleaned_data.get("DELETE")
        }
        for problem in refusals(self._as_frame(frame, written), frame.topic_id, frame.pool):
            if problem.language in written:
                written[problem.language].add_error("text", problem.message)
            else:
                raise forms.ValidationError(problem.message)

    def _as_frame(self, frame: models.Frame, written: Mapping[str, Any]) -> concepts.Frame:
        return concepts.Frame(
            number=frame.pk or -1,
            key=frame.key or "?",
            type=frame.type or frame.pool,
            texts={code: form.cleaned_data["text"] for code, form in written.items()},
            scope=frame.scope,
            do=frame.do,
        )
