"""The Plan Manager: a sentence in, a plan or a KBplan with its plan sentence out."""

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, field
from random import Random
from types import MappingProxyType

from languages.known import LANGUAGES
from plans.engine.capabilities import able, can_do
from plans.engine.catalogue import Catalogue, IntentMatch
from plans.engine.fill import FilledAction as Action
from plans.engine.fill import clean, fill_actions, fill_text, kbplan_string, plan_string
from plans.engine.intents import Intent, PlanSentence
from plans.engine.sayings import CANNOT, CANNOT_ACTION, CANNOT_ALL, CANNOT_DO, DID_YOU_MEAN

__all__ = ["Action", "PlanAnswer", "Question", "answer", "carry_out"]


def _nothing() -> Mapping[str, str]:
    return MappingProxyType({})


@dataclass(frozen=True, slots=True)
class Question:
    """What the agent asks before it acts: "Which song?" or "Did you want me to play a song?".

    `slot` is the required slot nobody filled, "" where the person only has to say yes.
    """

    intent: str
    slot: str
    parameters: Mapping[str, str]
    text: str


@dataclass(frozen=True, slots=True)
class PlanAnswer:
    """What the Plan Manager answers; all empty when nothing matches.

    Where `question` asks for a missing parameter the plan carries None, so a client may also ask
    by itself; where it asks whether something was meant there is no intent and no plan.
    """

    intent: str = ""
    parameters: Mapping[str, str] = field(default_factory=_nothing)
    plan_sentence: str = ""
    plan: str = ""
    plan_actions: tuple[Action, ...] = ()
    kbplan: str = ""
    kbplan_actions: tuple[Action, ...] = ()
    steps: tuple[str, ...] = ()
    question: Question | None = None


@dataclass(frozen=True, slots=True)
class _Circumstances:
    """For whom a plan is made: language, culture, what the client can do, and chance."""

    language: str
    culture: str
    capabilities: Collection[str] | None
    chance: Random


def answer(  # noqa: PLR0913 (the circumstances of a turn, all by name)
    catalogue: Catalogue,
    sentence: str,
    language: str,
    *,
    culture: str = "",
    chance: Random,
    capabilities: Collection[str] | None = None,
) -> PlanAnswer:
    """Return the plan a sentence asks for; all empty when it asks for nothing."""
    circumstances = _Circumstances(language, culture, capabilities, chance)
    match = catalogue.match(sentence, language)
    if match is None:
        return _nearly(catalogue, sentence, circumstances)
    steps = _match_steps(match)
    return _planned(catalogue, match.intent, match.parameters, circumstances, steps)


def carry_out(  # noqa: PLR0913 (the circumstances of a turn, all by name)
    catalogue: Catalogue,
    intent_key: str,
    parameters: Mapping[str, str],
    language: str,
    *,
    culture: str = "",
    chance: Random,
    capabilities: Collection[str] | None = None,
) -> PlanAnswer:
    """Return the plan of an accepted proposal; all empty when the intent is gone."""
    intent = catalogue.intents.get(intent_key)
    if intent is None:
        return PlanAnswer(steps=(f"There is no intent {intent_key!r}.",))
    circumstances = _Circumstances(language, culture, capabilities, chance)
    steps = (f"The person accepted {intent_key}.",)
    return _planned(catalogue, intent, parameters, circumstances, steps)


def _nearly(catalogue: Catalogue, sentence: str, circumstances: _Circumstances) -> PlanAnswer:
    """Return the question whether something nearly understood was meant; never a plan."""
    nothing = PlanAnswer(steps=("No intent fits the sentence.",))
    match = catalogue.suggest(sentence, circumstances.language)
    if match is None or not can_do(match.intent, circumstances.capabilities):
        return nothing
    text = _saying(catalogue, (DID_YOU_MEAN,), match.intent, circumstances)
    if not text:
        return nothing
    values = _cleaned(match.parameters)
    question = Question(match.intent.key, "", values, text)
    return PlanAnswer(steps=(*nothing.steps, f"Perhaps {match.why}."), question=question)


def _match_steps(match: IntentMatch) -> tuple[str, ...]:
    runner_up = f"The runner-up is {match.runner_up}." if match.runner_up else "No runner-up."
    return (f"Intent {match.intent.key}: {match.why}.", runner_up)


def _planned(
    catalogue: Catalogue,
    intent: Intent,
    parameters: Mapping[str, str],
    circumstances: _Circumstances,
    steps: tuple[str, ...],
) -> PlanAnswer:
    values = _cleaned(parameters)
    wanted = fill_actions(intent.plan, values)
    actions = tuple(one for one in wanted if able(one.action, circumstances.capabilities))
    kb_actions = fill_actions(intent.kbplan, values)
    impossible = bool(wanted) and not actions
    return PlanAnswer(
        intent=intent.key,
        parameters=values,
        plan_sentence=(
            _saying(catalogue, _cannot(wanted, actions), intent, circumstances)
            if len(actions) < len(wanted)
            else _sentence(intent, values, circumstances)
        ),
        plan=plan_string(actions),
        plan_actions=actions,
        kbplan=kbplan_string(kb_actions),
        kbplan_actions=kb_actions,
        steps=(*steps, *_capability_steps(wanted, actions)),
        question=None if impossible else _question(intent, values, circumstances),
    )


def _cleaned(parameters: Mapping[str, str]) -> Mapping[str, str]:
    cleaned = ((name, clean(value)) for name, value in parameters.items())
    return MappingProxyType({name: value for name, value in cleaned if value})


def _capability_steps(wanted: Iterable[Action], kept: tuple[Action, ...]) -> tuple[str, ...]:
    return tuple(
        f"Left out {action.action}: this robot cannot do it."
        for action in wanted
        if action not in kept
    )


def _question(
    intent: Intent, values: Mapping[str, str], circumstances: _Circumstances
) -> Question | None:
    """Return the question for the first required slot that nobody filled."""
    for slot in intent.slots:
        if slot.required and slot.name not in values:
            text = slot.questions.get(circumstances.language, "")
            return Question(intent.key, slot.name, values, text) if text else None
    return None


def _cannot(wanted: tuple[Action, ...], actions: tuple[Action, ...]) -> tuple[str, ...]:
    """Return the sayings that tell what cannot be done, the most fitting first."""
    if actions:
        return (CANNOT_ALL, CANNOT_DO)
    return (f"{CANNOT_ACTION}{wanted[0].action}", CANNOT, CANNOT_DO)


def _saying(
    catalogue: Catalogue, keys: tuple[str, ...], intent: Intent, circumstances: _Circumstances
) -> str:
    """Return a sentence of the first saying that can be said of this intent, "" without any."""
    language = circumstances.language
    can = {"can": intent.abilities[language]} if language in intent.abilities else {}
    for key in keys:
        sentences = catalogue.sayings.get(key, {}).get(language, ())
        said = [text for one in sentences if (text := fill_text(one, can)) is not None]
        if said:
            return circumstances.chance.choice(said)
    return ""


def _sentence(intent: Intent, values: Mapping[str, str], circumstances: _Circumstances) -> str:
    """Return one of the plan sentences that can be said here, "" where there is none."""
    spoken = _spoken(intent, values, circumstances.language)
    filled = [
        text
        for sentence in intent.plan_sentences.get(circumstances.language, ())
        if _fits_culture(sentence, circumstances.culture)
        and (text := fill_text(sentence.text, spoken)) is not None
    ]
    return circumstances.chance.choice(filled) if filled else ""


def _fits_culture(sentence: PlanSentence, culture: str) -> bool:
    return not sentence.only or culture in sentence.only


def _spoken(intent: Intent, values: Mapping[str, str], language: str) -> dict[str, str]:
    """Return the values as the agent says them: the topic "my wife" becomes "your wife"."""
    known = LANGUAGES.get(language)
    topics = {slot.name for slot in intent.slots if slot.kind == "topic"}
    return {
        name: known.their_words(value) if known and name in topics else value
        for name, value in values.items()
    }
