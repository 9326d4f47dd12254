"""`/CAIR_hub`: the clients that already exist, unmodified (docs/compatibility.md).

What never changed between their generations: an empty body asks for the initial state, any other
body is a turn. So that decides, on one route, for GET, PUT and POST.
"""

from typing import Any

import msgspec
from django.conf import settings
from django.http import HttpRequest, HttpResponse
from django.views.decorators.csrf import csrf_exempt

from cair_site.compat_speech import Heard, hear, spoken
from cair_site.errors import ApiError, error_json, log_fault, named
from cair_site.messages import deflated, inflated, parse_json, read_bytes
from cair_site.metrics import count_error
from cair_site.services import Services
from cair_site.turn_facts import FACTS, Facts, language_of
from dialogue.engine.codec import StateError
from dialogue.engine.content import Content
from dialogue.engine.saying import apology
from dialogue.engine.state import DialogueState
from dialogue.publishing import NothingPublishedError, current
from dialogue.turns import first_turn, read_state, write_state
from languages.known import LANGUAGES
from plans.choices import UnknownChoiceError
from plans.timing import DECODE, ENCODE, HEADER, header, lap, timed

Json = dict[str, Any]
_services = Services()
METHODS = ("GET", "PUT", "POST")
STATE_VERSION = 1
LONGEST_HISTORY = 200  # clients only append: the state must not outgrow the limit of bodies
#: Fields that clients read or write in the state; those they change come back to them.
NOT_OURS = {"conversation_history": [], "ongoing_conversation": True, "formal_language": True}


@csrf_exempt
def hub(request: HttpRequest, language: str = "") -> HttpResponse:
    """Answer a start or a turn of an existing client, and say how long it took."""
    with timed() as laps:
        response = _hub(request, language)
    response.headers[HEADER] = header(laps)
    return response


def _hub(request: HttpRequest, language: str) -> HttpResponse:
    if request.method not in METHODS:
        refused = _answer(error_json(ApiError("method.not_allowed")), status=405)
        refused.headers["Allow"] = ", ".join(METHODS)
        return refused
    try:
        with lap(DECODE):
            body, encoding = inflated(read_bytes(request, request))
            message = parse_json(body)
    except ApiError as error:
        return _answer(error_json(error), status=error.status)
    if _is_start(request, message):
        return _answer(_start(message, language))
    answer = _turn(message, language)
    request.META[FACTS] = _facts(answer)
    return _answer(answer, encoding)


def _facts(answer: Json) -> Facts:
    """Return what may be told of a turn."""
    old = answer["dialogue_state"]
    text = old.get("state") if isinstance(old, dict) else None
    state = text if isinstance(text, str) else ""
    said = answer.get("plan_sentence") or answer.get("intent_reply")
    return Facts("compat", language_of(state), bool(answer["plan"] or said), len(state))


def _answer(data: Json, encoding: str = "", status: int = 200) -> HttpResponse:
    with lap(ENCODE):
        content = msgspec.json.encode(data)
        content = deflated(content, encoding) if encoding else content
    response = HttpResponse(content, content_type="application/json", status=status)
    if encoding:
        response.headers["Content-Encoding"] = encoding
    return response


def _is_start(request: HttpRequest, message: Json) -> bool:
    asked = request.path.rstrip("/").endswith("/start")
    return asked or not message.keys() & {"client_sentence", "sentence", "dialogue_state"}


def _language(message: Json, prefix: str) -> str:
    """Return the language of a talk: the route's, else the message's, else the server's."""
    given = prefix or message.get("language")
    code = given.lower()[:2] if isinstance(given, str) else ""
    return code if code in LANGUAGES else settings.CAIR_LANGUAGE


def _start(message: Json, prefix: str) -> Json:
    """Return the initial state; a falsy one tells the clients to ask again."""
    try:
        said = first_turn(current(), _language(message, prefix), "")
    except NothingPublishedError:
        return {"dialogue_state": {}, "first_sentence": "", "reply": ""}
    text = spoken(said.sentence, "")
    return {"dialogue_state": _state_json(said.state, {}), "first_sentence": text, "reply": text}


def _state_json(state: DialogueState, old: Json) -> Json:
    """Return the state as an object with the fields that clients look at; only `state` counts."""
    return {
        **NOT_OURS,
        **old,
        **_short_history(old),
        "v": STATE_VERSION,
        "topic": state.topic,
        "sentence_type": state.last_type,
        "pattern": state.ordering,
        "state": write_state(state),
        "ongoing_conversation": not state.ended,
    }


def _short_history(old: Json) -> Json:
    history = old.get("conversation_history")
    if not isinstance(history, list):
        return {}
    return {"conversation_history": history[-LONGEST_HISTORY:]}


def _turn(message: Json, prefix: str) -> Json:
    """Return the answer of a turn; trouble becomes an apology and the unchanged state."""
    heard = hear(message)
    old = message.get("dialogue_state")
    language = _language(message, prefix)
    try:
        answer = _talk(heard, old, language)
    except Exception as error:  # noqa: BLE001 - whatever broke, the client gets words to say
        known = named(error)
        if known is None:
            log_fault(error)
        count_error(known.code if known else "server.error")
        answer = _apologise(heard, old, language)
    return answer | {
        name: message[name]
        for name in ("dialogue_statistics", "due_intervention")
        if name in message
    }


def _state(content: Content, old: object, language: str) -> DialogueState:
    """Return the state a client sent, a new one where it has none yet."""
    if not old:
        return first_turn(content, language, "").state
    if not isinstance(old, dict) or not isinstance(old.get("state"), str):
        raise ApiError("state.unreadable")
    return read_state(old["state"])


def _talk(heard: Heard, old: object, language: str) -> Json:
    content = current()
    state = _state(content, old, language)
    told = _services.turn_without_asking(content, state, heard.sentence)
    return {
        "dialogue_state": _state_json(told.state, old if isinstance(old, dict) else {}),
        heard.names.plan_sentence: spoken(told.plan_sentence, heard.profile),
        "plan": told.plan,
        heard.names.dialogue_sentence: heard.reply(
            told.sentence_type, spoken(told.sentence, heard.profile)
        ),
    }


def _spoken_language(old: object, language: str) -> str:
    """Return the language of the state, where it can still be read."""
    text = old.get("state") if isinstance(old, dict) else None
    try:
        return read_state(text).language if isinstance(text, str) else language
    except (StateError, UnknownChoiceError):
        return language


def _apologise(heard: Heard, old: object, language: str) -> Json:
    try:
        text = apology(current(), _spoken_language(old, language))
    except NothingPublishedError:
        text = ""
    return {
        "dialogue_state": {} if old is None else old,
        heard.names.plan_sentence: "",
        "plan": "",
        heard.names.dialogue_sentence: heard.reply("c", text),
    }
