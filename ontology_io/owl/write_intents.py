"""Intents with their slots, triggers, plan sentences, plans and tests."""

import json
from collections.abc import Iterable, Iterator

from ontology_io.owl import xml_writer as xml
from ontology_io.owl.names import intent_id, intent_name, plan_name, slot_name
from ontology_io.owl.vocabulary import VOCABULARY
from ontology_io.owl.write_said import Context, kept_for
from plans.engine.intents import ActionItem, Intent, Slot


def intents(rows: Iterable[Intent], context: Context) -> Iterator[str]:
    """Yield the intents in order, each followed by its slots and plans."""
    for place, row in enumerate(rows, start=1):
        yield _intent(row, place, context)
        for number, slot in enumerate(row.slots, start=1):
            yield _slot(row, slot, number, context)
        for items, on_knowledge in ((row.plan, False), (row.kbplan, True)):
            if items:
                yield _plan(row.key, items, context, on_knowledge=on_knowledge)


def _intent(row: Intent, place: int, context: Context) -> str:
    source = context.iri(intent_name(row.key))
    texts = list(_texts(row, context))
    # The same words twice are one assertion with two rows of annotations.
    said = dict.fromkeys(xml.text(f"cair:{name}", *text) for name, text, _ in texts)
    lines = [
        xml.text("cair:id", intent_id(row.number)) if row.number else "",
        xml.integer("cair:order", place),
        xml.integer("cair:hasPriority", row.priority),
        xml.text("cair:hasFamily", row.family) if row.family else "",
        *(xml.text("cair:hasAbility", row.abilities[code], code) for code in sorted(row.abilities)),
        xml.text("rdfs:comment", row.note) if row.note else "",
        *said,
        *_parts(row, context),
    ]
    return xml.individual(source, f"{VOCABULARY}Intent", *lines) + "".join(
        xml.axiom(source, VOCABULARY + name, xml.literal_target(*text), *notes)
        for name, text, notes in texts
    )


def _texts(row: Intent, context: Context) -> Iterator[tuple[str, tuple[str, str], list[str]]]:
    """Yield each text of an intent: the property, the text with its language, annotations."""
    for code in sorted(row.triggers):
        for place, trigger in enumerate(row.triggers[code], start=1):
            yield "hasTrigger", (trigger, code), [xml.integer("cair:order", place)]
    for code in sorted(row.plan_sentences):
        for place, said in enumerate(row.plan_sentences[code], start=1):
            kept = [kept_for(one, context) for one in context.ordered(said.only)]
            notes = [xml.integer("cair:order", place), *kept]
            yield "hasPlanSentence", (said.text, code), notes
    for code in sorted(row.tests):
        for place, test in enumerate(row.tests[code], start=1):
            notes = [xml.integer("cair:order", place)]
            if test.parameters is not None:
                expected = json.dumps(test.parameters, ensure_ascii=False, sort_keys=True)
                notes.append(xml.text("cair:expects", expected))
            yield "hasTest", (test.sentence, code), notes


def _parts(row: Intent, context: Context) -> Iterator[str]:
    for slot in row.slots:
        yield xml.resource("cair:hasSlot", context.iri(slot_name(row.key, slot.name)))
    if row.plan:
        yield xml.resource("cair:hasPlan", context.iri(plan_name(row.key, on_knowledge=False)))
    if row.kbplan:
        yield xml.resource("cair:hasKBPlan", context.iri(plan_name(row.key, on_knowledge=True)))


def _slot(row: Intent, slot: Slot, place: int, context: Context) -> str:
    asked = (
        xml.text("cair:hasSlotQuestion", slot.questions[code], code)
        for code in sorted(slot.questions)
    )
    return xml.individual(
        context.iri(slot_name(row.key, slot.name)),
        f"{VOCABULARY}Slot",
        xml.text("cair:hasSlotName", slot.name),
        xml.text("cair:hasSlotKind", slot.kind),
        xml.flag("cair:isRequired", value=slot.required),
        *asked,
        xml.integer("cair:hasOrder", place),
    )


def _plan(intent: str, items: Iterable[ActionItem], context: Context, *, on_knowledge: bool) -> str:
    name = plan_name(intent, on_knowledge=on_knowledge)
    rows = [(f"{name}_A{place}", place, item) for place, item in enumerate(items, start=1)]
    steps = (xml.resource("cair:hasAction", context.iri(action)) for action, _, _ in rows)
    kind = "KBPlan" if on_knowledge else "Plan"
    return xml.individual(context.iri(name), VOCABULARY + kind, *steps) + "".join(
        _action(action, place, item, context) for action, place, item in rows
    )


def _action(name: str, place: int, item: ActionItem, context: Context) -> str:
    rows = [(f"{name}_P{number}", *pair) for number, pair in enumerate(item.parameters, start=1)]
    return xml.individual(
        context.iri(name),
        f"{VOCABULARY}Action",
        xml.text("cair:hasActionName", item.action),
        xml.integer("cair:hasOrder", place),
        *(xml.resource("cair:hasParameter", context.iri(row[0])) for row in rows),
    ) + "".join(
        xml.individual(
            context.iri(parameter),
            f"{VOCABULARY}Parameter",
            xml.text("cair:hasParameterName", key),
            xml.text("cair:hasParameterValue", value),
            xml.integer("cair:hasOrder", number),
        )
        for number, (parameter, key, value) in enumerate(rows, start=1)
    )
