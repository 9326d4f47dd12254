"""One turn, from a client's values to the answer's values: plan, then dialogue (paper, "Hub")."""

from collections.abc import Collection
from dataclasses import dataclass, replace

from django.conf import settings

from dialogue.engine.chance import chance_for
from dialogue.engine.codec import decode, encode
from dialogue.engine.content import Content
from dialogue.engine.manager import Reply, reply, start
from dialogue.engine.state import DialogueState, Pending
from dialogue.engine.turn import Asking, Heard
from languages.known import LANGUAGES
from plans.choices import UnknownChoiceError as UnknownChoiceError
from plans.choices import language_code
from plans.engine.manager import PlanAnswer, Question, answer
from plans.timing import DECODE, DIALOGUE, ENCODE, MATCH, lap

NO_PLAN = PlanAnswer()
URGENT = 100  # the priority of intents by which people ask for help
MOST_SEED = 2**32 - 1


@dataclass(frozen=True, slots=True)
class TurnAnswer:
    """What a turn gives back: the plan (if any), the reply, and the plan the client gets."""

    understood: PlanAnswer
    reply: Reply

    @property
    def plan(self) -> PlanAnswer:
        """Return the plan of an accepted offer, else the one the person asked for.

        None yet where a parameter was asked for: the plan waits for the answer.
        """
        if self.reply.state.pending is not None:
            return NO_PLAN
        return self.reply.plan or self.understood


def state_keys() -> list[bytes]:
    """Return the keys of states, the newest first."""
    return [key.encode() for key in settings.CAIR_STATE_KEYS]


def read_state(text: str) -> DialogueState:
    """Return a client's state. Raises StateError."""
    with lap(DECODE):
        state = decode(text, state_keys(), longest=settings.CAIR_LONGEST_STATE)
    if state.language not in LANGUAGES:
        raise UnknownChoiceError("language", state.language, LANGUAGES)
    return state


def write_state(state: DialogueState) -> str:
    """Return the text a client keeps."""
    with lap(ENCODE):
        return encode(state, state_keys())


def first_turn(content: Content, language: str, culture: str, seed: int = 0) -> Reply:
    """Return the beginning of a talk. Raises UnknownChoiceError."""
    language, culture = chosen(content, language, culture)
    return start(content, language, culture, seed)


def chosen(content: Content, language: str, culture: str) -> tuple[str, str]:
    """Return the language and culture of a talk: what was asked for, else what goes with it.

    "it-IT" is Italian. Without a culture, the one whose usual language this is.
    """
    language = language_code(language or settings.CAIR_LANGUAGE)
    if not culture:
        usual = [one.code for one in content.knowledge.cultures if one.language == language]
        default = settings.CAIR_CULTURE
        return language, default if default in usual or not usual else usual[0]
    culture = culture.strip().upper()
    if culture not in content.cultures:
        raise UnknownChoiceError("culture", culture, content.cultures)
    return language, culture


def take_turn(
    content: Content,
    state: DialogueState,
    sentence: str,
    *,
    capabilities: Collection[str] | None = None,
    explain: bool = False,
) -> TurnAnswer:
    """Return what the agent answers: first the Plan Manager, then the Dialogue Manager."""
    understood = understand(content, state, sentence, capabilities)
    heard = heard_with(content, sentence, understood, capabilities, explain=explain)
    with lap(DIALOGUE):
        return TurnAnswer(understood, reply(content, state, heard))


def take_turn_without_asking(content: Content, state: DialogueState, sentence: str) -> TurnAnswer:
    """Return the answer for a client that asks for missing parameters itself: it gets None."""
    understood = understand(content, state, sentence, None)
    heard = heard_with(content, sentence, understood, None)
    if heard.asking and heard.asking.pending.slot:
        heard = replace(heard, asking=None)
    with lap(DIALOGUE):
        return TurnAnswer(understood, reply(content, state, heard))


def understand(
    content: Content, state: DialogueState, sentence: str, capabilities: Collection[str] | None
) -> PlanAnswer:
    """Return what the Plan Manager makes of a sentence."""
    with lap(MATCH):
        return answer(
            content.catalogue,
            sentence,
            state.language,
            culture=state.culture,
            chance=chance_for(state.seed, state.turn),
            capabilities=capabilities,
        )


def heard_with(
    content: Content,
    sentence: str,
    understood: PlanAnswer,
    capabilities: Collection[str] | None,
    *,
    explain: bool = False,
) -> Heard:
    """Return what the Dialogue Manager hears of a sentence and its plan."""
    intent = content.catalogue.intents.get(understood.intent)
    return Heard(
        sentence=sentence,
        kbplan_actions=understood.kbplan_actions,
        plan_matched=bool(intent and not understood.kbplan_actions),
        plan_said=bool(understood.plan_sentence),
        urgent=bool(intent and intent.priority >= URGENT),
        asking=_asking(content, understood.question),
        capabilities=capabilities,
        explain=explain,
    )


def _asking(content: Content, question: Question | None) -> Asking | None:
    """Return the question of the Plan Manager with what must be remembered until its answer."""
    intent = content.catalogue.intents.get(question.intent) if question else None
    if question is None or intent is None:
        return None
    known = tuple(question.parameters.items())
    return Asking(Pending(intent.number, question.slot, known), question.text)
