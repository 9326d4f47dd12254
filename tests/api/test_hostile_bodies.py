"""Hostile bodies: each gets the documented error or a normal answer, and the next one works."""

import gzip
import json
import os
import random
import zlib

import pytest
from pytest_django.fixtures import Settings

from cair_site.errors import ERRORS
from dialogue.engine import codec
from dialogue.engine.state import DialogueState
from dialogue.turns import state_keys
from tests.api.conftest import Api

OK = ""
PATHS = ["hub/", "plan/", "dialogue/", "dialogue/explain/"]


def said(sentence: str) -> bytes:
    return json.dumps({"client_sentence": sentence}).encode()


def field(name: str, value: object) -> bytes:
    return json.dumps({"client_sentence": "Hello", name: value}).encode()


DIGITS = b"9" * 100_000
BODIES = {
    "empty": (b"", OK),
    "blanks": (b" \r\n\t ", OK),
    "an empty object": (b"{}", OK),
    "huge": (b" " * 1_000_000, "body.too_large"),
    "random bytes": (random.Random(1).randbytes(5000), "body.not_json"),
    "an image": (b"\x89PNG\r\n\x1a\n" + bytes(1000), "body.not_json"),
    "UTF-16": ('{"client_sentence": "Hello"}'.encode("utf-16"), "body.not_json"),
    "Latin-1": ('{"client_sentence": "perché"}'.encode("latin-1"), "body.not_json"),
    "a form": (b"client_sentence=Hello", "body.not_json"),
    "half an object": (b'{"client_sentence": "Hel', "body.not_json"),
    "two objects": (b"{}{}", "body.not_json"),
    "comments": (b"{} // hello", "body.not_json"),
    "a list": (b"[]", "body.not_an_object"),
    "a list of objects": (b'[{"client_sentence": "Hello"}]', "body.not_an_object"),
    "a text": (b'"Hello"', "body.not_an_object"),
    "a number": (b"7", "body.not_an_object"),
    "null": (b"null", "body.not_an_object"),
    "deep lists": (b"[" * 190_000, "body.too_deep"),
    "deep objects": (b'{"a":' * 30_000, "body.too_deep"),
    "deep inside a field": (b'{"x":' + b"[" * 50 + b"]" * 50 + b"}", "body.too_deep"),
    "a truncated zlib body": (zlib.compress(said("Hello"))[:-5], "body.not_compressed"),
    "a truncated gzip body": (gzip.compress(said("Hello"))[:-5], "body.not_compressed"),
    "a damaged zlib body": (b"\x78\x9c" + b"\xff" * 50, "body.not_compressed"),
    "one byte of zlib": (b"\x78", "body.not_compressed"),
    "a zlib bomb": (zlib.compress(bytes(20_000_000)), "body.inflates_too_large"),
    "a gzip bomb": (gzip.compress(bytes(20_000_000)), "body.inflates_too_large"),
    "zlib in zlib": (zlib.compress(zlib.compress(said("Hello"))), "body.not_json"),
    "a sentence that is a number": (b'{"client_sentence": 7}', "body.invalid"),
    "a sentence that is null": (b'{"client_sentence": null}', "body.invalid"),
    "a sentence that is a list": (b'{"client_sentence": ["Hello"]}', "body.invalid"),
    "capabilities that are a text": (field("capabilities", "hello"), "body.invalid"),
    "capabilities that are numbers": (field("capabilities", [1, 2]), "body.invalid"),
    "fifty thousand capabilities": (field("capabilities", ["a"] * 30_000), OK),
    "unknown fields": (field("x" * 1000, {"y": [1, None, True]}), OK),
    "an unknown language": (field("language", "xx"), "language.unknown"),
    "an empty-ish language": (field("language", "-"), "language.unknown"),
    "a language of odd letters": (field("language", "\u202eti\x00"), "language.unknown"),
    "a very long language": (field("language", "e" * 100_000), "language.unknown"),
    "a lone high surrogate": (b'{"client_sentence": "\\ud800"}', "body.not_json"),
    "a lone low surrogate": (b'{"client_sentence": "a\\udc00b"}', "body.not_json"),
    "a surrogate in bytes": (b'{"client_sentence": "\xed\xa0\x80"}', "body.not_json"),
    "a pair of surrogates": (b'{"client_sentence": "\\ud83d\\ude00"}', OK),
    "right to left": (said("\u202e\u2067שלום مرحبا\u2069\u200f"), OK),
    "control characters": (said("".join(map(chr, range(32))) + "\x7f\x85\u2028\ufeff"), OK),
    "raw control characters": (b'{"client_sentence": "a\x01b"}', "body.not_json"),
    "NUL": (said("play \x00 music\x00"), OK),
    "a raw NUL": (b'{"client_sentence": "\x00"}', "body.not_json"),
    "a hundred thousand spaces": (said(" " * 100_000), OK),
    "a million spaces, zipped": (zlib.compress(said(" " * 1_000_000)), "body.inflates_too_large"),
    "combining marks": (said("e" + "\u0301" * 20_000), OK),
    "one long word": (said("a" * 150_000), OK),
    "many words": (said("play play " * 15_000), OK),
    "patterns": (said("(a|b)* {title} [x] $hasName %s %(x)s {0} ${jndi:x} <b>&amp;"), OK),
    "SQL": (said("'; DROP TABLE dialogue_topic; --"), OK),
    "many digits": (b'{"x": ' + DIGITS + b"}", "body.not_json"),
    "many decimals": (b'{"x": 0.' + DIGITS + b"}", OK),
    "an endless number": (b'{"x": 1e999}', "body.not_json"),
    "NaN": (b'{"x": NaN}', "body.not_json"),
    "Infinity": (b'{"x": -Infinity}', "body.not_json"),
    "duplicate keys": (b'{"client_sentence": 7, "client_sentence": "Hello"}', OK),
}


@pytest.mark.parametrize("path", PATHS)
@pytest.mark.parametrize("name", BODIES)
def test_a_hostile_body_is_answered_and_the_next_works(api: Api, path: str, name: str) -> None:
    body, code = BODIES[name]
    answer = api.send(path, body)
    assert answer.status_code == (ERRORS[code].status if code else 200)
    assert not code or api.read(answer)["error"]["code"] == code
    assert api.send(path, said("Hello")).status_code == 200


@pytest.mark.parametrize("method", ["GET", "PUT", "POST"])
@pytest.mark.parametrize("name", BODIES)
def test_old_clients_get_words_or_json(api: Api, method: str, name: str) -> None:
    """Only a body that is no JSON object is refused; everything else is spoken to."""
    body, code = BODIES[name]
    answer = api.client.generic(method, "/CAIR_hub", body)
    unusable = code.startswith("body.") and code != "body.invalid"
    assert answer.status_code == (ERRORS[code].status if unusable else 200)
    assert api.client.generic(method, "/CAIR_hub", b"").json()["dialogue_state"]


@pytest.mark.parametrize(
    ("name", "value", "code"),
    [
        ("seed", -1, "body.invalid"),
        ("seed", 2**32, "body.invalid"),
        ("seed", 2**63, "body.invalid"),
        ("seed", int("9" * 4000), "body.invalid"),
        ("seed", 1.5, "body.invalid"),
        ("seed", "1", "body.invalid"),
        ("culture", "XX", "culture.unknown"),
        ("culture", "E" * 100_000, "culture.unknown"),
        ("language", 7, "body.invalid"),
        ("dialogue_state", 7, "body.invalid"),
        ("dialogue_state", {}, "body.invalid"),
        ("dialogue_state", None, "body.invalid"),
        ("dialogue_state", "?", "state.unreadable"),
        ("dialogue_state", " ", "state.unreadable"),
        ("dialogue_state", "é", "state.unreadable"),
        ("dialogue_state", "\x00", "state.unreadable"),
        ("dialogue_state", "A" * 40, "state.damaged"),
        ("dialogue_state", "A" * 70_000, "state.too_large"),
    ],
)
def test_a_wrong_field_of_a_turn_is_refused(api: Api, name: str, value: object, code: str) -> None:
    answer = api.send("hub/", field(name, value))
    assert (answer.status_code, answer.json()["error"]["code"]) == (ERRORS[code].status, code)


def test_a_state_of_another_key_is_refused(api: Api) -> None:
    foreign = codec.encode(DialogueState("en", "EN"), [os.urandom(32)])
    assert api.refused("hub/", dialogue_state=foreign) == (400, "state.damaged")


def test_a_state_of_an_older_key_is_read(api: Api, settings: Settings) -> None:
    state = api.start()
    settings.CAIR_STATE_KEYS = ["a new key of thirty-two letters!", *settings.CAIR_STATE_KEYS]
    answer = api.post("hub/", client_sentence="Hello", dialogue_state=state)
    settings.CAIR_STATE_KEYS = settings.CAIR_STATE_KEYS[:1]
    assert api.post("hub/", client_sentence="Hello", dialogue_state=answer["dialogue_state"])
    assert api.refused("hub/", dialogue_state=state) == (400, "state.damaged")


def test_a_state_of_another_version_is_refused(api: Api, monkeypatch: pytest.MonkeyPatch) -> None:
    with monkeypatch.context() as patched:
        patched.setattr(codec, "VERSION", 2)
        state = codec.encode(DialogueState("en", "EN"), state_keys())
    assert api.refused("hub/", dialogue_state=state) == (400, "state.version")


def test_a_signed_state_of_a_language_that_is_gone_is_refused(api: Api) -> None:
    state = codec.encode(DialogueState("xx", "EN"), state_keys())
    assert api.refused("hub/", dialogue_state=state) == (400, "language.unknown")


def test_a_signed_state_of_a_culture_that_is_gone_talks_on(api: Api) -> None:
    state = codec.encode(DialogueState("en", "XX"), state_keys())
    assert api.post("hub/", client_sentence="Hello", dialogue_state=state)["dialogue_sentence"]


def test_a_signed_state_of_topics_that_are_gone_talks_on(api: Api) -> None:
    gone = DialogueState("en", "EN", topic=30_000, frames=(65_000,), ordering="qpcw", last_type="q")
    state = codec.encode(gone, state_keys())
    assert api.post("hub/", client_sentence="yes", dialogue_state=state)["dialogue_sentence"]
    assert api.post("dialogue/inspect/", dialogue_state=state)["topic"] == ""


def test_no_letter_of_a_state_can_be_changed(api: Api) -> None:
    state = api.post("hub/", client_sentence="I love music")["dialogue_state"]
    for place in range(len(state) - 1):
        other = "A" if state[place] != "A" else "B"
        changed = state[:place] + other + state[place + 1 :]
        assert api.refused("hub/", dialogue_state=changed) == (400, "state.damaged")


@pytest.mark.parametrize("cut", [1, 2, 3, 5, 20, 40])
def test_a_shortened_state_is_refused(api: Api, cut: int) -> None:
    state = api.start()
    status, code = api.refused("hub/", dialogue_state=state[:-cut])
    assert status == 400
    assert code in {"state.damaged", "state.unreadable"}
