"""The parts of an intent on its page: parameters, sentences, actions, tests."""

from typing import Any

from django.contrib import admin
from django.http import HttpRequest

from authoring.intent_page import forms, formsets
from languages.known import LANGUAGES
from plans import models

#: How many empty lines a page offers for each language: of a new intent, of one that is there.
_TRIGGERS, _SENTENCES, _TESTS = (5, 1), (2, 1), (3, 1)


class PartInline(admin.TabularInline):
    """A part of an intent: rows without a language, one spare."""

    formset = formsets.RowFormSet
    template = "admin/plans/intent/plan.html"

    def spare(self, new: bool) -> list[dict[str, Any]]:
        """Return what the spare rows begin with."""
        return [{"position": None}]

    def get_extra(self, request: HttpRequest, obj: Any = None, **kwargs: Any) -> int:
        return len(self.spare(obj is None))


class SpokenInline(PartInline):
    """A part with lines in each language."""

    lines = (3, 1)

    def spare(self, new: bool) -> list[dict[str, Any]]:
        """Return some empty lines for each language."""
        number = self.lines[0 if new else 1]
        return [{"language": code, "position": None} for code in LANGUAGES for _ in range(number)]


class SlotInline(PartInline):
    model = models.Slot
    form = forms.SlotForm
    template = "admin/plans/intent/slots.html"


class TriggerInline(SpokenInline):
    model = models.Trigger
    form = forms.TriggerForm
    formset = formsets.TriggerFormSet
    template = "admin/plans/intent/triggers.html"
    lines = _TRIGGERS


class PlanSentenceInline(SpokenInline):
    model = models.PlanSentence
    form = forms.PlanSentenceForm
    formset = formsets.PlanSentenceFormSet
    template = "admin/plans/intent/plan_sentences.html"
    lines = _SENTENCES


class PlanActionInline(PartInline):
    model = models.PlanAction
    form = forms.PlanActionForm
    formset = formsets.ActionFormSet


class KBPlanActionInline(PartInline):
    model = models.KBPlanAction
    form = forms.KBPlanActionForm
    formset = formsets.ActionFormSet


class IntentTestInline(SpokenInline):
    model = models.IntentTest
    form = forms.IntentTestForm
    template = "admin/plans/intent/tests.html"
    lines = _TESTS

    def spare(self, new: bool) -> list[dict[str, Any]]:
        """Return empty lines; the last of a new intent must not match."""
        rows = super().spare(new)
        for place, row in enumerate(rows):
            row["parameters"] = None if new and place % _TESTS[0] == _TESTS[0] - 1 else {}
        return rows


PARTS = (
    SlotInline,
    TriggerInline,
    PlanSentenceInline,
    PlanActionInline,
    KBPlanActionInline,
    IntentTestInline,
)
