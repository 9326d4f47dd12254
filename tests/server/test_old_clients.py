"""The clients that exist talk with a real server, unmodified."""

import json
import zlib

import pytest

from tests.server.conftest import Server
from tests.server.old_clients import (
    GENERATIONS,
    SINGLE,
    Json,
    Later2022,
    ManySpeakers,
    OldClient,
    Since2024,
    actions,
    free_text,
    word,
)

TALK = (
    "Hello",
    "I love music",
    "yes, I do",
    "play the song Hey Brother",
    "xyzzy plugh",
    "no",
    "turn the volume up",
    "let us talk about food",
    "I don't know",
    "",
    "yes please",
    "translate good morning into Italian",
)
EVERYONE = pytest.mark.parametrize("generation", GENERATIONS)


@EVERYONE
def test_a_talk_of_twelve_turns(server: Server, generation: type[OldClient]) -> None:
    client = generation(server.port)
    client.start()
    answers = [client.say(sentence) for sentence in TALK]
    assert all(said.plan_sentence or said.sentence for said in answers)
    assert len({said.sentence for said in answers}) > 6


@EVERYONE
def test_a_song_arrives_as_clients_read_it(server: Server, generation: type[OldClient]) -> None:
    client = generation(server.port)
    client.start()
    said = client.say("play the song Hey Brother")
    ((name, item),) = actions(said.plan)
    assert name == "playsong"
    assert free_text("title", item) == "Hey Brother"
    assert said.plan_sentence


@EVERYONE
@pytest.mark.parametrize(
    "wish",
    [
        ("turn the volume up", "volume", {"level": "louder"}, {}),
        (
            "translate good morning into Italian",
            "translate",
            {"language": "italian"},
            {"what": "good morning"},
        ),
        ("what's the weather like in New York", "weather", {}, {"city": "New York"}),
    ],
)
def test_parameters_arrive_as_clients_read_them(
    server: Server, generation: type[OldClient], wish: tuple[str, str, Json, Json]
) -> None:
    sentence, name, words, texts = wish
    needs(server, name)
    client = generation(server.port)
    client.start()
    ((action, item),) = actions(client.say(sentence).plan)
    assert action == name
    assert {key: word(key, item).lower() for key in words} == words
    assert {key: free_text(key, item) for key in texts} == texts


@EVERYONE
def test_a_plan_of_two_actions_is_read_one_by_one(
    server: Server, generation: type[OldClient]
) -> None:
    needs(server, "rest")
    client = generation(server.port)
    client.start()
    items = actions(client.say("go to charge").plan)
    assert [name for name, _ in items] == ["goto", "rest"]
    assert free_text("where", items[0][1]) == "docking station"


def needs(server: Server, action: str) -> None:
    """Skip where the shipped library has no plan with an action."""
    intents = json.loads(server.ask("GET", "/api/v1/intents/").body)
    if not any(f"action={action}" in intent["plan"] for intent in intents):
        pytest.skip(f"The shipped library has no intent whose plan is {action}.")


@EVERYONE
def test_an_unknown_sentence_is_answered_with_words(
    server: Server, generation: type[OldClient]
) -> None:
    client = generation(server.port)
    client.start()
    said = client.say("xyzzy plugh")
    assert said.plan == said.plan_sentence == ""
    assert said.sentence


@EVERYONE
@pytest.mark.parametrize("damage", ["cut", "changed", "gone"])
def test_a_damaged_state_is_an_apology(
    server: Server, generation: type[OldClient], damage: str
) -> None:
    client = generation(server.port)
    client.start()
    text = client.state["state"]
    client.state["state"] = {"cut": text[:-4], "changed": "A" + text[1:], "gone": None}[damage]
    if damage == "gone":
        del client.state["state"]
    sent = json.dumps(client.turn_body("Hello")["dialogue_state"])
    said = client.say("Hello")
    assert said.sentence
    assert (said.plan_sentence, said.plan) == ("", "")
    kept = {name: client.state.get(name) for name in ("state", "topic", "sentence_type")}
    assert kept == {name: json.loads(sent).get(name) for name in kept}


@EVERYONE
def test_the_slash_does_not_matter(server: Server, generation: type[OldClient]) -> None:
    client = generation(server.port, path="/CAIR_hub")
    client.start()
    client.path = "/CAIR_hub/"
    assert client.say("Hello").sentence
    client.start_call = (client.start_call[0], client.start_call[1].lstrip("/"))
    client.start()


@EVERYONE
def test_a_prefix_of_the_route_chooses_the_language(
    server: Server, generation: type[OldClient]
) -> None:
    client = generation(server.port, path="/it/CAIR_hub")
    client.start()
    assert server_language(server, client) == "it"
    client.say("Mi piace la musica")
    assert server_language(server, client) == "it"


@pytest.mark.parametrize(("tag", "code"), [("it-IT", "it"), ("en-US", "en"), ("ja-JP", "ja")])
def test_a_client_since_2024_chooses_its_language(server: Server, tag: str, code: str) -> None:
    client = Since2024(server.port, language=tag)
    client.start()
    assert server_language(server, client) == code


def server_language(server: Server, client: OldClient) -> str:
    body = json.dumps({"dialogue_state": client.state["state"]}).encode()
    return str(server.ask("POST", "/api/v1/dialogue/inspect/", body).json()["language"])


@pytest.mark.parametrize("generation", SINGLE)
@pytest.mark.parametrize("path", ["/CAIR_hub", "/it/CAIR_hub", "/ja/CAIR_hub"])
def test_nothing_unsayable_reaches_a_client(
    server: Server, generation: type[OldClient], path: str
) -> None:
    client = generation(server.port, path=path)
    client.language = path[1:3] if path.count("/") > 1 else "en"  # type: ignore[attr-defined]
    client.start()
    texts = [client.first_sentence]
    for number in range(40):
        said = client.say(TALK[number % len(TALK)])
        texts += [said.plan_sentence, said.sentence]
    assert not [text for text in texts if set(text) & set("$ə{}#")]


def test_only_the_own_profile_is_named_to_many_speakers(server: Server) -> None:
    client = ManySpeakers(server.port)
    client.start()
    texts = [client.say(TALK[number % len(TALK)]).sentence for number in range(40)]
    assert not [text for text in texts if set(text) & set("$ə")]


def test_a_json_turn_is_answered_in_json(server: Server) -> None:
    client = Later2022(server.port)
    client.start()
    body = json.dumps(client.turn_body("Hello")).encode()
    text, encoding = client.ask("PUT", "/CAIR_hub", body)
    assert encoding == ""
    assert json.loads(text)["dialogue_sentence"]


def test_what_a_client_adds_to_its_state_comes_back(server: Server) -> None:
    client = Later2022(server.port)
    client.start()
    client.state |= {"formal_language": False, "mine": [1, {"two": 2}]}
    client.say("Hello")
    assert client.state["mine"] == [1, {"two": 2}]
    assert client.state["formal_language"] is False


def test_a_client_that_lost_its_state_starts_again(server: Server) -> None:
    client = Later2022(server.port)
    assert client.say("I love music").sentence
    assert client.state["state"]


@pytest.mark.parametrize("body", [b"no JSON", b"[1]", b"\x78\x9cx", zlib.compress(b"[]")])
@pytest.mark.parametrize("method", ["GET", "PUT", "POST"])
def test_only_an_unusable_body_is_refused(server: Server, method: str, body: bytes) -> None:
    answer = server.ask(method, "/CAIR_hub", body)
    error: Json = answer.json()["error"]
    assert (answer.status, error["code"][:5]) == (400, "body.")


def test_the_history_of_many_speakers_is_kept(server: Server) -> None:
    client = ManySpeakers(server.port)
    client.start()
    client.say("Hello")
    client.say("I love music")
    said = [one["content"] for one in client.state["conversation_history"]]
    assert said[0] == "Hello"
    assert len(said) == 4
    assert all(said)
