"""The one way by which a sheet is written into the draft."""

import hashlib
import json
from collections.abc import Iterable, Sequence

from django.core.exceptions import ValidationError
from django.db import DatabaseError, transaction
from django.utils.translation import gettext as _

from authoring.sheets.columns import note_errors
from authoring.sheets.records import SAME, WRONG, Record
from authoring.sheets.sheet import Sheet
from authoring.sheets.tables import Table
from dialogue.models import DraftVersion


class NotAsShownError(ValueError):
    """The draft is not what the preview showed; `records` is what the sheet would change now."""

    def __init__(self, message: str, records: Sequence[Record]) -> None:
        super().__init__(message)
        self.records = records


class CannotSaveError(ValueError):
    """A row was refused while it was written; nothing was saved."""


def changing(records: Iterable[Record]) -> list[Record]:
    """Return the records that change the draft."""
    return [record for record in records if record.kind not in (SAME, WRONG)]


def seen(records: Iterable[Record]) -> str:
    """Return what the draft says about these lines as 64 letters, equal for equal texts."""
    said = [[one.number, one.key if one.old else "", one.old] for one in records]
    text = json.dumps(said, ensure_ascii=True, sort_keys=True)
    return hashlib.sha256(text.encode("ascii")).hexdigest()


@transaction.atomic
def save(sheet: Sheet, table: Table, shown: str) -> list[Record]:
    """Write what a table changes, all or nothing, row by row as forms do; return the records.

    `shown` is what `seen` gave for these lines when they were shown. Raises NotAsShownError where
    the draft says something else by now, CannotSaveError where a row is refused at the last.
    """
    # Whoever changes the draft touches this row, so nobody comes between looking and writing.
    DraftVersion.objects.select_for_update().get_or_create(pk=1)
    records = sheet.judge(table)
    if seen(records) != shown or any(one.kind == WRONG for one in records):
        words = _("The draft has changed meanwhile, so nothing was saved. Look again.")
        raise NotAsShownError(words, records)
    for record in sheet.in_order(changing(records)):
        _write(sheet, record)
    return records


def _write(sheet: Sheet, record: Record) -> None:
    try:
        with transaction.atomic():
            sheet.write(record)
    except ValidationError as error:
        told = Record(record.key)
        note_errors(told, error)
        raise CannotSaveError(_refused(record, told.problems[0].message)) from error
    except DatabaseError as error:
        raise CannotSaveError(_refused(record, _("the database refuses it."))) from error


def _refused(record: Record, why: str) -> str:
    words = _("Line %(line)d (%(key)s) cannot be saved, so nothing was: %(why)s")
    return words % {"line": record.number, "key": record.key or "–", "why": why}
