"""Intents with their slots, triggers, plan sentences, plans and tests."""

import json

from ontology_io.owl.facts import Node, Rows
from ontology_io.owl.file_records import OwlIntent
from ontology_io.owl.names import intent_key
from ontology_io.owl.read_values import LONG, Reader
from plans.engine.intents import ActionItem, Intent, IntentTest, PlanSentence, Slot

_LAST = 1_000_000


def name_intents(reader: Reader) -> None:
    """Note the key of each intent for the other parts."""
    for node in reader.facts.typed("Intent"):
        reader.intents[node] = intent_key(reader.facts.name(node))


def read_intents(reader: Reader) -> tuple[OwlIntent, ...]:
    """Take the intents, in order."""
    facts = reader.facts
    found: dict[str, OwlIntent] = {}
    for node, key in reader.intents.items():
        reader.declared(node, "Intent")
        order = reader.integer(facts.take(node, "order"), node, "order", 0)
        row = OwlIntent(intent=_intent(reader, node, key), id=reader.word(node, "id"), order=order)
        if key in found:
            facts.wrong(node, f"The intent {key!r} is there twice.", "Rename one of them.")
        found.setdefault(key, row)
    return tuple(sorted(found.values(), key=lambda row: (row.order or _LAST, row.intent.key)))


def _intent(reader: Reader, node: Node, key: str) -> Intent:
    facts = reader.facts
    return Intent(
        number=0,
        key=key,
        family=reader.word(node, "hasFamily", 60),
        priority=reader.integer(facts.take(node, "hasPriority"), node, "hasPriority", 50),
        slots=_slots(reader, node),
        abilities=reader.by_language(node, "hasAbility", 200),
        triggers=_triggers(reader, node),
        plan_sentences=_plan_sentences(reader, node),
        plan=_plan(reader, node, "hasPlan", "Plan"),
        kbplan=_plan(reader, node, "hasKBPlan", "KBPlan"),
        tests=_tests(reader, node),
        note=reader.note(node),
    )


def _triggers(reader: Reader, node: Node) -> dict[str, tuple[str, ...]]:
    found: dict[str, tuple[str, ...]] = {}
    for language, text, _ in reader.ordered(node, "hasTrigger", 500):
        found[language] = (*found.get(language, ()), text)
    return found


def _plan_sentences(reader: Reader, node: Node) -> dict[str, tuple[PlanSentence, ...]]:
    found: dict[str, tuple[PlanSentence, ...]] = {}
    longest = reader.limits.sentence
    for language, text, rows in reader.ordered(node, "hasPlanSentence", longest):
        row = PlanSentence(text=text, only=reader.only(rows, node))
        found[language] = (*found.get(language, ()), row)
    return found


def _tests(reader: Reader, node: Node) -> dict[str, tuple[IntentTest, ...]]:
    found: dict[str, tuple[IntentTest, ...]] = {}
    for language, text, rows in reader.ordered(node, "hasTest", 500):
        row = IntentTest(sentence=text, parameters=_expects(reader, node, rows))
        found[language] = (*found.get(language, ()), row)
    return found


def _expects(reader: Reader, node: Node, rows: Rows) -> dict[str, str] | None:
    if "expects" not in rows:
        return None
    text = reader.word_of(rows["expects"], node, "expects", LONG)
    try:
        expected = json.loads(text)
    except (ValueError, RecursionError):
        expected = None
    if isinstance(expected, dict) and all(isinstance(value, str) for value in expected.values()):
        return expected
    reader.facts.wrong(node, f"The test expects {text[:60]!r}.", 'Write {"title": "Hey Brother"}.')
    return None


def _slots(reader: Reader, node: Node) -> tuple[Slot, ...]:
    rows = [(*_place(reader, slot), _slot(reader, slot)) for slot in _linked(reader, node, "Slot")]
    return tuple(row[-1] for row in sorted(rows, key=lambda row: row[:-1]))


def _slot(reader: Reader, node: Node) -> Slot:
    name = reader.word(node, "hasSlotName", 40)
    if not name:
        reader.facts.wrong(node, "It has no hasSlotName.", "Write the name used in triggers.")
    return Slot(
        name=name,
        kind=reader.word(node, "hasSlotKind", 80) or "text",
        required=reader.flag(node, "isRequired"),
        questions=reader.by_language(node, "hasSlotQuestion", 500),
    )


def _plan(reader: Reader, node: Node, key: str, term: str) -> tuple[ActionItem, ...]:
    plans = _linked(reader, node, term, key)
    if len(plans) > 1:
        reader.facts.wrong(node, f"It has more than one {key}.", "Put the actions into one.")
    if not plans:
        return ()
    rows = [(*_place(reader, each), _action(reader, each)) for each in _actions(reader, plans[0])]
    return tuple(row[-1] for row in sorted(rows, key=lambda row: row[:-1]))


def _actions(reader: Reader, plan: Node) -> list[Node]:
    return _linked(reader, plan, "Action")


def _action(reader: Reader, node: Node) -> ActionItem:
    name = reader.word(node, "hasActionName", 60)
    if not name:
        reader.facts.wrong(node, "It has no hasActionName.", "Write what is to be done.")
    rows = []
    for each in _linked(reader, node, "Parameter"):
        key = reader.word(each, "hasParameterName", 60)
        if not key:
            reader.facts.wrong(each, "It has no hasParameterName.", "Write its name.")
        rows.append((*_place(reader, each), (key, reader.word(each, "hasParameterValue"))))
    return ActionItem(
        action=name, parameters=tuple(row[-1] for row in sorted(rows, key=lambda row: row[:-1]))
    )


def _linked(reader: Reader, node: Node, term: str, key: str = "") -> list[Node]:
    """Take the parts of a node that are of this class; each belongs to one whole."""
    facts = reader.facts
    found = []
    for part in facts.take_nodes(node, key or f"has{term}"):
        if not facts.of_type(part, term):
            hint = f"Declare it as {term}, or remove the link."
            facts.wrong(node, f"{facts.name(part)!r} is no {term} of the file.", hint)
        elif part in reader.parts:
            facts.wrong(node, f"{facts.name(part)!r} belongs to something else too.", "Copy it.")
        else:
            reader.parts.add(part)
            reader.declared(part, term)
            found.append(part)
    return found


def _place(reader: Reader, node: Node) -> tuple[int, int, str]:
    """Return what a part is sorted by: its hasOrder, else its name (_A2 before _A10)."""
    order = reader.integer(reader.facts.take(node, "hasOrder"), node, "hasOrder", _LAST)
    name = reader.facts.name(node)
    return order, len(name), name
