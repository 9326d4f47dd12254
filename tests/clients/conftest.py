"""What tests of the clients share: the module on the path, a server that is only made up."""

import json
import sys
import zlib
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import pytest

from tests.server.conftest import loopback, own_var, prepared, serve, server

__all__ = ["loopback", "own_var", "prepared", "serve", "server"]

PYTHON_CLIENT = Path(__file__).resolve().parent.parent.parent / "clients" / "python"
sys.path.insert(0, str(PYTHON_CLIENT))

Json = dict[str, Any]
Answer = tuple[int, Mapping[str, str], bytes]
UNPLANNED: Json = {"plan_sentence": "", "plan": "", "plan_actions": [], "sentence_type": "c"}
DOWN = ConnectionRefusedError(111, "Connection refused")


def answered(fields: object, status: int = 200, **headers: str) -> Answer:
    """Return an answer of a server."""
    return status, headers, json.dumps(fields).encode()


def refused(code: str, status: int, **headers: str) -> Answer:
    """Return an error in the shape of the server's."""
    error = {"code": code, "message": "That went wrong.", "hint": "Mend it."}
    return answered({"error": error}, status, **headers)


class MadeUpServer:
    """A transport: counts the turns in the state; what is in `next` is answered before that."""

    def __init__(self) -> None:
        self.asked: list[tuple[str, str, Json]] = []
        self.headers: list[Mapping[str, str]] = []
        self.next: list[Answer | Exception] = []

    def __call__(
        self, method: str, url: str, headers: Mapping[str, str], body: bytes | None, seconds: float
    ) -> Answer:
        """Answer as the Hub would."""
        fields = json.loads(zlib.decompress(body)) if body else {}
        self.asked.append((method, url, fields))
        self.headers.append(headers)
        if self.next:
            answer = self.next.pop(0)
            if isinstance(answer, Exception):
                raise answer
            return answer
        if method == "GET":
            return answered(self.begun())
        turn = int(fields["dialogue_state"].split()[1]) + 1
        return answered(self.turn(f"state {turn}", f"You said {fields['client_sentence']}."))

    def begun(self) -> Json:
        """Return the beginning of a talk."""
        here = {"language": "en", "culture": "EN", "topic": ""}
        return {"dialogue_state": "state 0", "first_sentence": "Hello, $name!", **here}

    def turn(self, state: str, sentence: str, **others: object) -> Json:
        """Return the answer of a turn."""
        texts = {"dialogue_state": state, "dialogue_sentence": sentence, "topic": "Tea"}
        return {**UNPLANNED, **texts, **others}

    def plan(self, *names: str) -> Answer:
        """Return a turn with a plan of these actions."""
        actions = [{"action": name, "parameters": {"title": None}} for name in names]
        return answered(
            self.turn("state 9", "And so on.", plan_sentence="Gladly.", plan_actions=actions)
        )


@pytest.fixture
def hub() -> MadeUpServer:
    """Return a made-up server."""
    return MadeUpServer()


@pytest.fixture
def talk_with(hub: MadeUpServer) -> Callable[..., Any]:
    """Return a function that makes a Conversation with the made-up server."""
    from cair_client import Conversation

    def made(**settings: object) -> Any:
        return Conversation("http://robot.example", transport=hub, **settings)

    return made


@pytest.fixture
def pauses(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """Let time pass only by the client's own pauses, which are listed."""
    import cair_client

    slept: list[float] = []
    monkeypatch.setattr(cair_client, "_sleep", slept.append)
    monkeypatch.setattr(cair_client, "_now", lambda: sum(slept))
    return slept
