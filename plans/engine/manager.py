"""The Plan Manager: a sentence in, a plan or a KBplan with its plan sentence out."""

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, field
from random import Random
from types import MappingProxyType

from languages.known import LANGUAGES
from plans.engine.catalogue import Catalogue, IntentMatch
from plans.engine.fill import FilledAction as Action
from plans.engine.fill import clean, fill_actions, fill_text, kbplan_string, plan_string
from plans.engine.intents import Intent, PlanSentence

__all__ = ["Action", "PlanAnswer", "answer", "carry_out"]


def _nothing() -> Mapping[str, str]:
    return MappingProxyType({})


@dataclass(frozen=True, slots=True)
class PlanAnswer:
    """What the Plan Manager answers; all empty when nothing matches.

    `missing` is the first required slot nobody filled and `question` the sentence that asks for
    it; the plan then carries None, so a client may also ask by itself.
    """

    intent: str = ""
    parameters: Mapping[str, str] = field(default_factory=_nothing)
    plan_sentence: str = ""
    plan: str = ""
    plan_actions: tuple[Action, ...] = ()
    kbplan: str = ""
    kbplan_actions: tuple[Action, ...] = ()
    steps: tuple[str, ...] = ()
    missing: str = ""
    question: str = ""


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
    match = catalogue.match(sentence, language)
    if match is None:
        return PlanAnswer(steps=("No intent fits the sentence.",))
    circumstances = _Circumstances(language, culture, capabilities, chance)
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
    values = {name: cleaned for name, value in parameters.items() if (cleaned := clean(value))}
    wanted = fill_actions(intent.plan, values)
    actions = _possible(wanted, circumstances.capabilities)
    kb_actions = fill_actions(intent.kbplan, values)
    impossible = bool(wanted) and not actions
    missing, question = ("", "") if impossible else _missing(intent, values, circumstances)
    return PlanAnswer(
        intent=intent.key,
        parameters=MappingProxyType(values),
        plan_sentence=(
            _cannot(catalogue, wanted[0].action, circumstances)
            if impossible
            else _sentence(intent, values, circumstances)
        ),
        plan=plan_string(actions),
        plan_actions=actions,
        kbplan=kbplan_string(kb_actions),
        kbplan_actions=kb_actions,
        steps=(*steps, *_capability_steps(wanted, actions)),
        missing=missing,
        question=question,
    )


def _possible(
    actions: tuple[Action, ...], capabilities: Collection[str] | None
) -> tuple[Action, ...]:
    if capabilities is None:
        return actions
    return tuple(action for action in actions if action.action in capabilities)


def _capability_steps(wanted: Iterable[Action], kept: tuple[Action, ...]) -> tuple[str, ...]:
    return tuple(
        f"Left out {action.action}: this robot cannot do it."
        for action in wanted
        if action not in kept
    )


def _missing(
    intent: Intent, values: Mapping[str, str], circumstances: _Circumstances
) -> tuple[str, str]:
    for slot in intent.slots:
        if slot.required and slot.name not in values:
            return slot.name, slot.questions.get(circumstances.language, "")
    return "", ""


def _cannot(catalogue: Catalogue, action: str, circumstances: _Circumstances) -> str:
    """Return why nothing is done: the action's own words, or the general ones."""
    for name in (action, "do"):
        sentences = catalogue.cannot.get(name, {}).get(circumstances.language, ())
        if sentences:
            return circumstances.chance.choice(sentences)
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
