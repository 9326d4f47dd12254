"""Empty tables whose next numbers begin at 1 again, on SQLite and PostgreSQL, until a rollback."""

from collections.abc import Iterable

from django.apps import apps
from django.db import connection, transaction
from django.db.backends.utils import CursorWrapper


def empty_apps(*names: str) -> None:
    """Empty all tables of these apps, whatever points to them."""
    tables = [
        model._meta.db_table
        for name in names
        for model in apps.get_app_config(name).get_models(include_auto_created=True)
    ]
    # Within one transaction, so that the order of the tables does not matter.
    with transaction.atomic(), connection.cursor() as cursor:
        if connection.vendor == "sqlite":
            cursor.execute("PRAGMA defer_foreign_keys = ON")
        for table in tables:
            cursor.execute(f'DELETE FROM "{table}"')  # noqa: S608 - names of our own tables
        _begin_at_one(cursor, tables)


def _begin_at_one(cursor: CursorWrapper, tables: Iterable[str]) -> None:
    if connection.vendor == "sqlite":
        for table in tables:
            cursor.execute("DELETE FROM sqlite_sequence WHERE name = %s", [table])
        return
    cursor.execute("SELECT sequencename FROM pg_sequences WHERE last_value IS NOT NULL")
    for (name,) in cursor.fetchall():
        if name.startswith(tuple(f"{table}_" for table in tables)):
            cursor.execute(f'ALTER SEQUENCE "{name}" RESTART')  # undone by a rollback
