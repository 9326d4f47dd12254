"""The ontology over REST always needs a key, and one that may have it."""

import pytest
from django.test import Client
from pytest_django.fixtures import Settings

from authoring import keys
from authoring.keys import make_key
from authoring.roles import ADMINISTRATOR
from ontology_io.models import ImportRun
from tests.api.ontology_calls import ADDRESS, OWL, alone, draft, headers, reader, send
from tests.api.test_errors import code_of
from tests.authoring.conftest import empty_draft, small_draft, small_folder
from tests.authoring.people import logged_in

__all__ = ["alone", "empty_draft", "reader", "small_draft", "small_folder"]
pytestmark = pytest.mark.usefixtures("small_draft")


@pytest.mark.parametrize("required", [True, False])
@pytest.mark.parametrize("path", [ADDRESS, "/api/v1/ontology", f"{ADDRESS}imports/1/"])
def test_it_always_needs_a_key(
    path: str, required: bool, client: Client, settings: Settings
) -> None:
    settings.CAIR_KEYS_REQUIRED = required
    answer = client.get(path)
    assert code_of(answer) == "key.missing"
    assert answer.headers["WWW-Authenticate"] == "Api-Key"
    assert code_of(client.post(ADDRESS, b"x", OWL)) == "key.missing"
    assert code_of(client.get(path, headers={"X-Api-Key": "cair_nothing"})) == "key.unknown"


def test_a_robots_key_does_not_open_it(client: Client) -> None:
    robot = headers("")
    assert code_of(client.get(ADDRESS, headers=robot)) == "key.not_enough"
    assert code_of(send(client, robot, b"x")) == "key.not_enough"


def test_a_key_to_read_does_not_write(client: Client, reader: dict[str, str]) -> None:
    assert client.get(ADDRESS, headers=reader).status_code == 200
    assert code_of(send(client, reader, b"x")) == "key.not_enough"
    assert not ImportRun.objects.exists()


def test_a_call_counts_once_where_keys_are_required(client: Client, settings: Settings) -> None:
    settings.CAIR_KEYS_REQUIRED = True
    key = {"X-Api-Key": make_key("slow", 2, None, "read")[1]}
    keys.forget()
    answers = [client.get(ADDRESS, headers=key) for _ in range(3)]
    assert [answer.status_code for answer in answers] == [200, 200, 429]


def test_a_login_of_the_admin_is_no_key() -> None:
    assert code_of(logged_in(ADMINISTRATOR).get(ADDRESS)) == "key.missing"


def test_an_administrator_makes_a_key_for_researchers(client: Client) -> None:
    admin = logged_in(ADMINISTRATOR)
    page = admin.post("/admin/keys/", {"label": "Rita", "ontology": "read"})
    key = {"X-Api-Key": page.context["new_key"]}
    keys.forget()
    assert draft(client, key).startswith(b"<?xml")
    assert "take it out" in admin.get("/admin/keys/").content.decode()


@pytest.mark.parametrize("ontology", ["all", "READ", "x" * 50])
def test_a_key_for_anything_else_is_not_made(ontology: str) -> None:
    answer = logged_in(ADMINISTRATOR).post("/admin/keys/", {"label": "a", "ontology": ontology})
    assert answer.status_code == 400
    assert "ontology" in answer.context["faults"]
