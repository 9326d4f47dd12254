"""What an intent must keep besides its triggers: known slots, lists, actions and parameters."""

from collections import Counter
from collections.abc import Iterator, Mapping

from plans.engine.actions import ACTIONS_BY_NAME
from plans.engine.fill import slots_in
from plans.engine.intents import SLOT_KINDS, ActionItem, Intent, Library
from plans.engine.kb_actions import KB_ACTIONS_BY_NAME
from plans.engine.problems import Problem

_CLIENT: Mapping[str, frozenset[str]] = {
    name: frozenset(parameter.name for parameter in action.parameters)
    for name, action in ACTIONS_BY_NAME.items()
}
_KB: Mapping[str, frozenset[str]] = {
    name: frozenset(action.parameters) for name, action in KB_ACTIONS_BY_NAME.items()
}


def library_problems(library: Library, languages: frozenset[str]) -> Iterator[Problem]:
    """Yield everything that is wrong outside the triggers."""
    yield from _twice("intent", [intent.key for intent in library.intents])
    yield from _twice("intent number", [str(intent.number) for intent in library.intents])
    yield from _twice("value list", [values.key for values in library.values])
    yield from _twice("phrase", [phrase.key for phrase in library.phrases])
    lists = {values.key: frozenset(values.values) for values in library.values}
    for intent in library.intents:
        yield from _slot_problems(intent, lists)
        yield from _action_problems(intent, intent.plan, _CLIENT)
        yield from _action_problems(intent, intent.kbplan, _KB)
        yield from _sentence_problems(intent)
        for language in sorted(intent.triggers.keys() - languages):
            yield Problem(intent.key, language, "", -1, "An unknown language")


def _twice(kind: str, keys: list[str]) -> Iterator[Problem]:
    for key, number in Counter(keys).items():
        if number > 1:
            yield Problem(key, "", "", -1, f"This {kind} exists {number} times")


def _slot_problems(intent: Intent, lists: Mapping[str, frozenset[str]]) -> Iterator[Problem]:
    yield from _twice(f"slot of {intent.key}", [slot.name for slot in intent.slots])
    for slot in intent.slots:
        if slot.list_key:
            for language in sorted(intent.triggers.keys() - lists.get(slot.list_key, frozenset())):
                message = f"Value list {slot.list_key!r} does not exist"
                yield Problem(intent.key, language, slot.kind, 0, message)
        elif slot.kind not in SLOT_KINDS:
            message = f"Slot {slot.name!r} is of no known kind"
            yield Problem(intent.key, "", slot.kind, 0, message)


def _action_problems(
    intent: Intent, plan: tuple[ActionItem, ...], table: Mapping[str, frozenset[str]]
) -> Iterator[Problem]:
    slots = {slot.name for slot in intent.slots}
    for item in plan:
        if item.action not in table:
            yield Problem(intent.key, "", item.action, 0, "There is no such action")
            continue
        for name, value in item.parameters:
            if name not in table[item.action]:
                message = f"Action {item.action!r} has no such parameter"
                yield Problem(intent.key, "", name, 0, message)
            for missing in sorted(slots_in(value) - slots):
                yield Problem(intent.key, "", value, 0, f"Slot {missing!r} is not declared")


def _sentence_problems(intent: Intent) -> Iterator[Problem]:
    slots = {slot.name for slot in intent.slots}
    for language, sentences in intent.plan_sentences.items():
        for sentence in sentences:
            for missing in sorted(slots_in(sentence.text) - slots):
                place = sentence.text.find(f"{{{missing}")
                message = f"Slot {missing!r} is not declared"
                yield Problem(intent.key, language, sentence.text, place, message)
