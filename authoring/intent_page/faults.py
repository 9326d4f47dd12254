"""What is wrong or doubtful in the lines of an intent's form, each with its place."""

from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass

from django.utils.translation import gettext as _

from authoring.intent_page.posted import Line, Posted
from plans import models
from plans.engine.actions import ACTIONS_BY_NAME
from plans.engine.fill import slots_in
from plans.engine.intents import ActionItem, Slot
from plans.engine.kb_actions import KB_ACTIONS_BY_NAME
from plans.engine.patterns import PatternError, Sequence, parse_options, parse_pattern
from plans.engine.rules import breaches
from plans.engine.sayings import is_saying

ERROR, WARNING = "error", "warning"
Phrases = Mapping[str, Mapping[str, Sequence]]


@dataclass(frozen=True, slots=True)
class Fault:
    """What is wrong in one line; `position` counts its characters from 0, -1: no place."""

    name: str
    level: str
    message: str
    position: int = -1


def readable_phrases() -> Phrases:
    """Return the phrases of the draft by language and name; those that are broken are missing."""
    found: dict[str, dict[str, Sequence]] = defaultdict(dict)
    for key, texts in models.Phrase.objects.values_list("key", "texts"):
        for code, text in texts.items():
            if text and not is_saying(key):
                try:
                    found[code][key] = parse_options(text)
                except PatternError:
                    continue
    return found


def trigger_fault(
    text: str, slots: Collection[Slot], phrases: Mapping[str, Sequence]
) -> tuple[str, int] | None:
    """Return what is wrong with a trigger sentence and where, None where all is well."""
    try:
        sequence = parse_pattern(text)
    except PatternError as error:
        return error.message, error.position
    for breach in breaches(sequence, {slot.name: slot for slot in slots}, phrases):
        return breach.message, max(text.find(breach.near), 0) if breach.near else -1
    return None


def undeclared(text: str, slots: Collection[Slot]) -> tuple[str, int] | None:
    """Return which `{parameter}` of a text is not declared and where it stands, or None."""
    missing = sorted(slots_in(text) - {slot.name for slot in slots})
    if not missing:
        return None
    message = _("There is no parameter {%(name)s}. Add it under “Parameters”, or correct the name.")
    return message % {"name": missing[0]}, text.find(f"{{{missing[0]}}}")


def action_fault(item: ActionItem, slots: Collection[Slot], client: bool) -> str:
    """Return what is wrong with an action, "" where all is well."""
    if item.action not in (ACTIONS_BY_NAME if client else KB_ACTIONS_BY_NAME):
        return _("There is no action %(name)s. Choose one of the list, or none.") % {
            "name": item.action
        }
    for name, value in item.parameters:
        if name not in _parameters(item.action, client):
            return _("%(action)s takes no %(name)s.") % {"action": item.action, "name": name}
        missing = undeclared(value, slots)
        if missing:
            return missing[0]
    return ""


def _parameters(action: str, client: bool) -> Collection[str]:
    if client:
        return [one.name for one in ACTIONS_BY_NAME[action].parameters]
    return KB_ACTIONS_BY_NAME[action].parameters


def faults(posted: Posted) -> list[Fault]:
    """Return all faults of a form, and the lines that are written twice; two queries."""
    slots, phrases = posted.intent.slots, readable_phrases()
    found = []
    for line in posted.triggers:
        fault = trigger_fault(line.text, slots, phrases.get(line.language, {}))
        if fault:
            found.append(Fault(line.name, ERROR, *fault))
    for line in posted.sentences:
        fault = undeclared(line.text, slots)
        if fault:
            found.append(Fault(line.name, ERROR, *fault))
    for name, item in posted.actions:
        message = action_fault(item, slots, name.startswith("plan_"))
        if message:
            found.append(Fault(name, ERROR, message))
    return [
        *found,
        *duplicates(posted.triggers, posted.intent.number),
        *_again(posted.sentences),
        *_again(posted.tests),
    ]


def duplicates(lines: Iterable[Line], number: int) -> Iterator[Fault]:
    """Yield the trigger sentences that are written twice, here or in another intent; one query."""
    kept = list(lines)
    yield from _again(kept)
    texts = {line.text for line in kept}
    rows = models.Trigger.objects.filter(text__in=texts).exclude(intent_id=number)
    elsewhere: dict[tuple[str, str], str] = {
        (language, text): key
        for language, text, key in rows.values_list("language", "text", "intent__key")
    }
    for line in kept:
        key = elsewhere.get((line.language, line.text))
        if key:
            message = _("%(intent)s has the same sentence. Only one of the two can win.")
            yield Fault(line.name, WARNING, message % {"intent": key})


def _again(lines: Iterable[Line]) -> Iterator[Fault]:
    seen: set[tuple[str, str]] = set()
    for line in lines:
        same = (line.language, " ".join(line.text.casefold().split()))
        if same in seen:
            yield Fault(line.name, WARNING, _("This sentence is here twice. Remove one."))
        seen.add(same)
