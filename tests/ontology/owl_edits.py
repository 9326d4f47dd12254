"""Edits of an export as Protégé makes them, done with rdflib."""

from rdflib import OWL, RDF, RDFS, BNode, Graph, Literal, Namespace, URIRef
from rdflib.term import Node

from ontology_io.exporting import export_draft
from ontology_io.importing import Preview, apply, preview
from tests.ontology.emptying import empty_apps

CAIR, KB = Namespace("urn:cair:vocab#"), Namespace("urn:cair:kb#")
XSD_INTEGER = URIRef("http://www.w3.org/2001/XMLSchema#integer")
XSD_DECIMAL = URIRef("http://www.w3.org/2001/XMLSchema#decimal")


def exported() -> bytes:
    return b"".join(export_draft())


def brought(data: bytes, *, keep: bool = False) -> Preview:
    """Import what has no errors; return what it changed."""
    found = preview(data, keep=keep)
    assert found.errors == ()
    apply(found, told="ontology imported from tea.owl")
    return found


def told(found: Preview) -> list[tuple[str, str, str, tuple[str, ...]]]:
    """Return the changes as plain values."""
    return [(one.kind, one.what, one.key, one.details) for one in found.changes]


def empty_tables() -> None:
    """Empty the draft's tables, their numbers too."""
    empty_apps("dialogue", "plans", "ontology_io")


def integer(number: int) -> Literal:
    return Literal(str(number), datatype=XSD_INTEGER)


class Edited:
    """An export that is edited."""

    def __init__(self, data: bytes | None = None) -> None:
        self.graph = Graph()
        self.graph.parse(data=data or exported(), format="xml")

    def data(self) -> bytes:
        return bytes(self.graph.serialize(format="xml", encoding="utf-8"))

    def rename(self, old: str, new: str) -> None:
        """Refactor > Rename entity."""
        for triple in list(self.graph):
            if KB[old] in triple:
                self.graph.remove(triple)
                self.graph.add(tuple(KB[new] if one == KB[old] else one for one in triple))

    def replace(self, old: Literal, new: Literal) -> None:
        """Change a text wherever it stands."""
        for subject, term, _ in list(self.graph.triples((None, None, old))):
            self.graph.remove((subject, term, old))
            self.graph.add((subject, term, new))

    def set(self, subject: Node, term: URIRef, value: Node) -> None:
        self.graph.set((subject, term, value))

    def add(self, subject: Node, term: URIRef, value: Node) -> None:
        self.graph.add((subject, term, value))

    def value(self, subject: Node, term: URIRef) -> Node:
        found = self.graph.value(subject, term)
        assert found is not None
        return found

    def axioms(self, text: Literal) -> list[Node]:
        """Return the annotated axioms of a sentence, on classes and on individuals."""
        targets = [text, *self.graph.subjects(OWL.hasValue, text)]
        return [axiom for one in targets for axiom in self.graph.subjects(OWL.annotatedTarget, one)]

    def forget(self, text: Literal) -> None:
        """Delete a sentence."""
        for axiom in self.axioms(text):
            self.graph.remove((axiom, None, None))
        for node in list(self.graph.subjects(OWL.hasValue, text)):
            self.graph.remove((None, None, node))
            self.graph.remove((node, None, None))
        self.graph.remove((None, None, text))

    def delete(self, name: str) -> None:
        """Delete a class or an individual with all that is said about it."""
        entity = KB[name]
        for axiom in list(self.graph.subjects(OWL.annotatedSource, entity)):
            self.graph.remove((axiom, None, None))
        for _, _, above in list(self.graph.triples((entity, RDFS.subClassOf, None))):
            if isinstance(above, BNode):
                self.graph.remove((above, None, None))
        self.graph.remove((entity, None, None))
        self.graph.remove((None, None, entity))

    def say(self, topic: str, term: str, text: Literal, **notes: Node) -> None:
        """Add a sentence to a class, with annotations."""
        node = BNode()
        self.add(node, RDF.type, OWL.Restriction)
        self.add(node, OWL.onProperty, CAIR[term])
        self.add(node, OWL.hasValue, text)
        self.add(KB[topic], RDFS.subClassOf, node)
        if notes:
            self._annotate(KB[topic], RDFS.subClassOf, node, notes)

    def tell(self, individual: str, term: str, text: Literal, **notes: Node) -> None:
        """Add a sentence to an individual, with annotations."""
        self.add(KB[individual], CAIR[term], text)
        if notes:
            self._annotate(KB[individual], CAIR[term], text, notes)

    def _annotate(self, subject: Node, term: URIRef, value: Node, notes: dict[str, Node]) -> None:
        axiom = BNode()
        self.add(axiom, RDF.type, OWL.Axiom)
        self.add(axiom, OWL.annotatedSource, subject)
        self.add(axiom, OWL.annotatedProperty, term)
        self.add(axiom, OWL.annotatedTarget, value)
        for name, note in notes.items():
            self.add(axiom, CAIR[name], note)

    def new_class(self, name: str, above: str, **labels: str) -> None:
        """Add a class with labels."""
        self.add(KB[name], RDF.type, OWL.Class)
        self.add(KB[name], RDFS.subClassOf, KB[above])
        for code, text in labels.items():
            self.add(KB[name], RDFS.label, Literal(text, lang=code))

    def new_individual(self, name: str, topic: str, culture: str, likeliness: str) -> None:
        self.add(KB[name], RDF.type, OWL.NamedIndividual)
        self.add(KB[name], RDF.type, KB[topic])
        self.add(KB[name], CAIR.hasCulture, KB[f"CULTURE_{culture}"])
        self.add(KB[name], CAIR.hasLikeliness, Literal(likeliness, datatype=XSD_DECIMAL))
