"""Topics: each class with what is inherited from it, and its individual of each culture."""

from collections.abc import Iterable, Iterator

from dialogue.engine.concepts import ROOT, Topic
from ontology_io.owl import xml_writer as xml
from ontology_io.owl.names import culture_name, pattern_name, pattern_sequence, topic_id
from ontology_io.owl.vocabulary import NAME_FORMS, VOCABULARY
from ontology_io.owl.write_said import (
    SUBCLASS,
    Context,
    annotations,
    assertion,
    class_sentence,
    on_individuals,
    property_of,
    restricted,
)

_KEYWORDS = ("cair:defaultKeyword1", "cair:defaultKeyword2")


def patterns(topics: Iterable[Topic], context: Context) -> Iterator[str]:
    """Yield the patterns that topics use, each once."""
    found = {pattern_name(topic.pattern): topic.pattern for topic in topics if topic.pattern}
    for name in sorted(found):
        sequence = xml.text("cair:hasSequence", pattern_sequence(found[name]))
        yield xml.individual(context.iri(name), f"{VOCABULARY}DialoguePattern", sequence)


def variables(topics: Iterable[Topic], context: Context) -> Iterator[str]:
    """Yield the declarations of the class variables, each a property below hasChunk."""
    names = {name for topic in topics for texts in topic.variables.values() for name in texts}
    above = xml.resource("rdfs:subPropertyOf", f"{VOCABULARY}hasChunk")
    for name in sorted(names):
        yield xml.element("owl:DatatypeProperty", context.iri(name), above)


def topics(all_topics: Iterable[Topic], context: Context) -> Iterator[str]:
    """Yield, for each topic in the order given, its class and then its individuals."""
    places: dict[str, int] = {}
    for topic in all_topics:
        places[topic.is_a] = places.get(topic.is_a, 0) + 1
        yield _class(topic, places[topic.is_a], context)
        for culture in context.ordered(topic.likeliness):
            yield _individual(topic, culture, context)


def _class(topic: Topic, place: int, context: Context) -> str:
    source = context.iri(topic.key)
    lines = [xml.resource("rdfs:subClassOf", _parent(topic.is_a, context))]
    lines += [xml.resource("rdfs:subClassOf", context.iri(key)) for key in sorted(topic.also)]
    parts = [_pattern(topic, context), *_variables(topic, source, context)]
    for number, frame in enumerate(topic.frames, start=1):
        if not on_individuals(frame, topic, context):
            parts += [
                class_sentence(frame, number, language, source, context)
                for language in sorted(frame.texts)
            ]
    lines += [line for line, _ in parts]
    lines += _about(topic, place, context)
    return xml.element("owl:Class", source, *lines) + "".join(rest for _, rest in parts)


def _parent(key: str, context: Context) -> str:
    return f"{VOCABULARY}{ROOT}" if key == ROOT else context.iri(key)


def _about(topic: Topic, place: int, context: Context) -> Iterator[str]:
    """Yield the annotations of a class."""
    if topic.number:
        yield xml.text("cair:id", topic_id(topic.number))
    yield xml.integer("cair:order", place)
    if topic.also:
        yield xml.resource("cair:treeParent", _parent(topic.is_a, context))
    yield from _names(topic)
    yield from _keywords(topic)
    yield from _rules(topic, context)
    if topic.note:
        yield xml.text("rdfs:comment", topic.note)
    order = [topic_id(number) for key in topic.see if (number := context.numbers.get(key))]
    if order:
        yield xml.text("cair:linkOrder", " ".join(order))


def _keywords(topic: Topic) -> Iterator[str]:
    for language in sorted(topic.keywords):
        for name, words in zip(_KEYWORDS, topic.keywords[language], strict=True):
            if words:
                yield xml.text(name, "|".join(words), language)


def _rules(topic: Topic, context: Context) -> Iterator[str]:
    if topic.gentle:
        yield xml.flag("cair:gentle", value=True)
    if topic.stop:
        yield xml.text("cair:inheritsNo", topic.stop)
    if topic.of:
        yield xml.resource("cair:homeCulture", context.iri(culture_name(topic.of)))


def _names(topic: Topic) -> Iterator[str]:
    for language in sorted(topic.names):
        fields = topic.names[language]
        if fields.get("name"):
            yield xml.text("rdfs:label", fields["name"], language)
        for field, name in NAME_FORMS.items():
            if field in fields:
                yield xml.text(f"cair:{name}", fields[field], language)


def _pattern(topic: Topic, context: Context) -> tuple[str, str]:
    if not topic.pattern:
        return "", ""
    number = context.restriction()
    value = xml.resource("owl:hasValue", context.iri(pattern_name(topic.pattern)))
    said = (
        f'<owl:Restriction rdf:nodeID="r{number}">\n'
        f'  <owl:onProperty rdf:resource="{VOCABULARY}usesPattern"/>\n{value}</owl:Restriction>\n'
    )
    return xml.node("rdfs:subClassOf", number), said


def _variables(topic: Topic, source: str, context: Context) -> Iterator[tuple[str, str]]:
    for language in sorted(topic.variables):
        for place, (name, value) in enumerate(topic.variables[language].items(), start=1):
            number = context.restriction()
            order = xml.integer("cair:order", place)
            yield (
                xml.node("rdfs:subClassOf", number),
                restricted(context.iri(name), value, language, number)
                + xml.axiom(source, SUBCLASS, xml.node_target(number), order),
            )


def _individual(topic: Topic, culture: str, context: Context) -> str:
    source = context.iri(context.names.individual(topic.key, culture))
    lines = [
        xml.resource("cair:hasCulture", context.iri(culture_name(culture))),
        xml.decimal("cair:hasLikeliness", topic.likeliness[culture]),
    ]
    for key in topic.see:
        name = context.names.individual(key, culture)
        if name:
            lines.append(xml.resource("cair:hasTopic", context.iri(name)))
    parts = list(_own_sentences(topic, culture, source, context))
    # What two frames say in the same words is one assertion with two rows of annotations.
    lines += dict.fromkeys(line for line, _ in parts)
    return xml.individual(source, context.iri(topic.key), *lines) + "".join(
        rest for _, rest in parts
    )


def _own_sentences(
    topic: Topic, culture: str, source: str, context: Context
) -> Iterator[tuple[str, str]]:
    for place, frame in enumerate(topic.frames, start=1):
        if culture in frame.only and on_individuals(frame, topic, context):
            for language in sorted(frame.texts):
                notes = annotations(frame, place, language, context)
                yield assertion(property_of(frame), frame, language, source, notes)
