"""Server-Timing: each answer tells how long the server worked on it, and on which part."""

import re
import zlib

import pytest
from django.http import HttpResponse
from django.test import Client

from dialogue.engine.content import Content
from plans.timing import lap, timed

PART = re.compile(r"(\w+);dur=(\d+\.\d{3})")


def parts(response: HttpResponse) -> dict[str, float]:
    """Return the parts of the header in milliseconds."""
    told = response.headers["Server-Timing"]
    found = PART.findall(told)
    assert ", ".join(f"{name};dur={value}" for name, value in found) == told
    return {name: float(value) for name, value in found}


def posted(path: str, **values: object) -> HttpResponse:
    return Client().post(path, values, content_type="application/json")


def test_a_turn_of_the_hub_tells_all_its_parts(published: Content) -> None:
    state = Client().get("/api/v1/hub/").json()["dialogue_state"]
    found = parts(posted("/api/v1/hub/", client_sentence="I love tea", dialogue_state=state))
    assert set(found) == {"decode", "match", "dialogue", "encode", "total"}
    assert all(found.values())
    assert sum(found.values()) - found["total"] <= found["total"]


@pytest.mark.parametrize(
    ("path", "values", "expected"),
    [
        ("/api/v1/plan/", {"client_sentence": "Tell me a joke"}, {"decode", "match"}),
        ("/api/v1/dialogue/", {"client_sentence": "Hello"}, {"decode", "dialogue"}),
    ],
)
def test_each_manager_tells_its_own(
    published: Content, path: str, values: dict[str, str], expected: set[str]
) -> None:
    assert set(parts(posted(path, **values))) == expected | {"encode", "total"}


def test_an_error_has_its_time_too(published: Content) -> None:
    response = posted("/api/v1/hub/", client_sentence=7)
    assert response.status_code == 400
    assert parts(response)["total"] > 0


def test_a_turn_of_an_existing_client_tells_its_parts(published: Content) -> None:
    body = zlib.compress(b'{"client_sentence": "Hello", "dialogue_state": {}}')
    response = Client().put("/CAIR_hub", body, content_type="application/json")
    assert {"decode", "encode", "total"} <= set(parts(response))


def test_outside_an_answer_nothing_is_counted() -> None:
    with lap("match"):
        pass
    with timed() as laps:
        with lap("match"), lap("dialogue"):
            pass
        with lap("match"):
            pass
    assert set(laps) == {"match", "dialogue", "total"}
    assert laps["match"] <= laps["total"]
