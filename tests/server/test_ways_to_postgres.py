"""Through a pooler that changes connections, and over TLS: real servers on a real PostgreSQL."""

import json
import subprocess
import sys
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from cluster.pgbouncer import private_pgbouncer
from tests.postgres import NoPostgresError, Postgres, private_postgres
from tests.server import conftest
from tests.server.conftest import ROOT, Server, manage, manage_at_once
from tests.site_fixtures import CONTENT

Serve = Callable[[Path], Server]
plain_environment = conftest.environment


def on(url: str, patch: pytest.MonkeyPatch) -> None:
    """Have manage.py and servers of this test use the database of a URL."""
    patch.setattr(
        conftest, "environment", lambda var: plain_environment(var) | {"DATABASE_URL": url}
    )


@pytest.fixture(scope="module")
def pooled(loopback: None) -> Iterator[str]:
    """Return the URL of a database through PgBouncer."""
    try:
        with private_postgres() as postgres, private_pgbouncer(postgres) as url:
            yield f"{url}?pool=0"
    except NoPostgresError as error:
        pytest.skip(str(error))


@pytest.fixture(scope="module")
def tls(loopback: None) -> Iterator[Postgres]:
    try:
        with private_postgres(tls=True) as postgres:
            yield postgres
    except NoPostgresError as error:
        pytest.skip(str(error))


def test_through_a_pooler_several_nodes_set_up_at_once(pooled: str, tmp_path: Path) -> None:
    settings = plain_environment(tmp_path / "var") | {"DATABASE_URL": pooled}
    done = manage_at_once(3, settings, "prepare", "--content", str(CONTENT))
    assert [code for code, _told in done] == [0] * 3, done


def test_through_a_pooler_people_talk_and_experts_log_in(
    pooled: str, serve: Serve, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    on(pooled, monkeypatch)
    manage(tmp_path / "var", "prepare", "--content", str(CONTENT))
    server = serve(tmp_path / "var")
    cookie = "sessionid=" + "x" * 32

    def ask(_: int) -> tuple[int, int]:
        turn = json.dumps({"client_sentence": "I love music"}).encode()
        page = server.ask("GET", "/admin/", Cookie=cookie).status
        return page, server.ask("POST", "/api/v1/hub/", turn).status

    with ThreadPoolExecutor(8) as several:
        assert set(several.map(ask, range(100))) == {(302, 200)}


def test_over_tls_the_certificate_is_checked(
    tls: Postgres, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    whom = f"sslmode=verify-full&sslrootcert={tls.certificate}"
    on(f"{tls.url}?{whom}", monkeypatch)
    shown = "select ssl from pg_stat_ssl where pid = pg_backend_pid()"
    code = f"from django.db import connection as c; k = c.cursor(); k.execute({shown!r}); "
    code += "print(k.fetchone()[0])"
    assert manage(tmp_path / "var", "shell", "--no-imports", "-c", code) == "True\n"


@pytest.mark.parametrize(
    ("mode", "told"),
    [("sslmode=disable", "no encryption"), ("sslmode=verify-full", "certificate")],
)
def test_over_tls_who_does_not_trust_or_not_encrypt_is_not_connected(
    tls: Postgres, tmp_path: Path, mode: str, told: str
) -> None:
    environment = plain_environment(tmp_path / "var") | {"DATABASE_URL": f"{tls.url}?{mode}"}
    command = [sys.executable, "manage.py", "migrate", "--check"]
    done = subprocess.run(
        command, cwd=ROOT, env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode != 0
    assert told in done.stderr.splitlines()[-1] + done.stderr[-1000:]
    assert tls.password not in done.stderr
