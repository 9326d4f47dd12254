"""The sheets of intents: trigger sentences, plan sentences, stored tests; one line each."""

from collections.abc import Iterator, Sequence
from typing import Any

from django.utils.translation import gettext as _
from django.utils.translation import gettext_lazy

from authoring.intent_page.faults import trigger_fault, undeclared
from authoring.sheets.codes import culture_codes, fields_text, name_fields, read_fields
from authoring.sheets.columns import Column
from authoring.sheets.intent_lines import IntentLines
from authoring.sheets.records import Record
from authoring.sheets.suggesting import listed
from plans import models
from plans.engine.intents import Slot

MUST_NOT = "no"


class Triggers(IntentLines):
    """Trigger sentences."""

    name, tab, text, field = "triggers", "Triggers", "trigger", "text"
    title = gettext_lazy("Trigger sentences")
    told = gettext_lazy("What people say when they want something: one line a pattern.")
    writes = ("plans.trigger",)
    model = models.Trigger

    def check_row(self, record: Record, row: Any, slots: Sequence[Slot]) -> None:
        """Refuse a pattern that cannot be read or breaks a rule; tell of the same elsewhere."""
        phrases = self.phrases.get(row.language, {})
        self.told_places(record, trigger_fault(row.text, slots, phrases) if row.text else None)
        for intent in self.intents:
            if intent != row.intent.key and (intent, row.language, row.text) in self.same:
                words = _("%s has the same sentence. Only one of the two can win.")
                record.note = words % intent


class PlanSentences(IntentLines):
    """What the robot says before it does something."""

    name, tab, text, field = "plan_sentences", "Plan sentences", "sentence", "text"
    title = gettext_lazy("Plan sentences")
    told = gettext_lazy("What the robot says before it does what somebody asked for.")
    writes = ("plans.plansentence",)
    model = models.PlanSentence

    def more_columns(self) -> Iterator[Column]:
        """Yield the cultures."""
        yield Column("cultures", culture_codes)

    def more_texts(self, row: Any) -> dict[str, str]:
        """Return the cultures."""
        return {"cultures": row.only}

    def check_row(self, record: Record, row: Any, slots: Sequence[Slot]) -> None:
        """Refuse parameters and cultures that do not exist."""
        row.only = (
            record.row.only
            if record.row and not record.changed("cultures")
            else record.new.get("cultures", "")
        )
        self.told_places(record, undeclared(row.text, slots))
        for code in record.new.get("cultures", "").split():
            if code not in self.cultures:
                words = _("There is no culture %(code)s. Use: %(known)s.")
                known = listed(self.cultures)
                record.refuse("cultures", words % {"code": code[:20], "known": known})


class Tests(IntentLines):
    """Stored tests."""

    name, tab, text, field = "tests", "Tests", "sentence", "sentence"
    title = gettext_lazy("Stored tests")
    told = gettext_lazy("Sentences that must, or must not, be understood as an intent.")
    writes = ("plans.intenttest",)
    model = models.IntentTest

    def more_columns(self) -> Iterator[Column]:
        """Yield what is expected."""
        yield Column("expected", _expected)

    def more_texts(self, row: Any) -> dict[str, str]:
        """Return what is expected."""
        return {"expected": MUST_NOT if row.parameters is None else fields_text(row.parameters)}

    def check_row(self, record: Record, row: Any, slots: Sequence[Slot]) -> None:
        """Take over what is expected."""
        text = record.new.get("expected", "")
        if record.row and not record.changed("expected"):
            row.parameters = record.row.parameters
        else:
            row.parameters = None if text == MUST_NOT else read_fields(text)
        missing = sorted(set(row.parameters or ()) - {slot.name for slot in slots})
        if missing:
            words = _("The intent has no parameter %s, so the test cannot pass.")
            record.note = words % missing[0]


def _expected(text: str) -> str:
    word = text.strip()
    return MUST_NOT if word.casefold() == MUST_NOT else name_fields(word)
