"""What docs/migrating.md says of old and new fields holds of a real server."""

import json
import re

import pytest

from tests.server import old_clients
from tests.server.conftest import ROOT, Json, Server

PAGE = (ROOT / "docs" / "migrating.md").read_text(encoding="utf-8")
TABLE = PAGE.split("| old field | new field | |")[1].split("\n\n")[0]
ROWS = [re.split(r" \| ", line.strip(" |"))[:2] for line in TABLE.splitlines()[2:]]
REQUEST = {"client_sentence", "dialogue_state", "capabilities", "language", "culture", "seed"}


def names(cell: str) -> set[str]:
    """Return the fields a cell of the table names."""
    return set(re.findall(r"`([a-z_.]+)`", cell))


def turn(server: Server, path: str, **fields: object) -> Json:
    """Return the answer of a turn that succeeds."""
    answer = server.ask("POST", path, json.dumps(fields).encode())
    assert answer.status == 200
    return answer.json()


def test_every_new_field_of_the_table_exists(server: Server) -> None:
    start = server.ask("GET", "/api/v1/hub/?language=it").json()
    answer = turn(server, "/api/v1/hub/", client_sentence="Ciao")
    new = set().union(*(names(cell) for _, cell in ROWS))
    assert len(ROWS) > 10
    assert new <= REQUEST | start.keys() | answer.keys()


def test_every_old_field_of_the_table_exists(server: Server) -> None:
    start = server.ask("GET", "/CAIR_hub").json()
    state = start["dialogue_state"]
    answers = [
        turn(server, "/CAIR_hub", client_sentence="Hello", dialogue_state=state),
        turn(server, "/CAIR_hub", sentence="Hello", dialogue_state=state),
    ]
    of_state = {f"dialogue_state.{name}" for name in state}
    asked = {"client_sentence", "sentence", "language", "dialogue_statistics", "due_intervention"}
    known = asked | of_state | start.keys() | answers[0].keys() | answers[1].keys()
    old = set().union(*(names(cell) for cell, _ in ROWS)) - {"pattern"}
    assert {
        name for name in old if name not in known and f"dialogue_state.{name}" not in known
    } == set()


def test_the_generations_are_those_that_are_tested() -> None:
    told = re.findall(r"^\| .* \| `([A-Z]\w+)` \|$", PAGE, re.MULTILINE)
    assert told == [one.__name__ for one in old_clients.GENERATIONS]


@pytest.mark.parametrize("route", ["/it/CAIR_hub", "/ja/CAIR_hub"])
def test_the_route_chooses_the_language(server: Server, route: str) -> None:
    begun = server.ask("GET", route).json()
    state = begun["dialogue_state"]["state"]
    body = json.dumps({"dialogue_state": state}).encode()
    told = server.ask("POST", "/api/v1/dialogue/inspect/", body).json()
    assert told["language"] == route[1:3]


def test_a_state_of_the_old_route_goes_on_by_the_new_one(server: Server) -> None:
    begun = server.ask("GET", "/CAIR_hub").json()
    answer = turn(
        server,
        "/api/v1/hub/",
        client_sentence="I love music",
        dialogue_state=begun["dialogue_state"]["state"],
    )
    assert answer["dialogue_sentence"]
