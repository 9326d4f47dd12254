"""What changes in the intents, phrases and value lists from one release to another."""

from collections.abc import Iterator

from authoring.releases.release_rows import (
    Change,
    Make,
    by_number,
    field_changes,
    list_changes,
    mapping_changes,
    order_changes,
)
from plans.engine.intents import ActionItem, Intent, IntentTest, Library, PlanSentence, Slot


def library_changes(old: Library, new: Library) -> Iterator[Change]:
    """Yield all changes of the intents and of the words they use."""
    if old == new:
        return
    before, after = by_number(old.intents), by_number(new.intents)
    for number in {**after, **before}:
        intent = after.get(number) or before[number]
        make = Make("intents", intent.key, number)
        if number not in before:
            yield make("added", "", str(sum(map(len, intent.triggers.values()))))
        elif number not in after:
            yield make("removed")
        else:
            yield from _intent(make, before[number], after[number])
    yield from order_changes(Make("intents", ""), list(before), list(after))
    yield from _vocabulary(old, new)


def _intent(make: Make, old: Intent, new: Intent) -> Iterator[Change]:
    if old == new:
        return
    if old.key != new.key:
        yield make("renamed", old.key, new.key)
    yield from field_changes(make, old, new, ("family", "priority", "note"))
    yield from mapping_changes(make, "ability", old.abilities, new.abilities)
    yield from mapping_changes(make, "slot", _slots(old), _slots(new))
    for code in {**old.triggers, **new.triggers}:
        triggers = old.triggers.get(code, ()), new.triggers.get(code, ())
        yield from list_changes(make, "trigger", *triggers, code)
    for code in {**old.plan_sentences, **new.plan_sentences}:
        before, after = ([*map(_says, x.plan_sentences.get(code, ()))] for x in (old, new))
        yield from list_changes(make, "says", before, after, code)
    for what in ("plan", "kbplan"):
        items = _plan(getattr(old, what)), _plan(getattr(new, what))
        if items[0] != items[1]:
            yield make(what, *items)
    for code in {**old.tests, **new.tests}:
        before, after = ([*map(_test, x.tests.get(code, ()))] for x in (old, new))
        yield from list_changes(make, "test", before, after, code)


def _slots(intent: Intent) -> dict[str, str]:
    return {slot.name: _slot(slot) for slot in intent.slots}


def _slot(slot: Slot) -> str:
    need = "required" if slot.required else "optional"
    asked = "".join(f"; {code}: {text}" for code, text in slot.questions.items())
    return f"{slot.kind}, {need}{asked}"


def _says(sentence: PlanSentence) -> str:
    return f"{sentence.text} ({' '.join(sentence.only)})" if sentence.only else sentence.text


def _plan(items: tuple[ActionItem, ...]) -> str:
    return "; ".join(
        " ".join((item.action, *(f"{name}={value}" for name, value in item.parameters)))
        for item in items
    )


def _test(test: IntentTest) -> str:
    if test.parameters is None:
        return f"{test.sentence} → ✗"
    values = ", ".join(f"{name}={value}" for name, value in test.parameters.items())
    return f"{test.sentence} → {values or '✓'}"


def _vocabulary(old: Library, new: Library) -> Iterator[Change]:
    phrases = ({one.key: one.texts for one in each.phrases} for each in (old, new))
    yield from _lists("phrase", *phrases)
    values = (
        {
            one.key: {
                f"{code} {value}": ", ".join(words)
                for code, meanings in one.values.items()
                for value, words in meanings.items()
            }
            for one in each.values
        }
        for each in (old, new)
    )
    yield from _lists("value", *values)


def _lists(
    what: str, old: dict[str, dict[str, str]], new: dict[str, dict[str, str]]
) -> Iterator[Change]:
    for key in {**new, **old}:
        make = Make("vocabulary", key)
        if key not in old:
            yield make(f"{what}_added")
        elif key not in new:
            yield make(f"{what}_removed")
        else:
            yield from mapping_changes(make, what, old[key], new[key])
    if [key for key in old if key in new] != [key for key in new if key in old]:
        yield Make("vocabulary", "")(f"{what}_order")
