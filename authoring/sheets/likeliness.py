"""The sheet of likeliness: one line a topic, the cultures abreast."""

import copy
from collections.abc import Iterator, Mapping, Sequence

from django.core.exceptions import ValidationError
from django.utils.translation import gettext as _
from django.utils.translation import gettext_lazy

from authoring.sheets.codes import likeliness
from authoring.sheets.columns import Choice, Column, note_errors
from authoring.sheets.places import EVERYTHING, branch_choices, numbers_of
from authoring.sheets.records import Record
from authoring.sheets.sheet import Sheet
from authoring.sheets.suggesting import Suggestions
from authoring.sheets.tables import Row
from authoring.topic_page.shape import read_shape
from dialogue import models

TOPIC = "topic"


class Likeliness(Sheet):
    """How probable it is that people of each culture like a topic."""

    name = "likeliness"
    title = gettext_lazy("Likeliness")
    told = gettext_lazy("How much each culture likes a topic: numbers from 0 to 1.")
    tab = "Likeliness"
    writes = ("dialogue.topicinstance",)
    deletable = grows = False
    filters = {"branch": gettext_lazy("Branch")}

    def all_columns(self) -> Iterator[Column]:
        """Yield the topic and a column for each culture."""
        self.cultures = {one.code: one for one in models.Culture.objects.all()}
        yield Column(TOPIC, needed=True, is_name=True)
        for code in self.cultures:
            yield Column(code, likeliness)

    def choices(self, name: str) -> Iterator[Choice]:
        """Yield the branches."""
        return branch_choices()

    def rows(self, chosen: Mapping[str, str]) -> Iterator[Record]:
        """Yield the topics of a branch in the order of the tree."""
        shape = read_shape()
        numbers = numbers_of(shape, chosen.get("branch", EVERYTHING))
        parts = self._instances(numbers)
        for number in numbers:
            yield self._record(shape.keys[number], number, parts.get(number, {}))

    def _instances(self, numbers: Sequence[int]) -> dict[int, dict[str, models.TopicInstance]]:
        codes = {one.pk: code for code, one in self.cultures.items()}
        found: dict[int, dict[str, models.TopicInstance]] = {}
        rows = models.TopicInstance.objects.filter(topic_id__in=numbers)
        for one in rows.select_related("topic", "culture"):
            found.setdefault(one.topic_id, {})[codes[one.culture_id]] = one
        return found

    def _record(self, key: str, number: int, parts: Mapping[str, models.TopicInstance]) -> Record:
        old = {TOPIC: key}
        for code in self.cultures:
            old[code] = likeliness(str(parts[code].likeliness)) if code in parts else ""
        return Record(key, old, row=number, parts=dict(parts))

    def look_up(self, rows: Sequence[Row]) -> None:
        """Read the numbers of the topics in the lines."""
        self.topics = dict(models.Topic.objects.order_by().values_list("key", "pk"))
        self.nearest = Suggestions(self.topics)
        wanted = {row.texts[TOPIC].strip() for row in rows}
        numbers = {key: self.topics[key] for key in wanted if key in self.topics}
        parts = self._instances(list(numbers.values()))
        self.known = {
            key: self._record(key, number, parts.get(number, {})) for key, number in numbers.items()
        }

    def find(self, row: Mapping[str, str]) -> Record | None:
        """Return the line's topic; it must exist."""
        key = row[TOPIC].strip()
        if key in self.known:
            return self.known[key].again()
        if not key:
            raise ValidationError({TOPIC: _("Write the name of the topic.")})
        raise ValidationError(
            {TOPIC: self.nearest.told(_("There is no topic “%s”.") % key[:60], key)}
        )

    def check(self, record: Record) -> None:
        """Look at each number that differs."""
        for code in self.cultures:
            if not record.changed(code):
                continue
            if not record.new[code]:
                record.refuse(code, _("Write a number from 0 to 1, e.g. 0.7."))
                continue
            try:
                self._instance(record, code).clean_fields(exclude=["topic", "culture"])
            except ValidationError as error:
                note_errors(record, error, {"likeliness": code})

    def _instance(self, record: Record, code: str) -> models.TopicInstance:
        """Return the row of a culture with the new number, not saved."""
        present = record.parts.get(code)
        row: models.TopicInstance = (
            copy.copy(present)
            if present
            else models.TopicInstance(topic_id=record.row, culture=self.cultures[code])
        )
        row.likeliness = record.new[code]
        return row

    def write(self, record: Record) -> None:
        """Save the numbers that differ."""
        for code in self.cultures:
            if record.changed(code):
                row = self._instance(record, code)
                row.full_clean(exclude=["topic", "culture"])
                row.save()
