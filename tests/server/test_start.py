"""A server starts, with and without content, and goes on when its database is lost."""

import json
import sqlite3
import subprocess
import sys
from collections.abc import Callable
from contextlib import closing
from pathlib import Path

from tests.server.conftest import ROOT, Server, environment, manage, wait_for

Serve = Callable[[Path], Server]
TURN = b'{"client_sentence": "I love music"}'


def asked(var: Path, question: str) -> list[tuple[object, ...]]:
    with closing(sqlite3.connect(var / "cair.sqlite3")) as database:
        return database.execute(question).fetchall()


def test_a_second_prepare_loads_nothing(own_var: Path) -> None:
    with closing(sqlite3.connect(own_var / "cair.sqlite3")) as database, database:
        database.execute("UPDATE dialogue_sentence SET text = 'An expert wrote this.'")
    publications = asked(own_var, "SELECT id, checksum FROM dialogue_publication")
    printed = manage(own_var, "prepare", "--content", "/nowhere")
    assert "password" not in printed
    assert asked(own_var, "SELECT id, checksum FROM dialogue_publication") == publications
    texts = asked(own_var, "SELECT DISTINCT text FROM dialogue_sentence")
    assert texts == [("An expert wrote this.",)]


def test_secrets_are_their_owners_alone(own_var: Path) -> None:
    for name in ("cair_secret_key", "cair_state_key"):
        assert len((own_var / name).read_text()) >= 32
        assert (own_var / name).stat().st_mode & 0o077 == 0


def test_collections_leave_the_loaded_content_alone(own_var: Path) -> None:
    told = "import gc, cair_site.wsgi; print(gc.isenabled(), gc.get_freeze_count() > 100_000)"
    command = [sys.executable, "-c", told]
    done = subprocess.run(
        command, cwd=ROOT, env=environment(own_var), capture_output=True, text=True, check=True
    )
    assert done.stdout.split() == ["True", "True"]


def nothing_is_served(server: Server) -> None:
    for answer in (
        server.ask("GET", "/api/v1/hub/"),
        server.ask("POST", "/api/v1/hub/", TURN),
        server.ask("GET", "/api/v1/topics/"),
    ):
        assert (answer.status, answer.json()["error"]["code"]) == (503, "content.not_published")
    old = server.ask("GET", "/CAIR_hub")
    assert old.status == 200
    assert not old.json()["dialogue_state"]
    assert isinstance(old.json()["first_sentence"], str)
    assert server.ask("GET", "/readyz").status == 503
    assert server.ask("GET", "/livez").status == 200
    assert server.ask("GET", "/").status == 503


def test_a_server_without_a_database_waits_for_its_content(
    tmp_path: Path, own_var: Path, serve: Serve
) -> None:
    var = tmp_path / "fresh"
    server = serve(var)
    nothing_is_served(server)
    for file in own_var.iterdir():
        (var / file.name).write_bytes(file.read_bytes())
    assert wait_for(lambda: server.publication() == 1, 30)
    assert server.ask("POST", "/api/v1/hub/", TURN).status == 200


def test_a_server_without_a_publication_waits_for_one(tmp_path: Path, serve: Serve) -> None:
    var = tmp_path / "empty"
    manage(var, "migrate", "--verbosity", "0")
    nothing_is_served(serve(var))


def test_turns_go_on_without_the_database(own_var: Path, serve: Serve) -> None:
    server = serve(own_var)
    state = server.ask("GET", "/api/v1/hub/").json()["dialogue_state"]
    for loss in (move_away, write_garbage, put_a_folder):
        loss(own_var / "cair.sqlite3")
        length = server.log.stat().st_size
        for _ in range(10):
            body = json.dumps({"client_sentence": "I love music", "dialogue_state": state}).encode()
            answer = server.ask("POST", "/api/v1/hub/", body)
            assert answer.status == 200, answer.body
            state = answer.json()["dialogue_state"]
        # Each worker has looked in vain, and goes on with what it has.
        assert wait_for(lambda start=length: looked_in_vain(server, start), 6)
        assert server.publication() == 1
        assert server.ask("GET", "/CAIR_hub").json()["dialogue_state"]


def looked_in_vain(server: Server, start: int) -> bool:
    return server.log.read_bytes()[start:].count(b"Cannot take over a newer publication") > 1


def move_away(database: Path) -> None:
    for file in database.parent.glob("cair.sqlite3*"):
        file.rename(file.with_name("away." + file.name))


def write_garbage(database: Path) -> None:
    for file in database.parent.glob("cair.sqlite3*"):
        file.unlink()
    database.write_bytes(b"garbage" * 1000)


def put_a_folder(database: Path) -> None:
    database.unlink()
    database.mkdir()
