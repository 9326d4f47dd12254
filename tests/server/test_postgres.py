"""Real servers on a real PostgreSQL: it goes away and comes back, and nobody in a talk notices."""

import json
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from tests.postgres import NoPostgresError, Postgres, private_postgres
from tests.server import conftest
from tests.server.conftest import Server, manage, manage_at_once, wait_for
from tests.site_fixtures import CONTENT

Serve = Callable[[Path], Server]
plain_environment = conftest.environment


@pytest.fixture(scope="module")
def postgres() -> Iterator[Postgres]:
    try:
        with private_postgres() as server:
            yield server
    except NoPostgresError as error:
        pytest.skip(str(error))


@pytest.fixture(scope="module")
def _on_postgres(postgres: Postgres) -> Iterator[None]:
    """Have manage.py and servers of this module use the private PostgreSQL."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(
            conftest,
            "environment",
            lambda var: plain_environment(var) | {"DATABASE_URL": postgres.url},
        )
        yield


@pytest.fixture(scope="module")
def var(_on_postgres: None, loopback: None, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the CAIR_VAR of servers whose content is in the private PostgreSQL."""
    folder = tmp_path_factory.mktemp("postgres") / "var"
    manage(folder, "prepare", "--content", str(CONTENT))
    return folder


def talk(server: Server, turns: int, state: object = None) -> object:
    """Return the state after some turns, each of which must be answered."""
    for _ in range(turns):
        body = {"client_sentence": "I love music", "dialogue_state": state}
        if state is None:
            body.pop("dialogue_state")
        answer = server.ask("POST", "/api/v1/hub/", json.dumps(body).encode())
        assert answer.status == 200, answer.body
        state = answer.json()["dialogue_state"]
    return state


PUBLISH = """
    INSERT INTO dialogue_publication (created, note, checksum, counts, data)
    SELECT now(), 'again', checksum, counts, data FROM dialogue_publication ORDER BY id LIMIT 1
    RETURNING id
"""


def published(postgres: Postgres) -> int:
    """Publish again, in no time; return the number."""
    return int(str(postgres.ask(PUBLISH)[0][0]))


def all_serve(server: Server, number: int) -> bool:
    """Say whether, soon, no worker gives an older number; asked often enough to meet both."""
    return wait_for(lambda: {server.publication() for _ in range(20)} == {number}, 30)


def test_no_request_hangs_after_the_workers_were_forked(var: Path, serve: Serve) -> None:
    server = serve(var)
    cookie = "sessionid=" + "x" * 32

    def ask(_: int) -> int:
        return server.ask("GET", "/admin/", Cookie=cookie).status

    with ThreadPoolExecutor(8) as pool:
        assert set(pool.map(ask, range(200))) == {302}


def test_turns_go_on_while_the_database_is_away_and_publications_come_after(
    var: Path, serve: Serve, postgres: Postgres
) -> None:
    server = serve(var)
    before = server.publication()
    state = talk(server, 10)
    length = server.log.stat().st_size
    postgres.stop(at_once=True)
    state = talk(server, 30, state)
    assert wait_for(lambda: looked_in_vain(server, length), 60)
    assert server.publication() == before
    assert server.ask("GET", "/livez").status == 200
    # Long enough for a pool with growing pauses to be asleep when the database comes back.
    wait_for(lambda: False, 15)
    postgres.start()
    number = published(postgres)
    assert all_serve(server, number)
    talk(server, 5, state)


def looked_in_vain(server: Server, start: int) -> bool:
    return server.log.read_bytes()[start:].count(b"Cannot take over a newer publication") > 1


def test_a_quick_restart_is_no_pause(var: Path, serve: Serve, postgres: Postgres) -> None:
    server = serve(var)
    cookie = "sessionid=" + "y" * 32

    def ask(_: int) -> int:
        return server.ask("GET", "/admin/", Cookie=cookie).status

    with ThreadPoolExecutor(8) as pool:  # All connections of the pools are open now.
        assert set(pool.map(ask, range(40))) == {302}
    postgres.stop(at_once=True)
    postgres.start()
    with ThreadPoolExecutor(8) as pool:
        assert set(pool.map(ask, range(40))) == {302}
    number = published(postgres)
    assert all_serve(server, number)


@pytest.mark.parametrize("kind", ["postgresql", "sqlite"])
def test_several_nodes_migrate_at_once(
    kind: str, postgres: Postgres, loopback: None, tmp_path: Path
) -> None:
    url = f"sqlite:///{tmp_path}/x" if kind == "sqlite" else postgres.new_database("fresh")
    settings = plain_environment(tmp_path / "var") | {"DATABASE_URL": url}
    done = manage_at_once(4, settings, "migrate", "--verbosity", "0")
    assert [code for code, _told in done] == [0] * 4, done
