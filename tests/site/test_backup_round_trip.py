"""A backup carries the content from SQLite to PostgreSQL and back without losing a letter."""

import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from tests.ontology.small_content import write_files
from tests.postgres import NoPostgresError, Postgres, private_postgres
from tests.site_fixtures import CONTENT

Manage = Callable[..., str]


@pytest.fixture(scope="module")
def postgres() -> Iterator[Postgres]:
    try:
        with private_postgres() as server:
            yield server
    except NoPostgresError as error:
        pytest.skip(str(error))


@pytest.fixture
def manage(tmp_path: Path) -> Manage:
    """Return a function that runs manage.py on the database of a URL."""

    def run(url: str, *arguments: str) -> str:
        environment = {**os.environ, "DATABASE_URL": url, "CAIR_VAR": str(tmp_path / "var")}
        done = subprocess.run(
            [sys.executable, "manage.py", *arguments],
            cwd=CONTENT.parent,
            env=environment,
            capture_output=True,
            text=True,
            check=False,
            timeout=120,
        )
        assert done.returncode == 0, done.stderr[-3000:]
        return done.stdout

    return run


def files(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def test_from_sqlite_to_postgresql_and_back(
    postgres: Postgres, manage: Manage, tmp_path: Path
) -> None:
    content = tmp_path / "content"
    content.mkdir()
    write_files(content)
    before, between, after = (
        f"sqlite:///{tmp_path}/before.sqlite3",
        postgres.new_database("between"),
        f"sqlite:///{tmp_path}/after.sqlite3",
    )
    for url in (before, between, after):
        manage(url, "migrate", "--verbosity", "0")
    manage(before, "load_content", str(content))
    assert "Publication 1:" in manage(before, "publish")
    backups = [tmp_path / f"{place}.gz" for place in range(3)]
    manage(before, "backup_content", str(backups[0]))
    manage(between, "restore_content", str(backups[0]))
    manage(between, "backup_content", str(backups[1]))
    manage(after, "restore_content", str(backups[1]))
    manage(after, "backup_content", str(backups[2]))
    assert {path.read_bytes() for path in backups} == {backups[0].read_bytes()}
    dumps = [tmp_path / f"dump{place}" for place in range(3)]
    for url, folder in zip((before, between, after), dumps, strict=True):
        # A draft that says the same gives the same release, so the bytes of a release are the same.
        assert "Publication 1:" in manage(url, "publish")
        manage(url, "dump_content", str(folder))
    assert files(dumps[0]) == files(dumps[1]) == files(dumps[2])
    rows = postgres.ask("SELECT max(id) FROM dialogue_topic", "between")
    new = postgres.ask("SELECT nextval(pg_get_serial_sequence('dialogue_topic', 'id'))", "between")
    assert int(str(new[0][0])) > int(str(rows[0][0]))
