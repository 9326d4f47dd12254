"""Small clients, one of each generation, written only from protocol.md section 2.

Each starts a talk, takes turns and reads the answers as its generation does: what would crash a
real one (a null, a missing key, a list in place of a text) fails here.
"""

import http.client
import json
import re
import zlib
from dataclasses import dataclass, field
from typing import Any

Json = dict[str, Any]
ACTION = re.compile(r"action=(\w+)")


def word(key: str, item: str) -> str:
    """Return a parameter that is one word, as clients find it."""
    return re.findall(key + r"=(\w+)", item)[0]


def free_text(key: str, item: str) -> str:
    """Return a parameter that is free text, as clients find it."""
    return re.findall(key + r"=(.*)", item)[0]


def actions(plan: str) -> list[tuple[str, str]]:
    """Return the names of a plan's actions, each with its piece of the plan."""
    return [(ACTION.findall(item)[0], item) for item in plan.split("#")[1:]]


@dataclass
class Said:
    """One answer, as every client wants it."""

    plan_sentence: str
    plan: str
    sentence: str


@dataclass
class OldClient:
    """What all generations share: an address, a state, a language they may send."""

    port: int
    path: str = "/CAIR_hub"
    state: Json = field(default_factory=dict)
    first_sentence: str = ""
    #: "name of the question": how this generation starts and takes its turns.
    start_call: tuple[str, str] = ("GET", "")
    turn_call: str = "PUT"

    def ask(self, method: str, path: str, body: bytes | None) -> tuple[bytes, str]:
        """Return the body of an answer and its encoding; anything but 200 stops these clients."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=20)
        try:
            connection.putrequest(method, path)
            if body:
                connection.putheader("Content-Length", str(len(body)))
            connection.endheaders(body)
            answer = connection.getresponse()
            text = answer.read()
            assert answer.status == 200, text
            return text, answer.getheader("Content-Encoding") or ""
        finally:
            connection.close()

    def start_body(self) -> bytes | None:
        """Return what this generation sends to begin."""
        return None

    def start(self) -> None:
        """Ask for the initial state; it must be plain JSON and truthy."""
        method, suffix = self.start_call
        text, encoding = self.ask(method, self.path + suffix, self.start_body())
        assert encoding == ""
        answer = json.loads(text)
        assert answer["dialogue_state"]
        self.state = answer["dialogue_state"]
        self.first_sentence = answer["first_sentence"]
        assert isinstance(self.first_sentence, str)

    def turn_body(self, sentence: str) -> Json:
        """Return the fields of a turn."""
        return {"client_sentence": sentence, "dialogue_state": self.state}

    def unpack(self, text: bytes, encoding: str) -> bytes:
        """Inflate as the Python clients do: their library does it where the header says so."""
        assert encoding == "deflate"
        return zlib.decompress(text)

    def read(self, answer: Json) -> Said:
        """Return the parts of an answer; a wrong type would crash the client."""
        said = Said(answer["plan_sentence"], answer["plan"], answer["dialogue_sentence"])
        assert all(isinstance(text, str) for text in (said.plan_sentence, said.plan, said.sentence))
        return said

    def say(self, sentence: str) -> Said:
        """Take a turn."""
        body = zlib.compress(json.dumps(self.turn_body(sentence), ensure_ascii=False).encode())
        answer = json.loads(self.unpack(*self.ask(self.turn_call, self.path, body)))
        self.state = answer["dialogue_state"]
        return self.read(answer)


@dataclass
class Spring2022(OldClient):
    """PUT starts with an empty body, GET is a turn with a body."""

    start_call: tuple[str, str] = ("PUT", "")
    turn_call: str = "GET"


@dataclass
class Autumn2022(OldClient):
    """GET starts, PUT is a turn; its names are `sentence` in, `intent_reply` and `reply` out."""

    def turn_body(self, sentence: str) -> Json:
        return {"sentence": sentence, "dialogue_state": self.state}

    def read(self, answer: Json) -> Said:
        said = Said(answer["intent_reply"], answer["plan"], answer["reply"])
        assert all(isinstance(text, str) for text in (said.plan_sentence, said.plan, said.sentence))
        return said


@dataclass
class Later2022(OldClient):
    """GET starts, PUT is a turn; the names of the fields are those of today."""


@dataclass
class Since2024(OldClient):
    """POST /CAIR_hub/start starts, POST /CAIR_hub is a turn; it sends its language."""

    start_call: tuple[str, str] = ("POST", "/start")
    turn_call: str = "POST"
    language: str = "en-US"

    def start_body(self) -> bytes | None:
        return json.dumps({"language": self.language}).encode()

    def turn_body(self, sentence: str) -> Json:
        return super().turn_body(sentence) | {"language": self.language}


@dataclass
class Android(OldClient):
    """It inflates by itself whatever the header says, and fails on any null."""

    def unpack(self, text: bytes, encoding: str) -> bytes:
        return zlib.decompress(text)

    def read(self, answer: Json) -> Said:
        assert "null" not in json.dumps(answer)
        for name in ("ongoing_conversation", "formal_language"):
            assert isinstance(answer["dialogue_state"][name], bool)
        return super().read(answer)


@dataclass
class NAOqi(OldClient):
    """It reads the type of the last sentence in the state."""

    def read(self, answer: Json) -> Said:
        sentence_type = self.state["sentence_type"]
        assert isinstance(sentence_type, str)
        return super().read(answer)


@dataclass
class ManySpeakers(OldClient):
    """It sends XML and statistics, keeps a history, and puts names in place of profiles."""

    profile: str = "3fa85f64-5717-4562-b3fc-2c963f66afa6"
    statistics: Json = field(default_factory=lambda: {"mov_window": [], "dialogue_turns": [[1]]})
    intervention: Json = field(default_factory=lambda: {"type": None, "timestamp": 0})

    def turn_body(self, sentence: str) -> Json:
        self.state["conversation_history"].append({"role": "user", "content": sentence})
        assert isinstance(self.state["topic"], int)
        said = f'<profile_id value="{self.profile}">{sentence}'
        return {
            "client_sentence": f"<response>{said}<speaking_time>1.5</speaking_time></response>",
            "dialogue_state": self.state,
            "dialogue_statistics": self.statistics,
            "due_intervention": self.intervention,
        }

    def read(self, answer: Json) -> Said:
        assert answer["dialogue_statistics"] == self.statistics
        assert answer["due_intervention"] == self.intervention
        texts = []
        for type_, text, profile in answer["dialogue_sentence"]:
            assert isinstance(type_, str)
            assert profile == self.profile
            texts.append(text.replace(f"${self.profile}", "Mrs Smith"))
        said = " ".join(texts)
        self.state["conversation_history"].append({"role": "assistant", "content": said})
        return Said(answer["plan_sentence"], answer["plan"], said)


SINGLE = (Spring2022, Autumn2022, Later2022, Since2024, Android, NAOqi)
GENERATIONS = (*SINGLE, ManySpeakers)
