"""Bodies may be compressed; the answer comes back the same way."""

import gzip
import json
import zlib
from collections.abc import Callable

import pytest

from tests.api.conftest import Api

TURN = json.dumps({"client_sentence": "play Hey Brother", "seed": 1}).encode()
WAYS = [("deflate", zlib.compress, zlib.decompress), ("gzip", gzip.compress, gzip.decompress)]
Change = Callable[[bytes], bytes]


@pytest.mark.parametrize(("name", "pack", "unpack"), WAYS)
@pytest.mark.parametrize("told", [True, False])
def test_a_compressed_turn_is_answered_compressed(
    api: Api, name: str, pack: Change, unpack: Change, told: bool
) -> None:
    headers = {"Content-Encoding": name} if told else {}
    answer = api.send("hub/", pack(TURN), **headers)
    assert answer.status_code == 200
    assert answer.headers["Content-Encoding"] == name
    assert json.loads(unpack(answer.content)) == api.send("hub/", TURN).json()


def test_a_plain_turn_is_answered_plain(api: Api) -> None:
    answer = api.send("hub/", TURN)
    assert "Content-Encoding" not in answer.headers
    assert answer.headers["Content-Type"] == "application/json"


def test_a_plain_body_that_says_it_is_compressed_is_read_as_it_is(api: Api) -> None:
    assert api.send("hub/", TURN, **{"Content-Encoding": "gzip"}).status_code == 200


@pytest.mark.parametrize(("name", "pack", "unpack"), WAYS)
def test_an_error_comes_back_compressed_too(
    api: Api, name: str, pack: Change, unpack: Change
) -> None:
    answer = api.send("hub/", pack(b'{"dialogue_state": "?"}'))
    assert (answer.status_code, answer.headers["Content-Encoding"]) == (400, name)
    assert json.loads(unpack(answer.content))["error"]["code"] == "state.unreadable"


@pytest.mark.parametrize("level", [0, 1, 6, 9])
def test_every_level_of_zlib_is_understood(api: Api, level: int) -> None:
    assert api.send("hub/", zlib.compress(TURN, level)).status_code == 200


@pytest.mark.parametrize("path", ["plan/", "dialogue/", "dialogue/explain/"])
def test_every_service_takes_compressed_bodies(api: Api, path: str) -> None:
    answer = api.send(path, zlib.compress(TURN))
    assert answer.status_code == 200
    assert json.loads(zlib.decompress(answer.content))
