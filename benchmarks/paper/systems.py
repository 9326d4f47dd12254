"""The systems that are measured: how each is asked, and what its bodies are."""

import json
from collections.abc import Callable
from contextlib import AbstractContextManager
from pathlib import Path
from typing import NamedTuple

from benchmarks.baseline.state import squeeze
from benchmarks.paper import servers
from benchmarks.paper.load import request

#: What people say, in turn: answers, something nobody tuned for, a topic.
SENTENCES = ("yes", "no", "I do not know", "my sister liked it", "I love dogs")
STAGES = 4


class System(NamedTuple):
    """A system under test: `requests[stage]` are whole requests, `payloads` bytes of a body."""

    name: str
    label: str
    serve: Callable[[Path], AbstractContextManager[int]]
    topics: list[int]
    payloads: list[int]
    requests: list[list[bytes]]


def _bodies(made: Callable[[str], bytes]) -> list[bytes]:
    return [made(sentence) for sentence in SENTENCES]


def _ours(state: object) -> list[bytes]:
    return _bodies(
        lambda said: json.dumps({"client_sentence": said, "dialogue_state": state}).encode()
    )


def _theirs(state: object) -> list[bytes]:
    return _bodies(lambda said: squeeze({"client_sentence": said, "dialogue_state": state}))


def _old(state: object) -> list[bytes]:
    whole = {
        "v": 1,
        "topic": 1,
        "sentence_type": "q",
        "pattern": "rwc",
        "state": state,
        "conversation_history": [],
        "ongoing_conversation": True,
        "formal_language": True,
    }
    return _bodies(lambda said: squeeze({"client_sentence": said, "dialogue_state": whole}))


def old_clients(folder: Path) -> System:
    """Return our system as clients that exist see it: an object as state, bodies in zlib."""
    states = json.loads((folder / "states.json").read_text(encoding="utf-8"))
    return _system(
        ("old route", "ours, on the old clients' route", servers.cair),
        ("PUT", "/CAIR_hub", _old),
        states["cair"],
    )


def systems(folder: Path) -> list[System]:
    """Return the re-created design and ours, with the states of the prepared folder."""
    states = json.loads((folder / "states.json").read_text(encoding="utf-8"))
    return [
        _system(
            ("baseline", "the paper's design, re-created", servers.baseline),
            ("PUT", "/CAIR_hub", _theirs),
            states["baseline"],
        ),
        _system(("cair", "ours", servers.cair), ("POST", "/api/v1/hub/", _ours), states["cair"]),
    ]


def _system(
    named: tuple[str, str, Callable[[Path], AbstractContextManager[int]]],
    asked: tuple[str, str, Callable[[object], list[bytes]]],
    stages: list[dict[str, object]],
) -> System:
    method, path, bodies = asked
    made = [bodies(stage["state"]) for stage in stages]
    return System(
        *named,
        topics=[int(str(stage["topics"])) for stage in stages],
        payloads=[round(sum(map(len, row)) / len(row)) for row in made],
        requests=[
            [request(method, path, body, "application/json") for body in row] for row in made
        ],
    )
