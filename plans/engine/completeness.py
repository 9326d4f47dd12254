"""What every intent should have, and what a library holds that nobody uses."""

from collections import defaultdict
from collections.abc import Collection, Iterator

from languages.known import LANGUAGES
from plans.engine.actions import ACTIONS, ACTIONS_BY_NAME
from plans.engine.fill import slots_in
from plans.engine.intents import Intent, Library, ValueList
from plans.engine.matchers.patterns_compiler import (
    FILLERS,
    NOT_A_TOPIC,
    NOT_IN_TOPIC,
    SKIP_END,
    SKIP_START,
    SOUNDS,
    TOPIC_EDGES,
)
from plans.engine.patterns import PhraseUse, parts_of
from plans.engine.reading import units_of
from plans.engine.remarks import Remark
from plans.engine.sayings import CANNOT, CANNOT_ACTION, CANNOT_ALL, CANNOT_DO, DID_YOU_MEAN
from plans.engine.trigger_samples import parsed

FEWEST_TRIGGERS, MOST_TRIGGERS = 8, 15
FEWEST_SAYS, MOST_SAYS = 3, 5
FEWEST_TESTS = 12
SAFETY = 100  # From this priority on there can never be too many triggers.
ONE_IN = 4  # Of so many tests one must be a sentence that must not match.

#: Phrases that the matcher reads by itself; no trigger has to name them.
ENGINE_PHRASES = frozenset((SKIP_START, SKIP_END, SOUNDS, FILLERS)) | frozenset(
    (TOPIC_EDGES, NOT_A_TOPIC, NOT_IN_TOPIC, CANNOT, CANNOT_DO, CANNOT_ALL, DID_YOU_MEAN)
)


def completeness(
    library: Library, *, intents: Collection[str] = (), languages: Collection[str] = ()
) -> list[Remark]:
    """Return what lacks; with `intents`, of these intents only."""
    codes = [code for code in LANGUAGES if code in (languages or LANGUAGES)]
    lists = {listed.key: listed for listed in library.values}
    found: list[Remark] = []
    for intent in library.intents:
        if intent.key in (intents or [intent.key]):
            found += _values(intent, lists)
            for code in codes:
                found += _speech(intent, code)
    if not intents:
        found += [*_unused(library), *_ambiguous(library, codes), *_unserved(library, codes)]
    return found


def _speech(intent: Intent, code: str) -> Iterator[Remark]:
    if intent.triggers and code not in intent.triggers:
        written = ", ".join(intent.triggers)
        text = f"There are triggers in {written} only."
        yield Remark("C011", intent.key, code, text, error=True)
    elif code in intent.triggers:
        yield from _questions(intent, code)
        yield from _bars(intent, code)
        yield from _sayable(intent, code)


def _questions(intent: Intent, code: str) -> Iterator[Remark]:
    for slot in intent.slots:
        if slot.required and not slot.questions.get(code):
            text = f"The slot {slot.name} is required, but no question asks for it."
            yield Remark("C010", intent.key, code, text, error=True)


def _bars(intent: Intent, code: str) -> Iterator[Remark]:
    tests = intent.tests.get(code, ())
    refused = sum(test.parameters is None for test in tests)
    if not tests:
        yield Remark("C011", intent.key, code, "There are no tests.", error=True)
    if intent.abilities and code not in intent.abilities:
        yield Remark("C011", intent.key, code, "What the agent can do is not named.")
    most_triggers = None if intent.priority >= SAFETY else MOST_TRIGGERS
    for text in (
        _bar("triggers", len(intent.triggers[code]), FEWEST_TRIGGERS, most_triggers),
        _bar("plan sentences", len(intent.plan_sentences.get(code, ())), FEWEST_SAYS, MOST_SAYS),
        _bar("tests", len(tests), FEWEST_TESTS) if tests else "",
        _bar("tests that must not match", refused, -(-len(tests) // ONE_IN)),
    ):
        if text:
            yield Remark("C012", intent.key, code, text)


def _bar(what: str, number: int, fewest: int, most: int | None = None) -> str:
    """Return what is wrong with a number, "" where it is within the bars."""
    if fewest <= number and (most is None or number <= most):
        return ""
    wanted = f"at least {fewest}" if most is None else f"{fewest} to {most}"
    return f"{number} {what}; there should be {wanted}."


def _sayable(intent: Intent, code: str) -> Iterator[Remark]:
    sentences = intent.plan_sentences.get(code, ())
    if sentences and all(slots_in(each.text) or each.only for each in sentences):
        text = (
            "Every plan sentence needs a slot or is for some cultures only; "
            "write one that can always be said."
        )
        yield Remark("C013", intent.key, code, text, error=True, near=sentences[0].text)


def _values(intent: Intent, lists: dict[str, ValueList]) -> Iterator[Remark]:
    """Yield the values of a list that the parameter they are meant for does not take."""
    by_slot = {slot.name: lists.get(slot.list_key) for slot in intent.slots if slot.list_key}
    for item in intent.plan:
        known = ACTIONS_BY_NAME.get(item.action)
        allowed = {one.name: one.values for one in known.parameters} if known else {}
        for name, template in item.parameters:
            listed = by_slot.get(template.strip("{}"))
            strange = sorted(_canonical(listed) - set(allowed.get(name, ()))) if listed else []
            if strange and allowed.get(name):
                text = (
                    f"{item.action} takes no {name}={', '.join(strange)}; "
                    f"it takes {', '.join(allowed[name])}."
                )
                yield Remark("C009", intent.key, "", text, error=True)


def _canonical(listed: ValueList) -> set[str]:
    return {value for values in listed.values.values() for value in values}


def _unused(library: Library) -> Iterator[Remark]:
    used = _used_phrases(library)
    for phrase in library.phrases:
        if phrase.key not in used and not _of_the_engine(phrase.key):
            text = "No trigger uses this phrase; delete it."
            yield Remark("C006", f"<{phrase.key}>", "", text)
    kinds = {slot.list_key for intent in library.intents for slot in intent.slots}
    for listed in library.values:
        if listed.key not in kinds:
            yield Remark("C007", listed.key, "", "No slot uses this value list; delete it.")


def _used_phrases(library: Library) -> set[str]:
    return {
        part.name
        for intent in library.intents
        for texts in intent.triggers.values()
        for text in texts
        for part in parts_of(parsed(text))
        if isinstance(part, PhraseUse)
    }


def _of_the_engine(key: str) -> bool:
    """Say whether the engine itself reads this phrase: skip words, articles, what it cannot do."""
    excuse = key.removeprefix(CANNOT_ACTION)
    return key in ENGINE_PHRASES or (excuse != key and excuse in ACTIONS_BY_NAME)


def _ambiguous(library: Library, codes: list[str]) -> Iterator[Remark]:
    for listed in library.values:
        for code in codes:
            meanings: defaultdict[tuple[str, ...], set[str]] = defaultdict(set)
            for value, words in listed.values.get(code, {}).items():
                for word in words:
                    meanings[units_of(word, LANGUAGES[code])].add(value)
            for units, values in meanings.items():
                if len(values) > 1:
                    text = f"'{' '.join(units)}' means {' and '.join(sorted(values))}."
                    yield Remark("C008", listed.key, code, text, error=True)


def _unserved(library: Library, codes: list[str]) -> Iterator[Remark]:
    asked = {
        (item.action, code)
        for intent in library.intents
        for code in intent.triggers
        for item in intent.plan
    }
    for action in ACTIONS:
        lacking = [code for code in codes if (action.name, code) not in asked]
        if lacking:
            text = f"No intent asks for this action in {', '.join(lacking)}."
            yield Remark("C014", action.name, "", text)
