"""What the sheets of intents share: a line for each trigger, plan sentence or test."""

import hashlib
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, ClassVar

from django.core.exceptions import ValidationError
from django.utils.translation import gettext as _
from django.utils.translation import gettext_lazy

from authoring.intent_page.faults import readable_phrases
from authoring.sheets.codes import (
    language_code,
)
from authoring.sheets.columns import KEY, Choice, Column, note_errors
from authoring.sheets.places import EVERYTHING, language_choices
from authoring.sheets.records import Record
from authoring.sheets.sheet import Sheet
from authoring.sheets.suggesting import Suggestions, listed
from authoring.sheets.tables import Row
from dialogue.models import Culture
from languages.known import LANGUAGES
from plans import models
from plans.engine.intents import Slot

INTENT, LANGUAGE = "intent", "language"


class IntentLines(Sheet):
    """Lines of intents, each known by a name that its text gives it.

    Changed by somebody else meanwhile, it is another line, and nothing is overwritten.
    """

    model: ClassVar[type[Any]]
    #: The column of the text, and the field it is.
    text: ClassVar[str]
    field: ClassVar[str]
    filters = {"family": gettext_lazy("Family"), "language": gettext_lazy("Language")}

    def all_columns(self) -> Iterator[Column]:
        """Yield the columns."""
        yield Column(KEY, is_name=True)
        yield Column(INTENT, needed=True)
        yield Column(LANGUAGE, language_code, needed=True)
        yield Column(self.text, needed=True)
        yield from self.more_columns()

    def more_columns(self) -> Iterator[Column]:
        """Yield the columns that only this sheet has."""
        yield from ()

    def more_texts(self, row: Any) -> dict[str, str]:
        """Return their texts."""
        return {}

    def check_row(self, record: Record, row: Any, slots: Sequence[Slot]) -> None:
        """Note what is wrong, and give the row what only this sheet has."""

    def choices(self, name: str) -> Iterator[Choice]:
        """Yield what a filter offers."""
        if name == "language":
            yield from language_choices()
            return
        yield Choice(EVERYTHING, _("All families"))
        families = models.Intent.objects.exclude(family="").order_by("family")
        for family in families.values_list("family", flat=True).distinct():
            yield Choice(family, family)

    def rows(self, chosen: Mapping[str, str]) -> Iterator[Record]:
        """Yield the lines of a family and a language, intent by intent."""
        family, language = chosen.get("family", ""), chosen.get("language", "")
        for record in self._all():
            row = record.row
            right = family in ("", row.intent.family) and language in ("", row.language)
            if right:
                yield record

    def _all(self) -> list[Record]:
        order = {code: place for place, code in enumerate(LANGUAGES)}
        found = self.model._default_manager.select_related("intent")
        rows = sorted(
            found,
            key=lambda one: (
                one.intent.position,
                one.intent.key,
                order.get(one.language, 99),
                one.position,
                one.pk,
            ),
        )
        times: dict[str, int] = {}
        return [self._record(row, times) for row in rows]

    def _record(self, row: Any, times: dict[str, int]) -> Record:
        text = getattr(row, self.field)
        key = f"{row.intent.key}.{row.language}.{_short(text)}"
        times[key] = times.get(key, 0) + 1
        if times[key] > 1:
            key = f"{key}-{times[key]}"
        texts = {KEY: key, INTENT: row.intent.key, LANGUAGE: row.language, self.text: text}
        texts |= self.more_texts(row)
        old = {one.name: one.stored(texts[one.name]) for one in self.columns}
        return Record(key, old, row=row)

    def headers(self, language: str = "") -> tuple[str, ...]:
        """Return all headers: a language is a filter of lines here."""
        return super().headers()

    def look_up(self, rows: Sequence[Row]) -> None:
        """Read all lines, the intents with their parameters, and the phrases."""
        records = self._all()
        self.known = {record.key: record for record in records}
        self.same: dict[tuple[str, str, str], Record] = {}
        self.places: dict[tuple[str, str], int] = {}
        for record in records:
            row = record.row
            self.same.setdefault(
                (row.intent.key, row.language, (record.old or {})[self.text]), record
            )
            place = (row.intent.key, row.language)
            self.places[place] = max(self.places.get(place, -1), row.position)
        self.intents = {one.key: one for one in models.Intent.objects.all()}
        self.nearest = Suggestions(self.intents)
        self.phrases = readable_phrases()
        self.cultures = list(Culture.objects.values_list("code", flat=True))
        self.slots: dict[int, list[Slot]] = {}
        for one in models.Slot.objects.all():
            slot = Slot(name=one.name, kind=one.kind, required=one.required)
            self.slots.setdefault(one.intent_id, []).append(slot)

    def find(self, row: Mapping[str, str]) -> Record | None:
        """Return the line of this name; of one without a name, the line that says the same."""
        key = row.get(KEY, "").strip()
        if not key:
            same = (row[INTENT].strip(), language_code(row[LANGUAGE]), row[self.text].strip())
            found = self.same.get(same)
            return found.again() if found else None
        if key not in self.known:
            words = _("It is not there any more: changed or deleted meanwhile. Take the sheet out")
            rest = _("again, or empty this cell to add the line as a new one.")
            raise ValidationError({KEY: f"{words} {rest}"})
        return self.known[key].again()

    def begin(self, row: Mapping[str, str]) -> Record:
        """Return a new line; it gets its name once it is there."""
        return Record("")

    def check(self, record: Record) -> None:
        """Look at one line."""
        if record.delete:
            return
        new = record.new
        if record.old and record.changed(INTENT, LANGUAGE):
            words = _("It keeps its intent and language. Add a new line without key, delete this.")
            record.refuse(INTENT if record.changed(INTENT) else LANGUAGE, words)
        intent = self.intents.get(new[INTENT])
        if intent is None:
            words = _("There is no intent “%s”.") % new[INTENT][:60]
            record.refuse(INTENT, self.nearest.told(words, new[INTENT]))
        if new[LANGUAGE] not in LANGUAGES:
            words = _("There is no language “%(code)s”. Use: %(known)s.")
            known = listed(tuple(LANGUAGES))
            record.refuse(LANGUAGE, words % {"code": new[LANGUAGE][:20], "known": known})
        if intent is not None and not record.problems:
            self._check_row(record, intent)

    def _check_row(self, record: Record, intent: models.Intent) -> None:
        present = record.row
        row = self.model(pk=present.pk if present else None, intent=intent)
        row._state.adding = present is None
        row.language, row.position = record.new[LANGUAGE], present.position if present else 0
        setattr(row, self.field, record.new[self.text])
        self.check_row(record, row, self.slots.get(intent.pk, ()))
        names = {self.field: self.text, "only": "cultures", "parameters": "expected"}
        told = [name for name, column in names.items() if _told(record, column)]
        try:
            row.clean_fields(exclude=["intent", *told])
        except ValidationError as error:
            note_errors(record, error, names)
        record.parts["row"] = row

    def check_together(self, records: Sequence[Record]) -> None:
        """Refuse a line that is added twice."""
        first: dict[tuple[str, ...], int] = {}
        for record in records:
            same = (record.new[INTENT], record.new[LANGUAGE], record.new[self.text])
            if record.old is None and same in first:
                words = _("The same stands in line %d already. Remove one of the two.")
                record.refuse(self.text, words % first[same])
            if record.old is None:
                first.setdefault(same, record.number)

    def write(self, record: Record) -> None:
        """Save or delete the line."""
        if record.delete:
            record.row.delete()
            return
        row = record.parts["row"]
        if row.pk is None:
            place = (record.new[INTENT], record.new[LANGUAGE])
            self.places[place] = row.position = self.places.get(place, -1) + 1
        row.full_clean(exclude=["intent"])
        row.save()

    def told_places(self, record: Record, fault: tuple[str, int] | None) -> None:
        """Note a fault of the text with its place."""
        if fault:
            message, position = fault
            where = _(" (at letter %d)") % (position + 1) if position >= 0 else ""
            record.refuse(self.text, f"{message}{where}")


def _told(record: Record, column: str) -> bool:
    return any(one.column == column for one in record.problems)


def _short(text: str) -> str:
    return hashlib.sha256(text.encode("utf-8", "surrogatepass")).hexdigest()[:6]
