"""Limits: each is a setting, and one byte below it is still fine."""

import json
import tracemalloc
import zlib

import pytest
from pytest_django.fixtures import Settings

from cair_site.messages import too_deep
from tests.api.conftest import Api


def padded(length: int) -> bytes:
    return b"{}".ljust(length)


def test_a_body_may_be_as_long_as_the_setting_says(api: Api, settings: Settings) -> None:
    settings.CAIR_LONGEST_BODY = 5000
    assert api.send("hub/", padded(5000)).status_code == 200
    assert api.send("hub/", padded(5001)).json()["error"]["code"] == "body.too_large"


def test_an_inflated_body_may_be_as_long_as_the_setting_says(api: Api, settings: Settings) -> None:
    settings.CAIR_LONGEST_INFLATED = 5000
    assert api.send("hub/", zlib.compress(padded(4999))).status_code == 200
    refused = api.send("hub/", zlib.compress(padded(9000)))
    assert (refused.status_code, refused.json()["error"]["code"]) == (
        413,
        "body.inflates_too_large",
    )


@pytest.mark.parametrize("path", ["/api/v1/hub/", "/CAIR_hub"])
def test_a_zlib_bomb_costs_no_memory(api: Api, path: str) -> None:
    bomb = zlib.compress(bytes(100_000_000), 9)
    api.client.generic("POST", path, bomb)
    tracemalloc.start()
    answer = api.client.generic("POST", path, bomb)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert answer.status_code == 413
    assert peak < 4_000_000


def test_json_may_nest_as_deep_as_the_setting_says(api: Api, settings: Settings) -> None:
    settings.CAIR_DEEPEST_JSON = 5
    assert api.send("hub/", b'{"x":' + b"[" * 4 + b"]" * 4 + b"}").status_code == 200
    refused = api.send("hub/", b'{"x":' + b"[" * 5 + b"]" * 5 + b"}")
    assert refused.json()["error"]["code"] == "body.too_deep"


def test_brackets_in_a_sentence_are_no_depth(api: Api) -> None:
    assert api.post("hub/", client_sentence='[[{"' * 100 + "\\")["dialogue_sentence"]


def test_only_the_beginning_of_a_long_sentence_is_heard(api: Api, settings: Settings) -> None:
    settings.CAIR_LONGEST_SENTENCE = 20
    long = "mmm ".ljust(30, ".") + "play Hey Brother"
    assert api.post("plan/", client_sentence=long)["plan"] == ""
    assert api.post("hub/", client_sentence=long)["plan"] == ""
    assert api.post("plan/", client_sentence="play Hey Brother")["plan"]


def test_a_state_that_is_too_long_is_refused(api: Api, settings: Settings) -> None:
    settings.CAIR_LONGEST_STATE = 1000
    assert api.refused("hub/", dialogue_state="A" * 1001) == (413, "state.too_large")


@pytest.mark.parametrize("length", ["9" * 5000, "99999999999999999999"])
def test_a_length_beyond_all_measure_is_refused(api: Api, length: str) -> None:
    answer = api.client.generic("POST", "/CAIR_hub", b"{}", CONTENT_LENGTH=length)
    assert (answer.status_code, answer.json()["error"]["code"]) == (413, "body.too_large")


def test_the_history_of_old_clients_does_not_outgrow_the_limit(api: Api) -> None:
    state = json.loads(api.client.get("/CAIR_hub").content)["dialogue_state"]
    state["conversation_history"] = [["user", str(number)] for number in range(1000)]
    body = json.dumps({"client_sentence": "x", "dialogue_state": state}).encode()
    kept = api.client.generic("PUT", "/CAIR_hub", body).json()["dialogue_state"]
    assert len(kept["conversation_history"]) == 200
    assert kept["conversation_history"][-1] == ["user", "999"]


@pytest.mark.parametrize(
    "piece", [b'"' + b"a" * 390_000, b'"\\' * 190_000, b'"' * 390_000, b"[]" * 190_000]
)
def test_looking_for_depth_costs_little(piece: bytes) -> None:
    tracemalloc.start()
    assert not too_deep(b"[]" * 30 + piece, 20)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 20_000_000
