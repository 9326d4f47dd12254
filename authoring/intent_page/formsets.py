"""The rows of an intent's parts together: their places, and what one row cannot know alone."""

from collections.abc import Callable
from functools import partial
from typing import Any

from django.core.exceptions import ValidationError
from django.forms.models import BaseInlineFormSet

from authoring.intent_page.faults import action_fault, readable_phrases, trigger_fault, undeclared
from authoring.intent_page.forms import RowForm
from authoring.intent_page.posted import posted_slots
from authoring.intent_page.quick_widgets import quicken
from authoring.intent_page.widgets import CultureBoxes, OpenSelect
from authoring.intent_page.wordings import EXAMPLES
from languages.known import LANGUAGES
from plans.engine.actions import ACTIONS_BY_NAME
from plans.engine.intents import ActionItem, Slot
from plans.engine.kb_actions import KB_ACTIONS_BY_NAME


class RowFormSet(BaseInlineFormSet):  # type: ignore[type-arg]
    """Rows of a part; an emptied row is deleted, a new one comes last unless it has a place."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        self._known: dict[Callable[[], Any], list[Any]] = {}
        super().__init__(*args, **kwargs)

    def add_fields(self, form: Any, index: Any) -> None:
        """Let all rows share their choices: they are read once."""
        super().add_fields(form, index)
        quicken(form.fields)
        for field in form.fields.values():
            if isinstance(field.widget, CultureBoxes):
                field.widget.choices = partial(self._once, field.widget.choices)
            elif isinstance(field.widget, OpenSelect):
                field.widget.open_choices = partial(self._once, field.widget.open_choices)

    def _once(self, choices: Callable[[], Any]) -> list[Any]:
        if choices not in self._known:
            self._known[choices] = list(choices())
        return self._known[choices]

    def _should_delete_form(self, form: Any) -> bool:
        emptied = form.is_bound and not form.instance._state.adding and form.blank()
        return bool(emptied or super()._should_delete_form(form))  # type: ignore[misc]

    def clean(self) -> None:
        """Give places to new rows; then look at each row."""
        super().clean()
        last: dict[str, int] = {}
        rows: list[Any] = [form for form in self.forms if hasattr(form, "cleaned_data")]
        for form in rows:
            code = form.cleaned_data.get("language", "")
            place = form.cleaned_data.get("position")
            last[code] = max(last.get(code, -1), -1 if place is None else place)
        slots = self.declared()
        for form in rows:
            if not form.has_changed() or self._should_delete_form(form):
                continue
            if form.cleaned_data.get("position") is None:
                code = form.cleaned_data.get("language", "")
                last[code] += 1
                form.cleaned_data["position"] = form.instance.position = last[code]
        for form in rows:  # Places are given first.
            if not form.blank() and not self._should_delete_form(form):
                self.look_at(form, slots)

    def declared(self) -> list[Slot]:
        """Return the parameters of the intent as the same form declares them."""
        if "slots-TOTAL_FORMS" in self.data:
            return list(posted_slots(self.data))
        rows = self.instance.slots.all() if self.instance.pk else ()
        return [Slot(name=row.name, kind=row.kind, required=row.required) for row in rows]

    def look_at(self, form: Any, slots: list[Slot]) -> None:
        """Refuse what is wrong in one row."""

    def by_language(self) -> list[dict[str, Any]]:
        """Return the rows in a group for each language, in their order."""
        groups: dict[str, list[Any]] = {code: [] for code in LANGUAGES}
        for form in self.forms:
            groups.setdefault(str(form["language"].value() or "en"), []).append(form)
        return [
            {
                "code": code,
                "name": LANGUAGES[code].own_name if code in LANGUAGES else code,
                "forms": sorted(rows, key=RowForm.place),
                "example": EXAMPLES.get((str(self.prefix), code), ""),
            }
            for code, rows in groups.items()
        ]


class TriggerFormSet(RowFormSet):
    def clean(self) -> None:
        """Check the sentences; the phrases are read once."""
        self.phrases = readable_phrases()
        super().clean()

    def look_at(self, form: Any, slots: list[Slot]) -> None:
        """Refuse a pattern that cannot be read or breaks a rule, with the place."""
        text, code = form.cleaned_data.get("text"), form.cleaned_data.get("language", "")
        fault = trigger_fault(text, slots, self.phrases.get(code, {})) if text else None
        if fault:
            _refuse(form, "text", *fault)


class PlanSentenceFormSet(RowFormSet):
    def look_at(self, form: Any, slots: list[Slot]) -> None:
        """Refuse a parameter that is not declared."""
        fault = undeclared(form.cleaned_data.get("text") or "", slots)
        if fault:
            _refuse(form, "text", *fault)


class ActionFormSet(RowFormSet):
    def look_at(self, form: Any, slots: list[Slot]) -> None:
        """Refuse an action or a parameter that does not exist."""
        action, pairs = form.cleaned_data.get("action"), form.cleaned_data.get("parameters")
        if not action or form.errors:
            return
        kept = self._kept(form, pairs or [])
        form.instance.parameters = form.cleaned_data["parameters"] = kept
        item = ActionItem(action=action, parameters=tuple((name, text) for name, text in kept))
        message = action_fault(item, slots, form.client)
        if message:
            _refuse(form, "action", message, -1)

    @staticmethod
    def _kept(form: Any, pairs: list[list[str]]) -> list[list[str]]:
        """Drop values of another action that was chosen before; a script removes them itself."""
        if "action" not in form.changed_data:
            return pairs
        if form.client:
            known = ACTIONS_BY_NAME.get(form.cleaned_data["action"])
            names = [one.name for one in known.parameters] if known else []
        else:
            talk = KB_ACTIONS_BY_NAME.get(form.cleaned_data["action"])
            names = list(talk.parameters) if talk else []
        return [pair for pair in pairs if pair[0] in names]


def _refuse(form: Any, field: str, message: str, position: int) -> None:
    form.positions = {**getattr(form, "positions", {}), field: position}
    if field not in form.errors:
        form.add_error(field, ValidationError(message))
