"""The dialogue state of that time: plain JSON in zlib, `likelinesses` and `flags` per topic."""

import json
import zlib
from typing import TypedDict

from benchmarks.baseline.data import Data


class State(TypedDict):
    """What travels with the client.

    `likelinesses` has a value per topic that was judged; `flags` has 0 or 1 per sentence of each
    topic that was talked about. Both name a topic by its place, as JSON's keys are: "17".
    """

    topic: int
    sentence_type: str
    pattern: str
    likelinesses: dict[str, float]
    flags: dict[str, list[int]]


def first_state(data: Data) -> State:
    """Return the state of a person nobody has talked to."""
    return State(
        topic=data.roots[0],
        sentence_type="",
        pattern=data.topics[data.roots[0]]["pattern"],
        likelinesses={},
        flags={},
    )


def covered(state: State) -> int:
    """Return how many topics were talked about."""
    return len(state["likelinesses"].keys() | state["flags"].keys())


def squeeze(message: object) -> bytes:
    """Return a message as it goes over the wire: zlib of JSON."""
    return zlib.compress(json.dumps(message).encode())


def unsqueeze(body: bytes) -> dict[str, object]:
    """Return the message of a body."""
    message = json.loads(zlib.decompress(body))
    assert isinstance(message, dict)
    return message
