"""The forms of a topic's parts: names in plain words, likeliness, links."""

from typing import Any

from django import forms
from django.contrib.admin.widgets import AutocompleteSelect
from django.core.exceptions import ValidationError
from django.forms.models import BaseInlineFormSet
from django.utils.translation import gettext_lazy as _

from authoring.topic_page.name_words import (
    NAME_FIELDS,
    NAME_HELP,
    SELDOM,
    Form,
    NameField,
    forms_of,
)
from authoring.topic_page.words import LANGUAGE_NAMES, liking
from dialogue import models
from languages.known import LANGUAGES
from languages.language import FormError
from languages.name_fields import LONGEST

PREFIX = "form_"
LONGEST_DATA = 4000


class OnePerLanguageFormSet(BaseInlineFormSet):
    """One row for each language; what is missing stands there empty."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        present = {row.language for row in self.get_queryset()} if self.instance.pk else set()
        missing = [code for code in LANGUAGES if code not in present]
        self.initial_extra = self.initial_extra or [{"language": code} for code in missing]


class LanguageForm(forms.ModelForm):
    """A row of one language: the page says which, it is not chosen."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        if "language" in self.fields:
            self.fields["language"].widget = forms.HiddenInput()

    @property
    def code(self) -> str:
        """Return the language of the row as it is stored or proposed."""
        stored = self.instance.language if self.instance.pk else ""
        given = self.data.get(self.add_prefix("language")) if self.is_bound else ""
        return str(stored or given or self.initial.get("language") or "en")

    @property
    def language_name(self) -> object:
        """Return the name of the language."""
        return LANGUAGE_NAMES.get(self.code, self.code)


class NameForm(LanguageForm):
    """A name with a field for each thing its language wants to know."""

    class Meta:
        model = models.TopicName
        fields = ("language", "name", "fields")

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        if "fields" not in self.fields:
            return
        self.fields["fields"].widget = forms.HiddenInput()
        self.fields["name"].help_text = str(NAME_HELP.get(self.code, ""))
        stored = self.instance.fields if isinstance(self.instance.fields, dict) else {}
        for row in NAME_FIELDS.get(self.code, ()):
            self.fields[PREFIX + row.key] = _plain_field(row, stored.get(row.key, ""))
            self.initial[PREFIX + row.key] = stored.get(row.key, "")

    @property
    def often(self) -> list[Any]:
        """Return the fields that most names need."""
        return [self[name] for name in self._plain() if name.removeprefix(PREFIX) not in SELDOM]

    @property
    def seldom(self) -> list[Any]:
        """Return the fields for irregular names."""
        return [self[name] for name in self._plain() if name.removeprefix(PREFIX) in SELDOM]

    @property
    def seldom_used(self) -> bool:
        """Say whether one of the irregular forms is given or wrong."""
        return any(bound.value() or bound.errors for bound in self.seldom)

    def _plain(self) -> list[str]:
        return [name for name in self.fields if name.startswith(PREFIX)]

    def forms_made(self) -> tuple[Form, ...]:
        """Return the forms of the stored name; none where it has none yet."""
        if not self.instance.pk:
            return ()
        try:
            return forms_of(self.instance.language, self.instance.name, self.instance.fields)
        except (FormError, KeyError, TypeError, AttributeError):
            return ()

    def clean_fields(self) -> Any:
        """Refuse data that is too long to be a name's."""
        fields = self.cleaned_data["fields"]
        if len(str(fields)) > LONGEST_DATA:
            raise ValidationError(_("The further forms of a name are too long."))
        return fields

    def clean(self) -> dict[str, Any]:
        """Put the plain fields that were changed into the data; tell what is wrong there."""
        cleaned: dict[str, Any] = super().clean() or self.cleaned_data
        data = cleaned.get("fields")
        if not isinstance(data, dict) or not all(isinstance(text, str) for text in data.values()):
            return cleaned
        merged = dict(data)
        for name in self._plain():
            if name in self.changed_data:
                merged[name.removeprefix(PREFIX)] = cleaned.get(name, "")
        cleaned["fields"] = {key: text for key, text in merged.items() if text or key in data}
        for name in self._plain():
            key = name.removeprefix(PREFIX)
            if name in self.changed_data and not cleaned["fields"].get(key, "x"):
                del cleaned["fields"][key]
        return cleaned

    def _update_errors(self, errors: ValidationError) -> None:
        """Show what is wrong with a further form at its own field."""
        super()._update_errors(errors)  # type: ignore[misc]
        for error in self.errors.as_data().get("fields", []):
            key = str(error.messages[0]).partition(":")[0]
            if PREFIX + key in self.fields:
                del self.errors["fields"]
                self.add_error(PREFIX + key, error)
                return


def _plain_field(row: NameField, stored: str) -> forms.Field:
    words: dict[str, Any] = {"required": False, "label": row.label, "help_text": row.told}
    if not row.choices:
        return forms.CharField(max_length=LONGEST, **words)
    usual = str(row.choices[0][1])
    # A choice that means the same as saying nothing is only offered where it is stored.
    offered = [
        (key, word) for key, word in row.choices if key in ("", stored) or str(word) != usual
    ]
    return forms.ChoiceField(choices=offered, **words)


class KeywordForm(LanguageForm):
    """Two sets of words in one language."""

    class Meta:
        model = models.KeywordSet
        fields = ("language", "first", "second")
        widgets = {
            "first": forms.Textarea(attrs={"rows": 3}),
            "second": forms.Textarea(attrs={"rows": 2}),
        }


class LikelinessForm(forms.ModelForm):
    """The likeliness in one culture: a number, a slider beside it, and words."""

    class Meta:
        model = models.TopicInstance
        fields = ("culture", "likeliness")
        widgets = {"culture": forms.HiddenInput()}

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        if "likeliness" in self.fields:
            numbers = {"min": 0, "max": 1, "step": 0.05, "class": "likeliness"}
            self.fields["likeliness"].widget.attrs |= numbers

    @property
    def liking(self) -> object:
        """Return the stored likeliness in words."""
        value = self.instance.likeliness
        return liking(float(value)) if value is not None else ""


class KnownAutocomplete(AutocompleteSelect):
    """A search field that knows the topic it shows, so that it need not be looked up."""

    known: models.Topic | None = None

    def optgroups(self, name: str, value: Any, attrs: Any = None) -> Any:
        """Return the chosen topic as the only option."""
        if self.known is None or [str(one) for one in value] != [str(self.known.pk)]:
            return super().optgroups(name, value, attrs)
        option = self.create_option(name, self.known.pk, str(self.known), selected=True, index=0)
        return [(None, [option], 0)]


def knows(field: Any, topic: models.Topic | None) -> None:
    """Tell a search field of topics which one it shows."""
    widget = getattr(field.widget, "widget", field.widget)
    if topic is not None and isinstance(widget, KnownAutocomplete):
        widget.known = topic


class LinkForm(forms.ModelForm):
    """A link to another topic."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        if "target" in self.fields and self.instance.target_id:
            knows(self.fields["target"], self.instance.target)


_TOPIC_LABELS = {
    "parent": _("Topic above it"),
    "home": _("Home culture"),
    "gentle": _("Gentle subject"),
    "also": _("Borrows sentences of"),
    "pattern": _("Order of sentences"),
    "stop": _("Inherits no sentences of"),
}


class TopicForm(forms.ModelForm):
    """The topic itself."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        for name, label in _TOPIC_LABELS.items():
            if name in self.fields:
                self.fields[name].label = label
        if "parent" in self.fields and self.instance.parent_id:
            knows(self.fields["parent"], self.instance.parent)
