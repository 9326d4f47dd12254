"""The three web services of the baseline: Flask-RESTful, each a process of its own."""

import time
from random import Random

import requests
from flask import Flask, Response, request
from flask_restful import Api, Resource

from benchmarks.baseline.data import Data
from benchmarks.baseline.dialogue_manager import reply
from benchmarks.baseline.plan_manager import find_plan
from benchmarks.baseline.state import first_state, squeeze, unsqueeze

SECONDS = 120


def _squeezed(message: object, began: float) -> Response:
    answer = Response(squeeze(message), content_type="application/json")
    answer.headers["Content-Encoding"] = "deflate"
    answer.headers["Server-Timing"] = f"total;dur={1000 * (time.perf_counter() - began):.3f}"
    return answer


class PlanManager(Resource):
    """PUT: a sentence in, a plan out."""

    def __init__(self, data: Data) -> None:
        self.data = data

    def put(self) -> dict[str, object]:
        """Return the plan of a sentence."""
        message = request.get_json(force=True)
        return dict(find_plan(self.data, message["client_sentence"], Random()))


class DialogueManager(Resource):
    """GET: the first state. PUT: sentence, state and KBplan in, sentence and state out."""

    def __init__(self, data: Data) -> None:
        self.data = data

    def get(self) -> dict[str, object]:
        """Return the first state."""
        return {"dialogue_state": first_state(self.data)}

    def put(self) -> dict[str, object]:
        """Return the next sentence."""
        message = unsqueeze(request.get_data())
        state, sentence = message["dialogue_state"], message["client_sentence"]
        return dict(reply(self.data, state, sentence, message["kbplan"], Random()))  # type: ignore[arg-type]


class Hub(Resource):
    """GET: start. PUT: a turn, its body and answer in zlib."""

    def __init__(self, plan: str, dialogue: str) -> None:
        self.plan, self.dialogue = plan, dialogue

    def get(self) -> Response:
        """Start a talk."""
        began = time.perf_counter()
        return _squeezed(requests.get(self.dialogue, timeout=SECONDS).json(), began)

    def put(self) -> Response:
        """Take a turn: the Plan Manager first, then the Dialogue Manager."""
        began = time.perf_counter()
        message = unsqueeze(request.get_data())
        asked = {"client_sentence": message["client_sentence"]}
        plan = requests.put(self.plan, json=asked, timeout=SECONDS).json()
        body = squeeze(message | {"kbplan": plan["kbplan"]})
        said = requests.put(self.dialogue, data=body, timeout=SECONDS).json()
        answer = {"plan_sentence": plan["plan_sentence"], "plan": plan["plan"], **said}
        return _squeezed(answer, began)


def service(resource: type[Resource], path: str, **options: object) -> Flask:
    """Return the application of one service."""
    app = Flask(__name__)
    Api(app).add_resource(resource, path, resource_class_kwargs=options)
    return app
