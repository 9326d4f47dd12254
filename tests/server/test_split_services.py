"""Hub, Plan Manager and Dialogue Manager on gunicorns of their own: same talks, gentle failures."""

import http.client
import json
import shutil
import signal
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from cair_site.elsewhere import REST_SECONDS
from cluster.network import Loopback
from cluster.nodes import Node
from cluster.processes import plain_environment, signal_group
from cluster.talks import SENTENCES

Json = dict[str, Any]
TURNS = 60
MORE = {
    "en": ("play a song", "Hey Brother", "goodbye", "hello again", "", "help me, I have fallen"),
    "it": ("metti una canzone", "Azzurro", "arrivederci", "ciao", "", "aiuto, sono caduta"),
    "ja": ("歌をかけて", "川の流れのように", "さようなら", "こんにちは", "", "助けて、転びました"),
}
SKEWED = {"client_sentence": "x", "intent": "no_such_intent", "plan_sentence": "x"}


#: How long the Hubs wait: one for a machine that is busy, the other gives up soon.
PATIENT, HASTY = "60", "6"


@dataclass
class Trio:
    """Two Hubs, and the managers they ask; each is a whole server."""

    hub: Node
    hasty: Node
    plan: Node
    dialogue: Node

    def all(self) -> tuple[Node, ...]:
        return self.hub, self.hasty, self.plan, self.dialogue


@pytest.fixture(scope="module")
def trio(prepared: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Trio]:
    """Start the servers with one key, and let the Hubs ask the others."""
    folder, network = tmp_path_factory.mktemp("trio"), Loopback()
    plain = plain_environment()
    plan, dialogue = (Node(number, network, folder / str(number), dict(plain)) for number in (2, 3))
    apart = {
        "CAIR_PLAN_MANAGER_URL": f"http://127.0.0.1:{plan.address[1]}/api/v1/plan/",
        "CAIR_DIALOGUE_MANAGER_URL": f"http://127.0.0.1:{dialogue.address[1]}/api/v1/dialogue/",
    }
    hubs = [
        Node(number, network, folder / str(number), plain | apart | {"CAIR_SERVICE_SECONDS": limit})
        for number, limit in enumerate((PATIENT, HASTY))
    ]
    started = Trio(hubs[0], hubs[1], plan, dialogue)
    try:
        for node in started.all():
            shutil.copytree(prepared, node.folder / "var", dirs_exist_ok=True)
            node.start(wait=False)
        for node in started.all():
            node.wait()
            assert ask(node, "POST", "plan/", client_sentence="hello")[0] == 200
        yield started
    finally:
        for node in started.all():
            node.kill()


def ask(node: Node, method: str, path: str, **wish: object) -> tuple[int, bytes]:
    """Return the status and the body of an answer; paths are those of the API, or begin with /."""
    connection = http.client.HTTPConnection(*node.address, timeout=20)
    try:
        body = json.dumps(wish).encode() if wish else None
        connection.request(method, path if path.startswith("/") else f"/api/v1/{path}", body)
        answer = connection.getresponse()
        return answer.status, answer.read()
    finally:
        connection.close()


def talk(node: Node, language: str, seed: int) -> list[bytes]:
    """Return the bodies of a talk, the start first."""
    status, body = ask(node, "GET", f"hub/?language={language}&seed={seed}")
    assert status == 200
    bodies, sentences = [body], [*SENTENCES[language], *MORE[language]]
    for turn in range(TURNS):
        state = json.loads(bodies[-1])["dialogue_state"]
        sentence = sentences[turn % len(sentences)]
        status, body = ask(node, "POST", "hub/", client_sentence=sentence, dialogue_state=state)
        assert status == 200, body
        bodies.append(body)
    return bodies


@pytest.mark.parametrize("language", list(SENTENCES))
def test_a_talk_over_three_servers_is_byte_for_byte_that_of_one(trio: Trio, language: str) -> None:
    apart = talk(trio.hub, language, 42)
    assert apart == talk(trio.dialogue, language, 42)
    answers = [json.loads(body) for body in apart[1:]]
    assert sum(bool(one["plan"]) for one in answers) >= 3
    assert any(one["plan_sentence"] for one in answers)


def old_talk(node: Node, language: str, seed: int) -> list[Json]:
    """Return the answers to an existing client; its talk begins with a seed that one cannot ask."""
    body = ask(node, "GET", f"hub/?language={language}&seed={seed}")[1]
    state = {"state": json.loads(body)["dialogue_state"]}
    answers: list[Json] = []
    for sentence in (*SENTENCES[language], *MORE[language]):
        wish = {"client_sentence": sentence, "dialogue_state": state}
        status, body = ask(node, "PUT", "/CAIR_hub", **wish)
        assert status == 200, body
        answers.append(json.loads(body))
        state = answers[-1]["dialogue_state"]
    return answers


@pytest.mark.parametrize("language", list(SENTENCES))
def test_existing_clients_hear_the_same_over_three_servers(trio: Trio, language: str) -> None:
    apart = old_talk(trio.hub, language, 42)
    assert apart == old_talk(trio.dialogue, language, 42)
    assert any("=None" in one["plan"] for one in apart)


def test_a_plan_that_waited_for_an_answer_arrives(trio: Trio) -> None:
    wish = {"language": "en", "seed": 3}
    asked = json.loads(
        ask(trio.hub, "POST", "hub/", client_sentence="Search the internet", **wish)[1]
    )
    assert (asked["plan"], asked["sentence_type"]) == ("", "e")
    state = asked["dialogue_state"]
    answer = ask(trio.hub, "POST", "hub/", client_sentence="Dante", dialogue_state=state)
    assert json.loads(answer[1])["plan"].endswith("what=Dante")


def test_an_intent_that_only_one_machine_knows_does_not_stop_the_talk(trio: Trio) -> None:
    question = {"intent": "no_such_intent", "slot": "what", "parameters": {}, "text": "Which?"}
    status, body = ask(trio.dialogue, "POST", "dialogue/", **SKEWED, question=question)
    assert status == 200
    assert json.loads(body)["dialogue_sentence"]


def test_kept_connections_outlive_a_restart_of_the_managers(trio: Trio) -> None:
    for _again in range(2):
        status, body = ask(trio.hub, "POST", "hub/", client_sentence="play the song Hey Brother")
        assert (status, bool(json.loads(body)["plan"])) == (200, True)
        for node in (trio.plan, trio.dialogue):
            node.stop()
            node.start()
    status, body = ask(trio.hub, "POST", "hub/", client_sentence="play the song Hey Brother")
    assert (status, bool(json.loads(body)["plan"])) == (200, True)


@dataclass
class Silence:
    """Makes one server silent: not there, or there without a word; and lets it speak again."""

    gone: bool
    node: Node | None = None

    def of(self, node: Node) -> None:
        self.node = node
        if self.gone:
            node.kill()
        else:
            assert node.process
            signal_group(node.process, signal.SIGSTOP)

    def ends(self) -> None:
        node, self.node = self.node, None
        if node is None:
            return
        if self.gone:
            node.start()
        else:
            assert node.process
            signal_group(node.process, signal.SIGCONT)


@pytest.fixture(params=["gone", "hanging"])
def silence(request: pytest.FixtureRequest) -> Iterator[Silence]:
    """Return a silence, which ends after the test."""
    silence = Silence(gone=request.param == "gone")
    yield silence
    silence.ends()
    time.sleep(REST_SECONDS + 0.5)  # The Hub lets a server that hung rest for a while.


def test_without_the_plan_manager_the_talk_goes_on_without_plans(
    trio: Trio, silence: Silence
) -> None:
    silence.of(trio.plan)
    state = ""
    for turn in range(1, 6):
        status, body = ask(
            trio.hasty,
            "POST",
            "hub/",
            client_sentence="play the song Hey Brother",
            dialogue_state=state,
        )
        said = json.loads(body)
        assert (status, said["plan"]) == (200, "")
        assert said["dialogue_sentence"]
        state = said["dialogue_state"]
        _status, seen = ask(trio.hasty, "POST", "dialogue/inspect/", dialogue_state=state)
        assert json.loads(seen)["turn"] == turn


def test_without_the_dialogue_manager_one_is_told_to_try_again_and_can(
    trio: Trio, silence: Silence
) -> None:
    state = json.loads(ask(trio.hasty, "GET", "hub/?seed=7")[1])["dialogue_state"]
    wish = {"client_sentence": "I love music", "dialogue_state": state}
    expected = ask(trio.hasty, "POST", "hub/", **wish)
    silence.of(trio.dialogue)
    status, body = ask(trio.hasty, "POST", "hub/", **wish)
    error = json.loads(body)["error"]
    assert (status, error["code"]) == (503, "service.unreachable")
    assert "same state" in error["hint"]
    silence.ends()
    assert ask(trio.hasty, "POST", "hub/", **wish) == expected


def test_an_existing_client_hears_an_apology_and_keeps_its_state(
    trio: Trio, silence: Silence
) -> None:
    state = old_talk(trio.hasty, "en", 7)[-1]["dialogue_state"]
    silence.of(trio.dialogue)
    wish = {"client_sentence": "I love music", "dialogue_state": state}
    status, body = ask(trio.hasty, "PUT", "/CAIR_hub", **wish)
    said = json.loads(body)
    assert (status, said["dialogue_state"], said["plan"]) == (200, state, "")
    assert said["dialogue_sentence"]
