"""What the API says about itself: the OpenAPI schema and its page."""

from io import StringIO
from pathlib import Path

import yaml
from django.core.management import call_command

from tests.api.conftest import Api


def test_the_schema_names_every_call(api: Api) -> None:
    answer = api.client.get("/api/schema/")
    schema = yaml.safe_load(answer.content)
    assert schema["openapi"].startswith("3.")
    called = {path: set(calls) for path, calls in schema["paths"].items()}
    assert called["/api/v1/hub/"] == {"get", "post"}
    assert called["/api/v1/plan/"] == {"post"}
    assert {"/api/v1/dialogue/explain/", "/api/v1/topics/{name}/"} <= set(called)


def test_the_schema_names_every_field_of_a_turn(api: Api) -> None:
    schema = yaml.safe_load(api.client.get("/api/schema/").content)
    fields = schema["components"]["schemas"]["Turn"]["properties"]
    assert set(fields) == {
        "client_sentence",
        "dialogue_state",
        "capabilities",
        "language",
        "culture",
        "seed",
    }


def test_the_documentation_is_a_page(api: Api) -> None:
    answer = api.client.get("/api/docs/")
    assert answer.status_code == 200
    assert answer.headers["Content-Type"].startswith("text/html")
    assert "http" not in answer.headers["Content-Security-Policy"]


def test_the_schema_in_the_repository_is_that_of_the_server() -> None:
    now = StringIO()
    call_command("spectacular", stdout=now)
    kept = Path(__file__).resolve().parents[2] / "docs/openapi.yaml"
    assert kept.read_text(encoding="utf-8") == now.getvalue().rstrip("\n") + "\n", (
        "Run `make openapi` and commit docs/openapi.yaml."
    )
