"""What robots get: talks over the Hub, as any client has them."""

import json

from tests.server.conftest import Json, Server


def talk(server: Server, seed: int, *sentences: str, language: str = "en") -> str:
    """Return all that the robot says in a talk with an Indian speaker."""
    began = _ask(server, "GET", f"/api/v1/hub/?language={language}&culture=IN&seed={seed}")
    state, said = began["dialogue_state"], [began["first_sentence"]]
    for sentence in sentences:
        answer = turn(server, sentence, state)
        state = answer["dialogue_state"]
        said.append(answer["dialogue_sentence"])
    return "\n".join(said)


def turn(server: Server, sentence: str, state: str = "", **more: str) -> Json:
    """Return the answer to one sentence."""
    body = {"client_sentence": sentence, **more} | ({"dialogue_state": state} if state else {})
    return _ask(server, "POST", "/api/v1/hub/", body)


def _ask(server: Server, method: str, path: str, body: Json | None = None) -> Json:
    answer = server.ask(method, path, json.dumps(body).encode() if body else None)
    assert answer.status == 200, answer.body[:500]
    return answer.json()
