"""The person-specific ABox of one person as OWL: EN_TEA hasSpecific DS_TEA (paper, "PS-ABox").

Made on request from what a dialogue state holds, and kept nowhere; the exporter never writes it.
"""

import re
import unicodedata
from collections.abc import Collection, Iterable, Iterator
from itertools import pairwise
from typing import NamedTuple

from dialogue.engine.concepts import ROOT
from ontology_io.owl import xml_writer as xml
from ontology_io.owl.names import PREFIXES, culture_name
from ontology_io.owl.vocabulary import (
    CLASSES,
    DATA_PROPERTIES,
    OBJECT_PROPERTIES,
    OWL,
    VOCABULARY,
    Term,
)

PREFIX = "PS"
LONGEST_PREFIX = 8
SUFFIX = "-person"
USER = "USER_"
#: A prefix stands before `_`, so it must not be what other individuals begin with.
RESERVED = frozenset(name.rstrip("_") for name in (*PREFIXES, USER))
_CLASSES = ("Topic", "Culture", "User")
_OBJECT_PROPERTIES = ("hasSpecific", "hasCulture", "concernsUser")
_PLAIN_WORD = re.compile(rf"[A-Z][A-Z0-9]{{0,{LONGEST_PREFIX - 1}}}")


class Liking(NamedTuple):
    """What a talk showed of one topic: its class, those above it (nearest first), the value.

    `specific_of` is the individual of the culture, "" where the culture has none. `number` tells
    two topics apart whose names differ in capitals only.
    """

    topic: str
    number: int
    above: tuple[str, ...]
    likeliness: float
    specific_of: str


class Person(NamedTuple):
    """Whose likings they are: the label (may be empty), the prefix of names, the culture's code."""

    label: str
    prefix: str
    culture: str


class PersonalIndividual(NamedTuple):
    """One individual of the PS-ABox: its local name and what it says."""

    name: str
    liking: Liking


def can_be_written(label: str) -> bool:
    """Say whether XML has a form for every character of a label."""
    return xml.FORBIDDEN.search(label) is None


def prefix_of(label: str, cultures: Collection[str]) -> str:
    """Return what the names of a person's individuals begin with: DS for Dorothy Smith.

    A short word in capitals stands as it is; PS where a name has no initials in A-Z. What begins
    the names of other individuals (the codes of cultures) gets PS before it.
    """
    plain = unicodedata.normalize("NFKD", label).encode("ascii", "ignore").decode()
    words: list[str] = re.findall("[A-Za-z][A-Za-z0-9]*", plain)
    if len(words) == 1 and _PLAIN_WORD.fullmatch(words[0]):
        prefix = words[0]
    else:
        prefix = "".join(word[0] for word in words)[:LONGEST_PREFIX].upper() or PREFIX
    return PREFIX + prefix if prefix in RESERVED or prefix in cultures else prefix


def personal_individuals(
    likings: Iterable[Liking], person: Person
) -> tuple[PersonalIndividual, ...]:
    """Return the individuals of a person, each with a name of its own."""
    named: dict[str, PersonalIndividual] = {}
    for liking in likings:
        name = f"{person.prefix}_{liking.topic.upper()}"
        if name in named:
            name = f"{name}_t{liking.number}"
        named[name] = PersonalIndividual(name, liking)
    return tuple(named.values())


def person_owl(individuals: Collection[PersonalIndividual], person: Person, *, iri: str) -> str:
    """Return the PS-ABox as RDF/XML that opens by itself.

    Classes and individuals have the IRIs of the export that `iri` names, so that the two can be
    merged; the ontology itself is named `iri` + "-person". Raises UnwritableError for a label that
    XML cannot hold.
    """
    return "".join(_Pieces(xml.attribute(iri), person).all(individuals))


class _Pieces:
    """The elements of one file; all IRIs are written in full."""

    def __init__(self, iri: str, person: Person) -> None:
        self._ontology = iri
        self._person = person
        self._user = self._iri(USER + person.prefix)
        self._culture = self._iri(culture_name(person.culture))

    def all(self, individuals: Collection[PersonalIndividual]) -> Iterator[str]:
        yield xml.opening(self._ontology)
        yield xml.element("owl:Ontology", self._ontology + SUFFIX)
        yield from _vocabulary()
        yield from self._classes(one.liking for one in individuals)
        yield self._individual_user()
        if any(one.liking.specific_of for one in individuals):
            yield xml.individual(self._culture, f"{VOCABULARY}Culture")
        for one in individuals:
            if one.liking.specific_of:
                yield self._of_culture(one)
            yield self._of_person(one)
        yield xml.CLOSING

    def _classes(self, likings: Iterable[Liking]) -> Iterator[str]:
        parents: dict[str, str] = {}
        for liking in likings:
            parents |= pairwise((liking.topic, *liking.above, ROOT))
        for key, parent in sorted(parents.items()):
            above = VOCABULARY + ROOT if parent == ROOT else self._iri(parent)
            yield xml.element("owl:Class", self._iri(key), xml.resource("rdfs:subClassOf", above))

    def _individual_user(self) -> str:
        label = xml.text("rdfs:label", self._person.label) if self._person.label else ""
        return xml.individual(self._user, f"{VOCABULARY}User", label)

    def _of_culture(self, one: PersonalIndividual) -> str:
        return xml.individual(
            self._iri(one.liking.specific_of),
            self._iri(one.liking.topic),
            xml.resource("cair:hasCulture", self._culture),
            xml.resource("cair:hasSpecific", self._iri(one.name)),
        )

    def _of_person(self, one: PersonalIndividual) -> str:
        return xml.individual(
            self._iri(one.name),
            self._iri(one.liking.topic),
            xml.resource("cair:concernsUser", self._user),
            xml.decimal("cair:hasLikeliness", one.liking.likeliness),
        )

    def _iri(self, name: str) -> str:
        return f"{self._ontology}#{xml.attribute(name)}"


def _vocabulary() -> Iterator[str]:
    """Yield the declarations of the terms that such a file uses."""
    yield from _declared("owl:Class", CLASSES, _CLASSES)
    yield from _declared("owl:ObjectProperty", OBJECT_PROPERTIES, _OBJECT_PROPERTIES)
    yield from _declared("owl:DatatypeProperty", DATA_PROPERTIES, ("hasLikeliness",))


def _declared(kind: str, terms: Iterable[Term], used: Collection[str]) -> Iterator[str]:
    for term in terms:
        if term.name in used:
            yield xml.element(
                kind,
                VOCABULARY + term.name,
                xml.resource("rdf:type", f"{OWL}FunctionalProperty") if term.functional else "",
                xml.resource("rdfs:domain", VOCABULARY + term.domain) if term.domain else "",
                xml.resource("rdfs:range", VOCABULARY + term.range) if term.range else "",
                xml.text("rdfs:label", term.name, "en"),
                xml.text("rdfs:comment", term.comment, "en"),
            )
