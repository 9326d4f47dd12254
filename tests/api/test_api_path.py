"""API calls go straight to their views, and lose nothing on the way that they need."""

import logging

import pytest
from django.http import HttpResponse
from django.test import Client

TURN = {"client_sentence": "I love dogs"}


def post(client: Client, path: str = "/api/v1/hub/", **headers: str) -> HttpResponse:
    return client.post(path, TURN, content_type="application/json", headers=headers)


@pytest.mark.usefixtures("published")
def test_a_turn_asks_nothing_of_sessions_and_languages(client: Client) -> None:
    client.cookies["sessionid"] = "somebody"
    answer = post(client)
    assert answer.status_code == 200
    assert "Vary" not in answer.headers
    assert not answer.cookies


@pytest.mark.usefixtures("published")
def test_an_answer_says_its_length_and_what_browsers_must_not_do(client: Client) -> None:
    answer = post(client)
    assert answer.headers["Content-Length"] == str(len(answer.content))
    assert answer.headers["X-Content-Type-Options"] == "nosniff"
    assert "default-src 'self'" in answer.headers["Content-Security-Policy"]


@pytest.mark.usefixtures("published")
def test_an_old_client_takes_the_same_way(client: Client) -> None:
    answer = client.put("/it/CAIR_hub", b'{"client_sentence": "ciao"}')
    assert answer.status_code == 200
    assert "Vary" not in answer.headers


def test_an_unknown_address_of_the_api_is_an_error_in_json(client: Client) -> None:
    answer = client.get("/api/v1/nothing/")
    assert answer.status_code == 404
    assert answer.json()["error"]["code"] == "not_found"


def test_a_foreign_name_of_the_server_is_refused(client: Client) -> None:
    answer = post(client, Host="elsewhere.example")
    assert answer.status_code == 400
    assert answer.json()["error"]["code"] == "host.unknown"


@pytest.mark.usefixtures("published")
def test_a_wrong_call_does_not_fill_the_log(
    client: Client, caplog: pytest.LogCaptureFixture
) -> None:
    with caplog.at_level(logging.INFO):
        answer = client.post("/api/v1/hub/", b"{", content_type="application/json")
    assert answer.status_code == 400
    assert not [one for one in caplog.records if one.name == "django.request"]


@pytest.mark.django_db
def test_pages_still_have_their_middlewares(client: Client) -> None:
    answer = client.get("/admin/login/", headers={"Accept-Language": "it"})
    assert answer.headers["Content-Language"] == "it"
    assert answer.headers["X-Frame-Options"] == "DENY"
