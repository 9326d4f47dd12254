"""A client of the API that speaks JSON, over the published content."""

import json
import zlib
from dataclasses import dataclass
from typing import Any

import pytest
from django.test import Client

from dialogue.engine.content import Content

Json = dict[str, Any]


@dataclass
class Api:
    """The native API, called as a robot calls it."""

    client: Client

    def get(self, path: str, **query: object) -> Any:
        """Return the JSON of a GET that must succeed."""
        answer = self.client.get(f"/api/v1/{path}", query)
        assert answer.status_code == 200, answer.content
        return answer.json()

    def post(self, path: str, **message: object) -> Json:
        """Return the JSON of a POST that must succeed."""
        answer = self.send(path, json.dumps(message).encode())
        assert answer.status_code == 200, answer.content
        return dict(answer.json())

    def refused(self, path: str, **message: object) -> tuple[int, str]:
        """Return the status and the code of a POST that must fail."""
        answer = self.send(path, json.dumps(message).encode())
        return answer.status_code, answer.json()["error"]["code"]

    def send(self, path: str, body: bytes, **headers: str) -> Any:
        """Return the answer to a POST of any bytes."""
        return self.client.post(
            f"/api/v1/{path}", body, content_type="application/json", headers=headers
        )

    def read(self, answer: Any) -> Json:
        """Return the JSON of an answer, compressed or not."""
        packed = answer.headers.get("Content-Encoding")
        return dict(json.loads(zlib.decompress(answer.content, 47) if packed else answer.content))

    def start(self, **query: object) -> str:
        """Return the state of a new talk."""
        return str(self.get("hub/", **query)["dialogue_state"])


#: One for all tests: a client loads the middleware. A fault of ours is an answer, no exception.
CLIENT = Client(raise_request_exception=False)
STRICT = Client(raise_request_exception=False, enforce_csrf_checks=True)


@pytest.fixture
def api(published: Content) -> Api:
    """Return the native API."""
    return Api(CLIENT)
