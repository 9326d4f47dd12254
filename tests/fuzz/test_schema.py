"""The schema tells what calls answer when all is well, and every refusal in the one shape."""

import json
from typing import Any

import pytest
import yaml
from django.test import Client

from cair_site.errors import ERRORS
from dialogue.engine.content import Content
from tests.site_fixtures import CONTENT

SCHEMA: dict[str, Any] = yaml.safe_load(
    (CONTENT.parent / "docs" / "openapi.yaml").read_text(encoding="utf-8")
)
CALLS = [
    pytest.param(call["responses"], method, path, id=f"{method} {path}")
    for path, calls in SCHEMA["paths"].items()
    for method, call in calls.items()
]
REFUSAL = {"application/json": {"schema": {"$ref": "#/components/schemas/Refusal"}}}


@pytest.mark.parametrize(("responses", "method", "path"), CALLS)
def test_a_call_declares_its_refusals(responses: dict[str, Any], method: str, path: str) -> None:
    refused = {status for status in responses if int(status) >= 400}
    assert {"400", "401", "403", "429", "503"} <= refused
    assert ("413" in refused) == (method == "post")
    assert ("404" in refused) == ("{" in path or (method, path) == ("get", "/api/v1/ontology/"))
    assert all(responses[status]["content"] == REFUSAL for status in refused)
    assert "Retry-After" in responses["429"]["headers"]


def test_no_question_creates_anything() -> None:
    posts = [calls["post"]["responses"] for calls in SCHEMA["paths"].values() if "post" in calls]
    assert not any("201" in responses for responses in posts)


def test_only_lists_are_declared_as_lists() -> None:
    def shape(path: str) -> dict[str, Any]:
        answer = SCHEMA["paths"][path]["get"]["responses"]["200"]
        return dict(answer["content"]["application/json"]["schema"])

    assert shape("/api/v1/hub/") == {"$ref": "#/components/schemas/Start"}
    assert shape("/api/v1/topics/") == {"$ref": "#/components/schemas/Topics"}
    assert shape("/api/v1/intents/")["type"] == "array"


def test_every_code_is_declared() -> None:
    assert set(SCHEMA["components"]["schemas"]["CodeEnum"]["enum"]) == set(ERRORS)


@pytest.mark.parametrize(
    ("path", "message"),
    [
        ("hub/", {}),
        ("hub/", {"client_sentence": "tea " * 500, "capabilities": None}),
        ("plan/", {"client_sentence": "", "culture": "a culture nobody knows"}),
        ("dialogue/", {"kbplan_actions": [{"action": "more"}]}),
        ("dialogue/", {"question": {"intent": "playsong", "slot": "title", "text": "Which?"}}),
    ],
)
def test_what_the_server_accepts_the_schema_accepts(
    published: Content, path: str, message: dict[str, object]
) -> None:
    answer = Client().post(f"/api/v1/{path}", json.dumps(message), content_type="application/json")
    assert answer.status_code == 200
    name = SCHEMA["paths"][f"/api/v1/{path}"]["post"]["requestBody"]["content"]
    declared = SCHEMA["components"]["schemas"][
        name["application/json"]["schema"]["$ref"].rpartition("/")[2]
    ]
    assert set(declared.get("required", ())) <= set(message)
    for field in message:
        assert "maxLength" not in declared["properties"][field]
