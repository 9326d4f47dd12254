"""The names and keywords of a topic's line: judged, then saved."""

import copy
from collections.abc import Mapping

from django.core.exceptions import ValidationError
from django.db.models import Model
from django.utils.translation import gettext as _

from authoring.sheets.codes import read_fields, read_keywords
from authoring.sheets.columns import language_word, note_errors
from authoring.sheets.records import Record
from dialogue import models
from languages.known import LANGUAGES


def check_parts(record: Record) -> None:
    """Note what is wrong with the names and keywords that differ."""
    for code in LANGUAGES:
        word = language_word(code)
        name, forms, keywords = f"{word} name", f"{word} forms", f"{word} keywords"
        if record.new.get(forms) and not record.new.get(name):
            record.refuse(name, _("Write the name too: there are forms of it."))
        elif record.new.get(name) and record.changed(name, forms):
            _check(record, _name(record, code), {"name": name, "fields": forms})
        if record.new.get(keywords) and record.changed(keywords):
            _check(record, _keywords(record, code), {"first": keywords, "second": keywords})


def _check(record: Record, row: Model, columns: Mapping[str, str]) -> None:
    try:
        row.clean_fields(exclude=["topic"])
        row.clean()
    except (ValidationError, ValueError) as error:
        found = error if isinstance(error, ValidationError) else ValidationError(str(error))
        note_errors(record, found, columns, next(iter(columns.values())))


def _name(record: Record, code: str) -> models.TopicName:
    """Return the name of a language as the line wants it, not saved; a new one has no topic yet."""
    present: models.TopicName | None = record.parts.get("names", {}).get(code)
    word = language_word(code)
    row = copy.copy(present) if present else models.TopicName(language=code)
    row.name = record.new.get(f"{word} name", "")
    if present is None or record.changed(f"{word} forms"):
        row.fields = read_fields(record.new.get(f"{word} forms", ""))
    return row


def _keywords(record: Record, code: str) -> models.KeywordSet:
    """Return the keywords of a language as the line wants them, not saved."""
    present: models.KeywordSet | None = record.parts.get("keywords", {}).get(code)
    row = copy.copy(present) if present else models.KeywordSet(language=code)
    cell = record.new.get(f"{language_word(code)} keywords", "")
    row.first, row.second = read_keywords(cell)
    return row


def write_parts(record: Record, topic: models.Topic) -> None:
    """Save the names and keywords that differ; delete those that were emptied."""
    for code in LANGUAGES:
        word = language_word(code)
        if record.changed(f"{word} name", f"{word} forms"):
            kept = bool(record.new.get(f"{word} name"))
            _write(_name(record, code), topic, kept=kept)
        if record.changed(f"{word} keywords"):
            kept = bool(record.new.get(f"{word} keywords"))
            _write(_keywords(record, code), topic, kept=kept)


def _write(row: models.TopicName | models.KeywordSet, topic: models.Topic, *, kept: bool) -> None:
    row.topic = topic
    if kept:
        row.full_clean(exclude=["topic"])
        row.save()
    elif row.pk:
        row.delete()
