"""Work on the database that only one process at a time may do, on whatever machine it runs."""

import fcntl
import time
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from django.db import connection
from django.db.backends.base.base import BaseDatabaseWrapper

#: Sets our locks apart from those of other programs that use the same PostgreSQL.
OURS = 0x43414952  # "CAIR"
AGAIN_SECONDS = 0.2


@contextmanager
def one_at_a_time(
    work: str,
    used: BaseDatabaseWrapper = connection,
) -> Iterator[None]:
    """Wait until nobody else does this work on the database of `used`, then keep others waiting.

    A process that dies lets go. On PostgreSQL this is an advisory lock of a transaction of its own,
    which a pooler in between leaves together; on SQLite a locked file next to the database's. A
    database in memory has no others.
    """
    if used.vendor == "postgresql":
        with _lock_of_postgres(work, used):
            yield
    elif used.vendor == "sqlite" and not _in_memory(used):
        with _locked_file(Path(f"{used.settings_dict['NAME']}.{work}.lock")):
            yield
    else:
        yield


def _in_memory(used: BaseDatabaseWrapper) -> bool:
    name = str(used.settings_dict["NAME"])
    return name == ":memory:" or name.startswith("file:")


@contextmanager
def _lock_of_postgres(work: str, used: BaseDatabaseWrapper) -> Iterator[None]:
    own = used.copy()
    own.settings_dict["OPTIONS"].pop("pool", None)  # It would be given back to the pool.
    try:
        own.set_autocommit(False)
        # Those who wait for a lock in PostgreSQL itself would take up the connections of a pooler.
        while not _locked(work, own):
            own.rollback()
            time.sleep(AGAIN_SECONDS)
        yield
    finally:
        own.close()


def _locked(work: str, own: BaseDatabaseWrapper) -> bool:
    with own.cursor() as cursor:
        cursor.execute("SET LOCAL idle_in_transaction_session_timeout = 0")
        cursor.execute(
            "SELECT pg_try_advisory_xact_lock(%s, %s)", [OURS, zlib.crc32(work.encode()) >> 1]
        )
        return bool(cursor.fetchone()[0])


@contextmanager
def _locked_file(path: Path) -> Iterator[None]:
    with path.open("ab") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        yield
