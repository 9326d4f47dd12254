"""A private PgBouncer on loopback, in front of a private PostgreSQL."""

import shutil
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from urllib.parse import urlsplit

from cluster.postgres import USER, NoPostgresError, Postgres, give, who
from cluster.processes import free_port

SECONDS = 30
#: Every transaction may get another connection, of which there are few.
SETTINGS = """\
[databases]
* = host=127.0.0.1 port={postgres}
[pgbouncer]
listen_addr = 127.0.0.1
listen_port = {port}
unix_socket_dir =
auth_type = scram-sha-256
auth_file = {users}
pool_mode = transaction
default_pool_size = 4
max_client_conn = 200
"""


@contextmanager
def private_pgbouncer(postgres: Postgres) -> Iterator[str]:
    """Yield the DATABASE_URL of the database through a pooler, which is ended afterwards.

    Raises NoPostgresError where PgBouncer is not installed, or does not start.
    """
    program = shutil.which("pgbouncer", path="/usr/sbin:/usr/bin:/usr/local/bin")
    if program is None:
        raise NoPostgresError("PgBouncer is not installed: apt-get install pgbouncer")
    port, users = free_port(), postgres.folder / "users.txt"
    settings, log = postgres.folder / "pgbouncer.ini", postgres.folder / "pgbouncer.log"
    users.write_text(f'"{USER}" "{postgres.password}"\n', encoding="ascii")
    settings.write_text(
        SETTINGS.format(postgres=postgres.port, port=port, users=users), encoding="ascii"
    )
    for file in (users, settings):
        give(file)
    with log.open("wb") as told:
        process = subprocess.Popen([program, settings], stdout=told, stderr=told, **who())
    try:
        _wait(process, log)
        parts = urlsplit(postgres.url)
        yield parts._replace(netloc=f"{USER}:{postgres.password}@127.0.0.1:{port}").geturl()
    finally:
        process.terminate()
        process.wait(SECONDS)


def _wait(process: "subprocess.Popen[bytes]", log: Path) -> None:
    until = time.monotonic() + SECONDS
    while process.poll() is None and time.monotonic() < until:
        if "process up" in log.read_text(errors="replace"):
            return
        time.sleep(0.1)
    raise NoPostgresError(f"PgBouncer did not start:\n{log.read_text(errors='replace')[-2000:]}")
