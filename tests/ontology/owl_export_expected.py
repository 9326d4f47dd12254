"""What an export must say of a knowledge base, worked out from the records alone."""

import json
from collections import Counter
from collections.abc import Iterator

from dialogue.engine.concepts import Frame, Knowledge, Topic
from dialogue.engine.sentence_types import SENTENCE_TYPES
from ontology_io.records import KnowledgeBase
from plans.engine.intents import Intent, ValueList
from tests.ontology.owl_readers import Row

Names = dict[tuple[str, str], str]
FORMS = {
    "n": "nameNumber",
    "count": "nameCount",
    "bare": "nameBare",
    "one": "nameOne",
    "g": "nameGender",
    "sg": "nameSingular",
    "art": "nameArticle",
    "il": "nameIl",
    "un": "nameUn",
    "di": "nameDi",
    "a": "nameA",
    "da": "nameDa",
    "in": "nameIn",
    "su": "nameSu",
    "con": "nameCon",
    "dove": "nameDove",
    "polite": "namePolite",
    "kana": "nameKana",
}


def expected_rows(base: KnowledgeBase, names: Names) -> Counter[Row]:
    """Return every annotated text; `names` are those of the individuals by topic and culture."""
    goals = {one.key for one in base.library.intents}
    rows: Counter[Row] = Counter()
    above = {key for topic in base.knowledge.topics for key in (topic.is_a, *topic.also)}
    for topic in base.knowledge.topics:
        rows.update(_topic_rows(topic, topic.key in above, names, goals))
    for code, frames in base.knowledge.pools.items():
        for place, frame in enumerate(frames, start=1):
            kept = {("onlyCulture", f"CULTURE_{one}") for one in frame.only}
            for language, text in frame.texts.items():
                notes = frozenset(_frame_notes(frame, place, language, goals) | kept)
                rows[Row(f"POOL_{code.upper()}", "hasLine", text, language, notes)] += 1
    for intent in base.library.intents:
        rows.update(_intent_rows(intent))
    for one in base.library.values:
        rows.update(_value_rows(one))
    return rows


def _topic_rows(topic: Topic, has_some_below: bool, names: Names, goals: set[str]) -> Iterator[Row]:
    for language, texts in topic.variables.items():
        for place, (name, text) in enumerate(texts.items(), start=1):
            yield Row(topic.key, name, text, language, frozenset({("order", str(place))}))
    for place, frame in enumerate(topic.frames, start=1):
        own = frame.only and (frame.scope == "self" or not has_some_below)
        sources = [names[topic.key, code] for code in frame.only] if own else [topic.key]
        kept = set() if own else {("onlyCulture", f"CULTURE_{code}") for code in frame.only}
        prop = SENTENCE_TYPES[frame.type].owl_property
        for language, text in frame.texts.items():
            notes = frozenset(_frame_notes(frame, place, language, goals) | kept)
            for source in sources:
                yield Row(source, prop, text, language, notes)


def _frame_notes(frame: Frame, place: int, language: str, goals: set[str]) -> set[tuple[str, str]]:
    notes = {
        ("id", f"f{frame.number}.{language}"),
        ("frame", frame.key),
        ("order", str(place)),
    }
    notes |= {("stateSlot", str(frame.slot))} if frame.slot >= 0 else set()
    notes |= {("scope", frame.scope)} if frame.scope else set()
    if frame.do:
        notes.add(("activity", frame.do))
        first = frame.do.split()[0]
        notes |= {("goalIntent", f"INTENT_{first}")} if first in goals else set()
    return notes


def _intent_rows(intent: Intent) -> Iterator[Row]:
    source = f"INTENT_{intent.key}"
    for language, triggers in intent.triggers.items():
        for place, text in enumerate(triggers, start=1):
            notes = frozenset({("order", str(place))})
            yield Row(source, "hasTrigger", text, language, notes)
    for language, sentences in intent.plan_sentences.items():
        for place, said in enumerate(sentences, start=1):
            kept = {("onlyCulture", f"CULTURE_{one}") for one in said.only}
            notes = frozenset({("order", str(place)), *kept})
            yield Row(source, "hasPlanSentence", said.text, language, notes)
    for language, tests in intent.tests.items():
        for place, test in enumerate(tests, start=1):
            found = {("order", str(place))}
            if test.parameters is not None:
                expected = json.dumps(test.parameters, ensure_ascii=False, sort_keys=True)
                found.add(("expects", expected))
            yield Row(source, "hasTest", test.sentence, language, frozenset(found))


def _value_rows(one: ValueList) -> Iterator[Row]:
    every = dict.fromkeys(value for words in one.values.values() for value in words)
    numbers = {value: place for place, value in enumerate(every, start=1)}
    for language, values in one.values.items():
        for place, (value, words) in enumerate(values.items(), start=1):
            name = f"VALUES_{one.key}_{numbers[value]}"
            # There is a list of this name.
            name += "_v" if name == "VALUES_volume_1" else ""
            notes = frozenset({("order", str(place))})
            yield Row(name, "hasWords", "|".join(words), language, notes)


def expected_class(topic: Topic, place: int, knowledge: Knowledge) -> set[tuple[str, str]]:
    """Return what is said of a class, but for its restrictions."""
    numbers = {one.key: one.number for one in knowledge.topics}
    said = {("type", "Class"), ("id", f"t{topic.number}"), ("order", str(place))}
    said |= {("subClassOf", key) for key in (topic.is_a, *topic.also)}
    said |= {("treeParent", topic.is_a)} if topic.also else set()
    for language, fields in topic.names.items():
        for field, text in fields.items():
            name = "label" if field == "name" else FORMS[field]
            said.add((name, f"{text}@{language}"))
    for language, sets in topic.keywords.items():
        for number, words in enumerate(sets, start=1):
            if words:
                said.add((f"defaultKeyword{number}", f"{'|'.join(words)}@{language}"))
    said |= {("gentle", "true")} if topic.gentle else set()
    said |= {("inheritsNo", topic.stop)} if topic.stop else set()
    said |= {("homeCulture", f"CULTURE_{topic.of}")} if topic.of else set()
    said |= {("comment", topic.note)} if topic.note else set()
    links = " ".join(f"t{numbers[key]}" for key in topic.see)
    return said | ({("linkOrder", links)} if links else set())


def expected_individual(topic: Topic, culture: str, names: Names) -> set[tuple[str, str]]:
    """Return what is said of an individual, but for its sentences."""
    said = {
        ("type", "NamedIndividual"),
        ("type", topic.key),
        ("hasCulture", f"CULTURE_{culture}"),
        ("hasLikeliness", str(round(topic.likeliness[culture], 3))),
    }
    return said | {
        ("hasTopic", names[key, culture]) for key in topic.see if (key, culture) in names
    }
