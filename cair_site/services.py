"""The Hub's way to the two managers: called in this process, or over HTTP where they live apart.

Apart, a turn takes CAIR_SERVICE_SECONDS at most. The Plan Manager may use a third of them; while
it is silent, people go on talking without plans. While the Dialogue Manager is silent they are
asked to try again with the state they have, which nobody has changed.
"""

import logging
import time
from dataclasses import dataclass
from typing import NamedTuple

import msgspec
from django.conf import settings

from cair_site.elsewhere import Call, SilentError, elsewhere
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
from dialogue.engine.codec import StateError
from dialogue.engine.content import Content
from dialogue.engine.state import DialogueState
from dialogue.turns import (
    read_state,
    take_turn,
    take_turn_without_asking,
    understand,
    write_state,
)
from plans.api import Json, plan_json
from plans.choices import UnknownChoiceError
from plans.engine.manager import PlanAnswer
from plans.timing import DIALOGUE, MATCH, lap

logger = logging.getLogger(__name__)

PLAN_FIELDS = ("plan_sentence", "plan", "plan_actions")
PLAN_SHARE = 1 / 3


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


class Taken(NamedTuple):
    """A turn that is being taken.

    A client that does not answer the agent's question for a parameter gets its plan with None.
    """

    content: Content
    capabilities: list[str] | None
    state: DialogueState
    sentence: str
    answers: bool = True


class Told(NamedTuple):
    """What an existing client is told, and the state after it."""

    state: DialogueState
    plan: str
    plan_sentence: str
    sentence: str
    sentence_type: str


@dataclass(frozen=True, slots=True)
class Services:
    """The Plan Manager and the Dialogue Manager, wherever they are."""

    def turn(self, content: Content, asked: TurnRequest, sentence: str) -> Json:
        """Return the answer of one turn."""
        state = state_for(content, asked)
        if _apart():
            return _turn_over_http(Taken(content, asked.capabilities, state, sentence))
        taken = take_turn(content, state, sentence, capabilities=asked.capabilities)
        return reply_json(taken.reply, taken.plan)

    def turn_without_asking(self, content: Content, state: DialogueState, sentence: str) -> Told:
        """Return what is said to a client that asks for missing parameters itself."""
        if _apart():
            told = _turn_over_http(Taken(content, None, state, sentence, answers=False))
            return Told(
                read_state(str(told["dialogue_state"])),
                str(told["plan"]),
                str(told["plan_sentence"]),
                str(told["dialogue_sentence"]),
                str(told["sentence_type"]),
            )
        taken = take_turn_without_asking(content, state, sentence)
        plan, said = taken.plan, taken.reply
        return Told(said.state, plan.plan, plan.plan_sentence, said.sentence, said.sentence_type)


def _apart() -> bool:
    return bool(settings.CAIR_PLAN_MANAGER_URL or settings.CAIR_DIALOGUE_MANAGER_URL)


def _turn_over_http(turn: Taken) -> Json:
    """Ask the services that live elsewhere; a silent Plan Manager costs its plan, not the talk."""
    began, seconds = time.monotonic(), settings.CAIR_SERVICE_SECONDS
    understood = _plan(turn, began + PLAN_SHARE * seconds)
    question = understood["question"]
    if isinstance(question, dict) and question["slot"] and not turn.answers:
        understood["question"] = None
    reply = _dialogue(turn, understood, began + seconds)
    if not reply["plan"] and not reply["plan_sentence"] and not _asks(reply, understood):
        reply |= {name: understood[name] for name in PLAN_FIELDS}
    return reply


def _asks(reply: Json, understood: Json) -> bool:
    """Say whether the plan waits for an answer: the Dialogue Manager decided, its state tells."""
    try:
        return read_state(str(reply["dialogue_state"])).pending is not None
    except (StateError, UnknownChoiceError):  # Of a newer version, in the middle of an update.
        return understood["question"] is not None


def _plan(turn: Taken, until: float) -> Json:
    url, state, capabilities = settings.CAIR_PLAN_MANAGER_URL, turn.state, turn.capabilities
    if not url:
        return plan_json(understand(turn.content, state, turn.sentence, capabilities))
    body: Json = {
        "client_sentence": turn.sentence,
        "language": state.language,
        "culture": state.culture,
        "capabilities": capabilities,
        "seed": state.seed,
        "turn": state.turn,
    }
    try:
        with lap(MATCH):
            return _post(url, body, PlanSaid, until)
    except SilentError as error:
        logger.warning("The Plan Manager is silent, this turn has no plan: %s.", error)
        return plan_json(PlanAnswer())


def _dialogue(turn: Taken, understood: Json, until: float) -> Json:
    request = DialogueRequest(
        client_sentence=turn.sentence,
        dialogue_state=write_state(turn.state),
        capabilities=turn.capabilities,
        intent=str(understood["intent"]),
        plan_sentence=str(understood["plan_sentence"]),
        kbplan_actions=msgspec.convert(understood["kbplan_actions"], list[ActionMessage]),
        question=msgspec.convert(understood["question"], QuestionMessage | None),
    )
    url = settings.CAIR_DIALOGUE_MANAGER_URL
    if not url:
        return answer_dialogue(turn.content, request, turn.state)
    try:
        with lap(DIALOGUE):
            return _post(url, msgspec.to_builtins(request), DialogueSaid, until)
    except SilentError as error:
        logger.warning("The Dialogue Manager is silent: %s.", error)
        raise ApiError("service.unreachable") from error


def _post(url: str, body: Json, expected: type[PlanSaid | DialogueSaid], until: float) -> Json:
    """Return a service's answer. Raises SilentError where it is silent or answers nonsense."""
    call = Call(msgspec.json.encode(body), _headers(), until, settings.CAIR_LONGEST_INFLATED)
    text = elsewhere(url).post(call)
    try:
        said = msgspec.json.decode(text, type=expected)
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        raise SilentError("it answered nonsense") from error
    return msgspec.convert(msgspec.to_builtins(said), Json)


def _headers() -> dict[str, str]:
    key = getattr(settings, "CAIR_SERVICE_KEY", "")
    return {"Content-Type": "application/json"} | (
        {"Authorization": f"Api-Key {key}"} if key else {}
    )
