"""What may be told of a turn: its service and language, whether it has a plan, sizes; no words."""

from typing import Any, NamedTuple

import msgspec
from django.http import HttpRequest
from django.http.response import HttpResponseBase
from rest_framework.response import Response

from dialogue.engine.codec import encode
from dialogue.engine.state import DialogueState
from languages.known import LANGUAGES

FACTS = "cair.turn"
LANGUAGE = "cair.language"

#: Where the language stands in the text of a state, and how it is written there.
_PLACE = slice(24, 28)
_WRITTEN = {
    encode(DialogueState(code, "EN"), [bytes(16)])[_PLACE]: code
    for code in LANGUAGES
    if len(code) == 2
}


class Facts(NamedTuple):
    """A turn: `state` is the number of characters of the state in the answer, 0 for none."""

    service: str
    language: str
    plan: bool
    state: int


def language_of(state: str) -> str:
    """Return the language of a state that we wrote, "" where it does not tell."""
    return _WRITTEN.get(state[_PLACE], "")


def facts_of(request: HttpRequest, response: HttpResponseBase) -> Facts | None:
    """Return what may be told of an answered turn; None where the answer is none."""
    told: Facts | None = request.META.get(FACTS)
    if told is not None or not isinstance(response, Response) or request.method != "POST":
        return told
    data = response.data
    match request.resolver_match and request.resolver_match.view_name:
        case "hub-list":
            return _of_reply("hub", data)
        case "dialogue-list":
            return _of_reply("dialogue", data)
        case "plan-list":
            return Facts("plan", request.META.get(LANGUAGE, ""), bool(data["intent"]), 0)
    return None


def _of_reply(service: str, data: dict[str, Any]) -> Facts:
    state = data["dialogue_state"]
    plan = bool(data["plan"] or data["plan_sentence"])
    return Facts(service, language_of(state), plan, len(state))


def error_code_of(response: HttpResponseBase) -> str:
    """Return the code of an answer with an error, "" where it has none of ours."""
    data = getattr(response, "data", None)
    if data is None:
        try:
            data = msgspec.json.decode(getattr(response, "content", b""))
        except msgspec.DecodeError:
            return ""
    error = data.get("error") if isinstance(data, dict) else None
    return str(error.get("code", "")) if isinstance(error, dict) else ""
