"""The Hub's way to the two managers: called in this process, or over HTTP where they live apart."""

import logging
from dataclasses import dataclass
from http.client import HTTPException
from urllib.error import URLError
from urllib.request import Request, urlopen

import msgspec
from django.conf import settings

from cair_site.errors import ApiError
from dialogue.api import (
    ActionMessage,
    DialogueRequest,
    QuestionMessage,
    TurnRequest,
    answer_dialogue,
    reply_json,
    state_for,
)
from dialogue.engine.content import Content
from dialogue.engine.state import DialogueState
from dialogue.turns import take_turn, understand, write_state
from plans.api import Json, plan_json
from plans.engine.manager import PlanAnswer

logger = logging.getLogger(__name__)

PLAN_FIELDS = ("plan_sentence", "plan", "plan_actions")


class PlanSaid(msgspec.Struct):
    """What a turn needs of a Plan Manager's answer."""

    intent: str
    plan_sentence: str
    plan: str
    plan_actions: list[ActionMessage]
    kbplan_actions: list[ActionMessage]
    question: QuestionMessage | None = None


class DialogueSaid(msgspec.Struct):
    """What a turn needs of a Dialogue Manager's answer."""

    dialogue_state: str
    dialogue_sentence: str
    plan_sentence: str
    plan: str
    plan_actions: list[ActionMessage]
    topic: str
    sentence_type: str


@dataclass(frozen=True, slots=True)
class Services:
    """The Plan Manager and the Dialogue Manager, wherever they are."""

    def turn(self, content: Content, asked: TurnRequest, sentence: str) -> Json:
        """Return the answer of one turn."""
        state = state_for(content, asked)
        if settings.CAIR_PLAN_MANAGER_URL or settings.CAIR_DIALOGUE_MANAGER_URL:
            return _turn_over_http(content, asked, state, sentence)
        taken = take_turn(content, state, sentence, capabilities=asked.capabilities)
        return reply_json(taken.reply, taken.plan)


def _turn_over_http(
    content: Content, asked: TurnRequest, state: DialogueState, sentence: str
) -> Json:
    """Ask the services that live elsewhere; a silent Plan Manager costs its plan, not the talk."""
    understood = _plan(content, asked, state, sentence)
    reply = _dialogue(content, asked, state, sentence, understood)
    waiting = understood["question"] is not None
    if not waiting and not reply["plan"] and not reply["plan_sentence"]:
        reply |= {name: understood[name] for name in PLAN_FIELDS}
    return reply


def _plan(content: Content, asked: TurnRequest, state: DialogueState, sentence: str) -> Json:
    url = settings.CAIR_PLAN_MANAGER_URL
    if not url:
        return plan_json(understand(content, state, sentence, asked.capabilities))
    body: Json = {
        "client_sentence": sentence,
        "language": state.language,
        "culture": state.culture,
        "capabilities": asked.capabilities,
    }
    try:
        return _post(url, body, PlanSaid)
    except ApiError:
        logger.warning("The Plan Manager does not answer: this turn has no plan.")
        return plan_json(PlanAnswer())


def _dialogue(
    content: Content, asked: TurnRequest, state: DialogueState, sentence: str, understood: Json
) -> Json:
    request = DialogueRequest(
        client_sentence=sentence,
        dialogue_state=write_state(state),
        capabilities=asked.capabilities,
        intent=str(understood["intent"]),
        kbplan_actions=msgspec.convert(understood["kbplan_actions"], list[ActionMessage]),
        question=msgspec.convert(understood["question"], QuestionMessage | None),
    )
    url = settings.CAIR_DIALOGUE_MANAGER_URL
    if url:
        return _post(url, msgspec.to_builtins(request), DialogueSaid)
    return answer_dialogue(content, request, state)


def _post(url: str, body: Json, expected: type[PlanSaid | DialogueSaid]) -> Json:
    """Return a service's answer. Raises ApiError where it is silent or answers nonsense."""
    request = Request(  # noqa: S310 - the operator's own setting, http or https (checked)
        url, data=msgspec.json.encode(body), headers={"Content-Type": "application/json"}
    )
    try:
        with urlopen(request, timeout=settings.CAIR_SERVICE_SECONDS) as answer:  # noqa: S310
            text = answer.read(settings.CAIR_LONGEST_INFLATED)
        said = msgspec.json.decode(text, type=expected)
    except (URLError, OSError, HTTPException, ValueError) as error:
        raise ApiError("service.unreachable") from error
    return msgspec.convert(msgspec.to_builtins(said), Json)
