"""Errors: one shape everywhere, and no word of a person in the log."""

import json
from typing import Any

import pytest

from cair_site.errors import ERRORS
from dialogue import publishing
from tests.api.conftest import CLIENT, STRICT, Api

SECRET = "my sister Margaret is ill"


def code_of(answer: Any) -> str:
    """Return the code of an answer that has the one shape of errors."""
    assert answer.headers["Content-Type"] == "application/json"
    error = answer.json()["error"]
    assert set(error) == {"code", "message", "hint"}
    assert all(isinstance(text, str) and text for text in error.values())
    assert ERRORS[error["code"]].status == answer.status_code
    return str(error["code"])


@pytest.mark.parametrize(
    "path",
    ["/api/", "/api/v1/", "/api/v2/hub/", "/api/v1/hub/nothing/", "/api/v1/topics/-/", "/api/x"],
)
@pytest.mark.parametrize("method", ["GET", "POST", "DELETE"])
def test_an_unknown_address_answers_in_json(api: Api, path: str, method: str) -> None:
    assert code_of(api.client.generic(method, path, b"{}")) == "not_found"


@pytest.mark.parametrize(
    "path",
    [
        "/api/v1/hub/",
        "/api/v1/plan/",
        "/api/v1/dialogue/",
        "/api/v1/dialogue/explain/",
        "/api/v1/dialogue/inspect/",
        "/api/v1/topics/",
        "/api/v1/topics/Music/",
        "/api/v1/intents/",
        "/api/v1/actions/",
        "/api/v1/hub/options/",
        "/api/schema/",
        "/api/docs/",
        "/CAIR_hub",
    ],
)
@pytest.mark.parametrize("method", ["DELETE", "PATCH"])
def test_a_wrong_method_answers_in_json(api: Api, path: str, method: str) -> None:
    assert code_of(STRICT.generic(method, path, b"{}")) == "method.not_allowed"


def test_an_unknown_host_answers_in_json(api: Api) -> None:
    answer = api.client.get("/api/v1/hub/", headers={"host": "evil.example"})
    assert code_of(answer) == "host.unknown"


@pytest.mark.parametrize(
    "path", ["hub/", "plan/", "dialogue/", "dialogue/explain/", "dialogue/inspect/"]
)
def test_posts_need_no_cookie_of_ours(api: Api, path: str) -> None:
    answer = STRICT.generic("POST", f"/api/v1/{path}", b"[]")
    assert code_of(answer) == "body.not_an_object"
    assert not answer.cookies


def test_a_wrong_field_is_named(api: Api) -> None:
    answer = api.send("hub/", b'{"client_sentence": 7}')
    assert code_of(answer) == "body.invalid"
    assert "client_sentence" in answer.json()["error"]["message"]


@pytest.fixture
def broken(monkeypatch: pytest.MonkeyPatch) -> None:
    """Break the engine so that its exception quotes what the person said."""

    def reply(content: object, state: object, heard: Any) -> None:
        raise ValueError(heard.sentence)

    monkeypatch.setattr("dialogue.turns.reply", reply)


@pytest.mark.usefixtures("broken")
def test_a_fault_of_ours_is_json_and_logs_no_sentence(
    api: Api, caplog: pytest.LogCaptureFixture
) -> None:
    answer = api.send("hub/", json.dumps({"client_sentence": SECRET}).encode())
    assert code_of(answer) == "server.error"
    assert "ValueError" in caplog.text
    assert "turns.py" in caplog.text
    assert "Margaret" not in caplog.text + answer.content.decode()


@pytest.mark.usefixtures("broken")
def test_a_fault_of_ours_is_an_apology_to_old_clients(
    api: Api, caplog: pytest.LogCaptureFixture
) -> None:
    body = json.dumps({"client_sentence": SECRET, "dialogue_state": {}}).encode()
    answer = api.client.generic("PUT", "/CAIR_hub", body)
    assert answer.status_code == 200
    assert answer.json()["dialogue_sentence"]
    assert "ValueError" in caplog.text
    assert "Margaret" not in caplog.text


def test_no_sentence_is_logged_at_any_level(api: Api, caplog: pytest.LogCaptureFixture) -> None:
    with caplog.at_level("DEBUG"):
        api.post("hub/", client_sentence=SECRET)
        api.send("hub/", json.dumps({"client_sentence": SECRET, "seed": -1}).encode())
        api.client.generic("PUT", "/CAIR_hub", json.dumps({"client_sentence": SECRET}).encode())
    assert "Margaret" not in caplog.text


@pytest.mark.django_db
def test_nothing_published_is_told() -> None:
    publishing.serve(None)
    assert code_of(CLIENT.get("/api/v1/hub/")) == "content.not_published"
    assert code_of(CLIENT.post("/api/v1/hub/", b"{}", "a/b")) == "content.not_published"
    assert code_of(CLIENT.get("/api/v1/topics/")) == "content.not_published"
    assert CLIENT.get("/readyz").status_code == 503
    assert CLIENT.get("/livez").status_code == 200


@pytest.mark.django_db
def test_old_clients_ask_again_while_nothing_is_published() -> None:
    publishing.serve(None)
    answer = CLIENT.get("/CAIR_hub").json()
    assert answer == {"dialogue_state": {}, "first_sentence": "", "reply": ""}
    turn = CLIENT.generic("PUT", "/CAIR_hub", b'{"client_sentence": "x", "dialogue_state": {}}')
    assert (turn.status_code, turn.json()["dialogue_sentence"]) == (200, "")
