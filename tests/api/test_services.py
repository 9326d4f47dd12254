"""The three services may live apart: then the Hub asks them over HTTP."""

import json
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from threading import Thread

import pytest
from pytest_django.fixtures import Settings

from tests.api.conftest import CLIENT, Api

NONSENSE = {"/nothing": b"", "/text": b"<html>", "/list": b"[]", "/lacks": b'{"plan": ""}'}


class Elsewhere(BaseHTTPRequestHandler):
    """Passes a call on to the services of this process, or answers nonsense."""

    def do_POST(self) -> None:
        body = self.rfile.read(int(self.headers["Content-Length"]))
        status, text = 200, NONSENSE.get(self.path)
        if text is None:
            answer = CLIENT.post(self.path, body, content_type="application/json")
            status, text = answer.status_code, answer.content
        self.send_response(status)
        self.send_header("Content-Length", str(len(text)))
        self.end_headers()
        self.wfile.write(text)

    def log_message(self, format: str, *arguments: object) -> None:
        """Keep quiet."""


@pytest.fixture(scope="module")
def elsewhere() -> Iterator[str]:
    """Return the address of a server that offers the services."""
    server = ThreadingHTTPServer(("127.0.0.1", 0), Elsewhere)
    Thread(target=server.serve_forever, daemon=True).start()
    yield f"http://127.0.0.1:{server.server_port}"
    server.shutdown()
    server.server_close()


@pytest.mark.parametrize("apart", [("plan",), ("dialogue",), ("plan", "dialogue")])
@pytest.mark.parametrize("sentence", ["I love music", "mmm"])
def test_services_apart_answer_like_services_together(
    api: Api, settings: Settings, elsewhere: str, apart: tuple[str, ...], sentence: str
) -> None:
    wish = {"client_sentence": sentence, "dialogue_state": api.start(seed=5)}
    together = api.post("hub/", **wish)
    for name in apart:
        setattr(settings, f"CAIR_{name.upper()}_MANAGER_URL", f"{elsewhere}/api/v1/{name}/")
    answer = api.post("hub/", **wish)
    # A plan sentence is drawn by chance where the Plan Manager is asked without a seed.
    assert answer | {"plan_sentence": ""} == together | {"plan_sentence": ""}


def test_a_plan_made_elsewhere_arrives(api: Api, settings: Settings, elsewhere: str) -> None:
    settings.CAIR_PLAN_MANAGER_URL = f"{elsewhere}/api/v1/plan/"
    answer = api.post("hub/", client_sentence="play the song Hey Brother")
    assert answer["plan"] == "#action=playsong title=Hey Brother"
    assert answer["plan_sentence"]


@pytest.mark.parametrize("path", [*NONSENSE, "/api/v1/nowhere/"])
def test_nonsense_of_the_plan_manager_costs_its_plan(
    api: Api, settings: Settings, elsewhere: str, path: str
) -> None:
    settings.CAIR_PLAN_MANAGER_URL = elsewhere + path
    answer = api.post("hub/", client_sentence="play the song Hey Brother")
    assert answer["plan"] == ""
    assert answer["dialogue_sentence"]


@pytest.mark.parametrize("path", [*NONSENSE, "/api/v1/nowhere/"])
def test_nonsense_of_the_dialogue_manager_is_told(
    api: Api, settings: Settings, elsewhere: str, path: str
) -> None:
    settings.CAIR_DIALOGUE_MANAGER_URL = elsewhere + path
    assert api.refused("hub/", client_sentence="x") == (503, "service.unreachable")


def test_a_silent_plan_manager_costs_its_plan(api: Api, settings: Settings) -> None:
    settings.CAIR_PLAN_MANAGER_URL = "http://127.0.0.1:9/"
    answer = api.post("hub/", client_sentence="play the song Hey Brother")
    assert (answer["plan"], answer["plan_sentence"]) == ("", "")
    assert answer["dialogue_sentence"]


def test_a_silent_dialogue_manager_is_told(api: Api, settings: Settings) -> None:
    settings.CAIR_DIALOGUE_MANAGER_URL = "http://127.0.0.1:9/"
    body = json.dumps({"client_sentence": "x"}).encode()
    assert api.send("hub/", body).status_code == 503


def test_a_missing_parameter_is_asked_for_across_services(
    api: Api, settings: Settings, elsewhere: str
) -> None:
    for name in ("plan", "dialogue"):
        setattr(settings, f"CAIR_{name.upper()}_MANAGER_URL", f"{elsewhere}/api/v1/{name}/")
    asked = api.post("hub/", client_sentence="look something up for me", dialogue_state=api.start())
    assert (asked["plan"], asked["sentence_type"]) == ("", "e")
    answer = api.post("hub/", client_sentence="Dante", dialogue_state=asked["dialogue_state"])
    assert answer["plan"] == "#action=wikisearch what=Dante"
