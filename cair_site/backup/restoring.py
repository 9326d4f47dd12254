"""A backup brought back: all of it in one transaction, or nothing."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from itertools import groupby
from typing import IO, cast

from django.contrib.auth import get_user_model
from django.db import connection, transaction
from django.db.models import Model

from authoring.models import CheckRun, PublishRun
from cair_site.backup.file import LARGEST, BackupError, Header, Reader, Row
from cair_site.backup.tables import Reading, fields, header, tables
from dialogue.bulk import note_about_draft
from dialogue.models import DraftVersion, Publication
from ontology_io.models import ImportRun
from ontology_io.numbering import last_number, set_last_number

#: Rows are written so many at a time, and fewer where they are long.
ROWS, BYTES = 500, 2**22


class NotEmptyError(BackupError):
    """The database has content."""


@dataclass(frozen=True)
class _Before:
    """What was there: the numbers given, the version of the draft, the newest release."""

    numbers: Mapping[str, int]
    draft: int
    release: tuple[int, str] | None


def restore(file: IO[bytes], *, replace: bool = False, largest: int = LARGEST) -> dict[str, int]:
    """Bring a backup into the database; return how many rows each table got.

    Raises NotEmptyError where there is content that is not to be replaced, BackupError, and
    DatabaseError; then nothing has changed. Numbers once given here are never given again.
    """
    reader = Reader(file, largest)
    told = reader.header()
    _refuse_other_tables(told)
    with transaction.atomic():
        _keep_writers_out()
        before = _before()
        _empty(replace=replace)
        counts = _insert(reader.rows())
        _raise_numbers(before.numbers, told)
        _tell_of_it(before)
        connection.check_constraints()
    return counts


def _refuse_other_tables(told: Header) -> None:
    here = header()
    for app in sorted({*here.migrations, *told.migrations}):
        if set(here.migrations.get(app, ())) != set(told.migrations.get(app, ())):
            raise BackupError(
                f"The backup was made by a version whose tables of {app} were others "
                f"({_last(told, app)} there, {_last(here, app)} here). Restore it with that "
                "version into an empty database, then migrate."
            )
    known = {label: table.fields for label, table in here.tables.items()}
    if known != {label: table.fields for label, table in told.tables.items()}:
        raise BackupError("The tables of the backup are others than those here.")


def _last(told: Header, app: str) -> str:
    return max(told.migrations.get(app, ()), default="none")


def _keep_writers_out() -> None:
    """Have others wait who would write meanwhile; robots and readers go on."""
    if connection.vendor != "postgresql":
        return  # SQLite has one writer at a time.
    names = ", ".join(_quoted(model._meta.db_table) for model in tables().values())
    with connection.cursor() as cursor:
        cursor.execute("SET LOCAL statement_timeout = 0")
        cursor.execute(f"LOCK TABLE {names} IN SHARE ROW EXCLUSIVE MODE")


def _before() -> _Before:
    numbers = {label: last_number(model) for label, model in tables().items()}
    draft = DraftVersion.objects.values_list("number", flat=True).first() or 0
    return _Before(numbers, draft, Publication.objects.values_list("pk", "checksum").first())


def _empty(*, replace: bool) -> None:
    """Empty the tables, also of what was found out about the content that was there."""
    for label, model in tables().items():
        if model is not DraftVersion and not replace and model._base_manager.exists():
            raise NotEmptyError(f"There is content already, e.g. {label}: see --replace.")
    for found in (CheckRun, PublishRun, ImportRun):
        found._base_manager.all().delete()
    with connection.cursor() as cursor:
        for model in tables().values():
            cursor.execute(f"DELETE FROM {_quoted(model._meta.db_table)}")  # noqa: S608 - ours


def _insert(rows: Iterable[Row]) -> dict[str, int]:
    people = dict(get_user_model()._default_manager.values_list("username", "pk"))
    known, counts = tables(), dict.fromkeys(tables(), 0)
    for label, group in groupby(rows, key=lambda row: str(row[0])):
        if label not in known:
            raise BackupError(f"There is no table {label[:100]!r}.")
        counts[label] += _insert_into(known[label], map(Reading(known[label], people), group))
    return counts


def _insert_into(model: type[Model], rows: Iterable[list[object]]) -> int:
    columns = [_quoted(str(field.column)) for field in fields(model)]
    places = ", ".join(["%s"] * len(columns))
    table = _quoted(model._meta.db_table)
    statement = f"INSERT INTO {table} ({', '.join(columns)}) VALUES ({places})"  # noqa: S608 - ours
    count, size = 0, 0
    batch: list[list[object]] = []
    with connection.cursor() as cursor:
        for row in rows:
            batch.append(row)
            size += sum(len(value) for value in row if isinstance(value, str | bytes | memoryview))
            if len(batch) >= ROWS or size >= BYTES:
                cursor.executemany(statement, cast("list[list[str]]", batch))
                count, size, batch = count + len(batch), 0, []
        if batch:
            cursor.executemany(statement, cast("list[list[str]]", batch))
    return count + len(batch)


def _raise_numbers(before: Mapping[str, int], told: Header) -> None:
    for label, model in tables().items():
        last = max(before[label], told.tables[label].last, _highest(model))
        if last > 0:
            set_last_number(model, last)


def _highest(model: type[Model]) -> int:
    return model._base_manager.order_by("-pk").values_list("pk", flat=True).first() or 0


def _tell_of_it(before: _Before) -> None:
    """Let pages and nodes see that content is other than it was, though numbers may be the same."""
    if before.draft:
        now = DraftVersion.objects.values_list("number", flat=True).first() or 0
        number = max(before.draft, now) + 1
        DraftVersion.objects.update_or_create(pk=1, defaults={"number": number})
        note_about_draft("content restored from a backup")
    newest = Publication.objects.first()
    if before.release is None or newest is None or newest.pk > before.release[0]:
        return
    if (newest.pk, newest.checksum) != before.release:
        Publication.objects.create(
            note=f"Back to {newest.pk}",
            checksum=newest.checksum,
            counts=newest.counts,
            data=newest.data,
        )


def _quoted(name: str) -> str:
    return connection.ops.quote_name(name)
