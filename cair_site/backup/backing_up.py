"""The content of one moment, while others go on writing."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from django.db import connection, transaction

from cair_site.backup.file import Trailer, write
from cair_site.backup.tables import all_rows, header


def back_up(path: Path) -> tuple[Trailer, int]:
    """Write the content to a file; return its last line and its size uncompressed.

    Raises OSError, BackupError; then a file of this name is as it was.
    """
    with _one_moment():
        return write(path, header(), all_rows())


@contextmanager
def _one_moment() -> Iterator[None]:
    """See the database as it is now, keeping nobody from writing."""
    if connection.in_atomic_block:
        yield
    elif connection.vendor == "postgresql":
        with transaction.atomic(), connection.cursor() as cursor:
            cursor.execute("SET TRANSACTION ISOLATION LEVEL REPEATABLE READ, READ ONLY")
            cursor.execute("SET LOCAL statement_timeout = 0")
            yield
    else:
        with _without_writing(), transaction.atomic():
            yield


@contextmanager
def _without_writing() -> Iterator[None]:
    """Have transactions of SQLite begin as readers, which wait for nobody."""
    connection.ensure_connection()
    mode = getattr(connection, "transaction_mode", None)
    setattr(connection, "transaction_mode", "DEFERRED")  # noqa: B010 - only SQLite's has it
    try:
        yield
    finally:
        setattr(connection, "transaction_mode", mode)  # noqa: B010
