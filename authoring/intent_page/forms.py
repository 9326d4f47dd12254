"""The forms of an intent and its parts: plain inputs, every fault at its line."""

from typing import Any

from django import forms
from django.utils.html import format_html_join
from django.utils.safestring import SafeString
from django.utils.translation import gettext
from django.utils.translation import gettext_lazy as _

from authoring.intent_page.quick_widgets import filled
from authoring.intent_page.widgets import (
    FOLDER,
    CultureBoxes,
    Expected,
    LanguageTexts,
    OneLine,
    OpenSelect,
    Parameters,
    PriorityChoice,
)
from authoring.intent_page.wordings import ABILITIES, KINDS, QUESTIONS
from authoring.topic_page.words import in_own_language
from dialogue.models import Culture
from plans import models
from plans.engine.actions import ACTIONS
from plans.engine.intents import VALUE_KIND
from plans.engine.kb_actions import KB_ACTIONS
from plans.engine.patterns import PatternError, parse_pattern


def cultures() -> list[tuple[str, str]]:
    """Return the cultures of the draft: code and name."""
    rows = Culture.objects.values_list("code", "names")
    return [(code, in_own_language(names, code)) for code, names in rows]


def kinds() -> list[Any]:
    """Return the kinds of parameters, the value lists in a group of their own."""
    keys = models.ValueList.objects.values_list("key", flat=True)
    return [*KINDS.items(), (_("One of a value list"), [(VALUE_KIND + key, key) for key in keys])]


def client_actions() -> list[tuple[str, str]]:
    """Return what robots can be asked to do, after "none"."""
    nothing = ("", str(_("— none: the robot only says its sentence —")))
    return [nothing, *((one.name, f"{one.name}: {gettext(one.meaning)}") for one in ACTIONS)]


def talk_actions() -> list[tuple[str, str]]:
    """Return what a plan can do to the talk, after "none"."""
    return [("", "—"), *((one.name, f"{one.name}: {gettext(one.meaning)}") for one in KB_ACTIONS)]


class KeyField(forms.CharField):
    """A name of one word; blanks and capitals are mended."""

    def to_python(self, value: Any) -> Any:
        """Return "water_the_plants" for "Water the plants"."""
        text = super().to_python(value)
        return "_".join(text.lower().split()) if isinstance(text, str) else text


class IntentForm(forms.ModelForm):  # type: ignore[type-arg]
    """What the intent is, without its parts."""

    key = KeyField(
        label=_("Name"),
        max_length=60,
        validators=models.Intent._meta.get_field("key").validators,
        help_text=_("A short name in English for colleagues. Example: water_plants"),
    )

    class Meta:
        model = models.Intent
        fields = ("key", "family", "priority", "abilities", "note", "position")
        widgets = {
            "family": forms.TextInput(attrs={"list": "families", "autocomplete": "off"}),
            "priority": PriorityChoice(),
            "abilities": LanguageTexts(ABILITIES),
            "note": forms.Textarea(attrs={"rows": 2}),
            "position": forms.HiddenInput(),
        }
        labels = {"abilities": _("What the robot can do"), "note": _("Note for colleagues")}
        help_texts = {
            "family": _("A group of intents that belong together. Example: household"),
            "priority": _("Where two intents fit a sentence, the higher priority wins."),
            "abilities": _(
                "The words after “I can”, for when somebody asks what the robot can do. "
                "Leave it empty for mere talk."
            ),
            "note": _("What it is for, in one sentence."),
        }


class RowForm(forms.ModelForm):  # type: ignore[type-arg]
    """One row of a part; a new row without its text is no row at all."""

    text_field = "text"
    position = forms.IntegerField(required=False, min_value=0, widget=forms.HiddenInput)

    def blank(self) -> bool:
        """Say whether nothing is written in the row."""
        return not str(self[self.text_field].value() or "").strip()

    def has_changed(self) -> bool:
        """Say whether there is something to save."""
        return bool(super().has_changed() and not (self.instance._state.adding and self.blank()))

    @property
    def tools(self) -> SafeString:
        """Return the buttons of the row, and the box that removes it."""
        return filled(f"{FOLDER}/tools.html", {"delete": self._inputs("DELETE")})

    @property
    def hidden_inputs(self) -> SafeString:
        """Return what the row sends unseen: its number, its language, its place."""
        return self._inputs("id", "language", "position")

    def _inputs(self, *names: str) -> SafeString:
        """Return inputs with their values, without what visible fields need besides."""
        fields = [self[name] for name in names if name in self.fields]
        return format_html_join(
            "",
            "{}",
            (
                (one.field.widget.render(one.html_name, one.value(), {"id": one.auto_id}),)
                for one in fields
            ),
        )

    @property
    def echo(self) -> tuple[str, str, str] | None:
        """Return the text cut at its fault: before, the sign at fault, after; None: no place."""
        text = str(self[self.text_field].value() or "")
        position = self.fault_position(text)
        if not 0 <= position <= len(text):
            return None
        return text[:position], text[position : position + 1] or " ", text[position + 1 :]

    def fault_position(self, text: str) -> int:
        """Return at which character the text is refused, -1 where that is not known."""
        return int(getattr(self, "positions", {}).get(self.text_field, -1))

    def place(self) -> tuple[bool, int]:
        """Return what sorts rows: rows without a place come last."""
        value = str(self["position"].value() if self["position"].value() is not None else "")
        return (not value.isdecimal(), int(value) if value.isdecimal() else 0)


class SlotForm(RowForm):
    text_field = "name"

    class Meta:
        model = models.Slot
        fields = ("name", "kind", "required", "questions", "position")
        widgets = {"kind": OpenSelect(kinds), "questions": LanguageTexts(QUESTIONS)}


class TriggerForm(RowForm):
    class Meta:
        model = models.Trigger
        fields = ("language", "text", "position")
        widgets = {"language": forms.HiddenInput(), "text": OneLine()}

    def fault_position(self, text: str) -> int:
        """Return the place that the grammar names, or that of the broken rule."""
        try:
            parse_pattern(text)
        except PatternError as error:
            return error.position
        return super().fault_position(text)


class PlanSentenceForm(RowForm):
    class Meta:
        model = models.PlanSentence
        fields = ("language", "text", "only", "position")
        widgets = {
            "language": forms.HiddenInput(),
            "text": OneLine(),
            "only": CultureBoxes(cultures),
        }

    def has_changed(self) -> bool:
        """Say whether there is something to save; the order of cultures means nothing."""
        return super().has_changed() and self.changed_data != []

    @property
    def changed_data(self) -> list[str]:
        """Return the fields that say something else than before."""
        found: list[str] = super().changed_data
        before, now = str(self.initial.get("only") or ""), str(self["only"].value() or "")
        same = sorted(before.split()) == sorted(now.split())
        return [name for name in found if not (name == "only" and same)]


class PlanActionForm(RowForm):
    text_field = "action"
    client = True

    class Meta:
        model = models.PlanAction
        fields = ("action", "parameters", "position")
        widgets = {"action": OpenSelect(client_actions), "parameters": Parameters()}


class KBPlanActionForm(RowForm):
    text_field = "action"
    client = False

    class Meta:
        model = models.KBPlanAction
        fields = ("action", "parameters", "position")
        widgets = {"action": OpenSelect(talk_actions), "parameters": Parameters()}


class IntentTestForm(RowForm):
    text_field = "sentence"

    class Meta:
        model = models.IntentTest
        fields = ("language", "sentence", "parameters", "position")
        widgets = {
            "language": forms.HiddenInput(),
            "sentence": OneLine(),
            "parameters": Expected(),
        }
