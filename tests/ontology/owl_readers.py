"""Exports as rdflib and py-horned-owl read them, in short plain values that tests can compare."""

from collections import Counter
from collections.abc import Iterable
from typing import NamedTuple

import pyhornedowl
import pytest
from pyhornedowl import model
from rdflib import OWL, RDF, RDFS, BNode, Graph, Literal, URIRef
from rdflib.term import Node

from ontology_io.owl.export import owl_bytes
from ontology_io.owl.vocabulary import VOCABULARY
from ontology_io.records import KnowledgeBase

IRI = "urn:cair:kb"
KB = f"{IRI}#"


class Row(NamedTuple):
    """An annotated text: where it is asserted, by which property, and its annotations.

    IRIs are their local names; `notes` hold name and value of each annotation.
    """

    source: str
    prop: str
    text: str
    language: str
    notes: frozenset[tuple[str, str]]


def exported(base: KnowledgeBase, **options: object) -> bytes:
    """Return the whole export of a knowledge base."""
    values: dict[str, object] = {"iri": IRI, "version": "draft", "highest": {}, **options}
    return b"".join(owl_bytes(base, **values))


def local(iri: object) -> str:
    """Return what stands after the last #, or the whole IRI."""
    return str(iri).rpartition("#")[2]


def read_graph(data: bytes) -> Graph:
    """Return the triples that rdflib reads."""
    return Graph().parse(data=data, format="xml")


def read_horned(data: bytes) -> pyhornedowl.PyIndexedOntology:
    """Return the ontology that py-horned-owl reads."""
    return pyhornedowl.open_ontology_from_string(data.decode(), "rdf")


def about(graph: Graph, name: str, space: str = KB) -> set[tuple[str, str]]:
    """Return what is said of a thing: property and value, a text as `text@en`; no restrictions."""
    found = graph.predicate_objects(URIRef(space + name))
    return {(local(prop), value_of(value)) for prop, value in found if not isinstance(value, BNode)}


def value_of(value: Node) -> str:
    """Return a local name, a text with its language, or a number as it is written."""
    if not isinstance(value, Literal):
        return local(value)
    return f"{value}@{value.language}" if value.language else str(value)


def instances(graph: Graph, kind: str) -> set[str]:
    """Return the local names of the individuals of a class of the vocabulary."""
    return {local(one) for one in graph.subjects(RDF.type, URIRef(VOCABULARY + kind))}


def rows_of_graph(graph: Graph) -> Counter[Row]:
    """Return every annotated text, as often as it is annotated."""
    rows: Counter[Row] = Counter()
    for axiom in graph.subjects(RDF.type, OWL.Axiom):
        parts = dict(graph.predicate_objects(axiom))
        prop, target = parts[OWL.annotatedProperty], parts[OWL.annotatedTarget]
        source = parts[OWL.annotatedSource]
        if prop == RDFS.subClassOf:
            prop, target = restriction(graph, target)
            # By content, not by node: tools write the node of the annotation once more.
            above = graph.objects(source, RDFS.subClassOf)
            assert (prop, target) in [restriction(graph, one) for one in above]
        else:
            assert (source, prop, target) in graph
        notes = frozenset(
            (local(note), value_of(value))
            for note, value in graph.predicate_objects(axiom)
            if not str(note).startswith((str(OWL), str(RDF)))
        )
        rows[Row(local(source), local(prop), str(target), target.language or "", notes)] += 1
    return rows


def restriction(graph: Graph, node: Node) -> tuple[Node | None, Node | None]:
    """Return property and value of a restriction."""
    return graph.value(node, OWL.onProperty), graph.value(node, OWL.hasValue)


def rows_of_horned(ontology: pyhornedowl.PyIndexedOntology) -> Counter[Row]:
    """Return every annotated text, as often as it is annotated."""
    rows: Counter[Row] = Counter()
    for annotated in ontology.get_axioms():
        axiom = annotated.component
        if not annotated.ann:
            continue
        if isinstance(axiom, model.SubClassOf):
            source, prop, text = axiom.sub.first, axiom.sup.dp.first, axiom.sup.l
        elif isinstance(axiom, model.DataPropertyAssertion):
            source, prop, text = axiom.source.first, axiom.dp.first, axiom.target
        else:
            pytest.fail(f"annotations on {axiom}")
        notes = _notes(annotated.ann)
        rows[Row(local(source), local(prop), text.literal, getattr(text, "lang", ""), notes)] += 1
    return rows


def _notes(annotations: Iterable[model.Annotation]) -> frozenset[tuple[str, str]]:
    return frozenset(
        (local(one.ap.first), one.av.literal if hasattr(one.av, "literal") else local(one.av))
        for one in annotations
    )
