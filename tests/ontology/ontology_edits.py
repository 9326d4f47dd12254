"""Edits of an export as people make them in Protégé, done with rdflib."""

from collections.abc import Callable

from rdflib import OWL, RDF, RDFS, XSD, BNode, Graph, Literal, Namespace
from rdflib.term import Node

from ontology_io.owl.vocabulary import VOCABULARY
from tests.ontology.owl_readers import KB as CONTENT
from tests.ontology.owl_readers import read_graph

CAIR, KB = Namespace(VOCABULARY), Namespace(CONTENT)
Edit = Callable[[Graph], object]


def decimal(text: str) -> Literal:
    return Literal(text, datatype=XSD.decimal)


def question(text: str, language: str | None = "en", name: str = "Tea", **notes: Node) -> Edit:
    """Return the edit that adds a question to a class, with annotations."""

    def edit(graph: Graph) -> None:
        said, note = BNode(), BNode()
        graph.add((said, RDF.type, OWL.Restriction))
        graph.add((said, OWL.onProperty, CAIR.hasQuestion))
        graph.add((said, OWL.hasValue, Literal(text, lang=language)))
        graph.add((KB[name], RDFS.subClassOf, said))
        if notes:
            graph.add((note, RDF.type, OWL.Axiom))
            graph.add((note, OWL.annotatedSource, KB[name]))
            graph.add((note, OWL.annotatedProperty, RDFS.subClassOf))
            graph.add((note, OWL.annotatedTarget, said))
        for key, value in notes.items():
            graph.add((note, CAIR[key], value))

    return edit


def added(subject: str, prop: Node, value: Node) -> Edit:
    return lambda graph: graph.add((KB[subject], prop, value))


def put(subject: str, prop: Node, value: Node) -> Edit:
    return lambda graph: graph.set((KB[subject], prop, value))


def without(subject: str, prop: Node | None = None, value: Node | None = None) -> Edit:
    return lambda graph: graph.remove((KB[subject], prop, value))


def renamed(old: str, new: str) -> Callable[[bytes], bytes]:
    """Return the edit that renames an entity everywhere, and not another that begins like it."""
    return lambda data: data.replace(f'#{old}"'.encode(), f'#{new}"'.encode())


def second_individual(graph: Graph) -> None:
    for prop, value in list(graph.predicate_objects(KB.EN_TEA)):
        graph.add((KB.EN_TEATWO, prop, value))


def only_persons(graph: Graph) -> None:
    for thing in set(graph.subjects()):
        if str(thing).startswith(CONTENT):
            graph.remove((thing, None, None))


def edited(export: bytes, edit: Edit) -> bytes:
    graph = read_graph(export)
    edit(graph)
    return graph.serialize(format="xml").encode()
