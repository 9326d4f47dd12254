"""Sentences: what stands on a class as a restriction, on an individual as an assertion."""

from collections.abc import Iterable

from dialogue.engine.concepts import Frame, Topic
from dialogue.engine.sentence_types import SENTENCE_TYPES
from ontology_io.owl import xml_writer as xml
from ontology_io.owl.names import Names, culture_name, frame_id, intent_name
from ontology_io.owl.vocabulary import RDFS, VOCABULARY
from ontology_io.records import KnowledgeBase

SUBCLASS = f"{RDFS}subClassOf"


class Context:
    """What all parts of one file share: names, places, and the numbers of its restrictions.

    `space` is the content namespace as an attribute's text; `above` are the topics that have
    others below them; `cultures` is the place of each culture.
    """

    def __init__(self, base: KnowledgeBase, iri: str) -> None:
        self.space = f"{xml.attribute(iri)}#"
        self.names = Names(base)
        self.intents = frozenset(one.key for one in base.library.intents)
        topics = base.knowledge.topics
        self.numbers = {topic.key: topic.number for topic in topics}
        self.above = {above for topic in topics for above in (topic.is_a, *topic.also)}
        self.cultures = {one.code: place for place, one in enumerate(base.knowledge.cultures)}
        self._restrictions = 0

    def iri(self, name: str) -> str:
        """Return the IRI of a local name, as an attribute's text."""
        return self.space + xml.attribute(name)

    def restriction(self) -> int:
        """Return the number of the next restriction, from 1."""
        self._restrictions += 1
        return self._restrictions

    def ordered(self, cultures: Iterable[str]) -> list[str]:
        """Return codes of cultures in the order of the cultures."""
        last = len(self.cultures)
        return sorted(cultures, key=lambda code: (self.cultures.get(code, last), code))


def on_individuals(frame: Frame, topic: Topic, context: Context) -> bool:
    """Say whether a frame is asserted on the individuals of its cultures, not on the class.

    It is where nothing below the topic says it too.
    """
    if not frame.only or not all(code in topic.likeliness for code in frame.only):
        return False
    return frame.scope == "self" or topic.key not in context.above


def property_of(frame: Frame) -> str:
    """Return the local name of the property of a frame's type."""
    return SENTENCE_TYPES[frame.type].owl_property


def restricted(prop: str, value: str, language: str, number: int) -> str:
    """Return a restriction: `property value "text"@en`."""
    return (
        f'<owl:Restriction rdf:nodeID="r{number}">\n'
        f'  <owl:onProperty rdf:resource="{prop}"/>\n'
        f"{xml.text('owl:hasValue', value, language)}</owl:Restriction>\n"
    )


def class_sentence(
    frame: Frame, place: int, language: str, source: str, context: Context
) -> tuple[str, str]:
    """Return the line of the class, and what follows it, for one sentence that is inherited."""
    number = context.restriction()
    said = restricted(VOCABULARY + property_of(frame), frame.texts[language], language, number)
    kept = [kept_for(code, context) for code in context.ordered(frame.only)]
    notes = annotations(frame, place, language, context)
    about = xml.axiom(source, SUBCLASS, xml.node_target(number), *notes, *kept)
    return xml.node("rdfs:subClassOf", number), said + about


def assertion(
    prop: str, frame: Frame, language: str, source: str, notes: Iterable[str]
) -> tuple[str, str]:
    """Return the line of an individual, and its annotations, for one sentence."""
    value = frame.texts[language]
    target = xml.literal_target(value, language)
    about = xml.axiom(source, VOCABULARY + prop, target, *notes)
    return xml.text(f"cair:{prop}", value, language), about


def kept_for(code: str, context: Context) -> str:
    """Return the annotation that a sentence is kept for a culture."""
    return xml.resource("cair:onlyCulture", context.iri(culture_name(code)))


def annotations(frame: Frame, place: int, language: str, context: Context) -> list[str]:
    """Return what belongs to the row of a sentence: id, frame, place, slot, scope, activity."""
    lines = [xml.text("cair:id", frame_id(frame.number, language))] if frame.number else []
    lines += [xml.text("cair:frame", frame.key), xml.integer("cair:order", place)]
    if frame.slot >= 0:
        lines.append(xml.integer("cair:stateSlot", frame.slot))
    if frame.scope:
        lines.append(xml.text("cair:scope", frame.scope))
    if frame.do:
        lines.append(xml.text("cair:activity", frame.do))
        goal = frame.do.split(maxsplit=1)[0] if frame.do.strip() else ""
        if goal in context.intents:
            lines.append(xml.resource("cair:goalIntent", context.iri(intent_name(goal))))
    return lines
