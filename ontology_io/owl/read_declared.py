"""The head of a file and the declarations that every export writes: taken, and forgotten."""

import re

from ontology_io.owl.facts import Facts, Node, Value
from ontology_io.owl.read_values import Reader
from ontology_io.owl.terms import ours
from ontology_io.owl.vocabulary import DISJOINT, FORMAT

_HIGHEST = re.compile(r"(topic|frame|intent)=([0-9]{1,12})", re.ASCII)
_ABOVE = ("rdfs:subClassOf", "rdfs:subPropertyOf")
_NODES = ("rdfs:domain", "rdfs:range")


def read_head(reader: Reader) -> tuple[str, dict[str, int]]:
    """Take what the ontology says of itself; return its IRI and the highest numbers."""
    facts = reader.facts
    heads = facts.typed("owl:Ontology")
    highest: dict[str, int] = {}
    for node in heads:
        facts.take_if(node, "rdf:type", lambda value: facts.term_of(value) == "owl:Ontology")
        facts.take(node, "owl:versionInfo")
        facts.take_if(node, "rdfs:label", _english)
        version = reader.word(node, "formatVersion")
        if version not in ("", FORMAT):
            hint = f"This server reads version {FORMAT}: export from one of the same version."
            facts.wrong(node, f"It is written in version {version!r}.", hint)
        numbers = reader.word(node, "highestNumbers")
        highest.update({kind: int(number) for kind, number in _HIGHEST.findall(numbers)})
    return (facts.iris[heads[0]] if heads else ""), highest


def forget_vocabulary(facts: Facts) -> None:
    """Take the declarations of terms, ours and W3C's, with what every export says of them."""
    for node in [node for node in facts.nodes if facts.term(node)]:
        facts.take_if(node, "rdf:type", lambda value: facts.term_of(value)[:4] in ("owl:", "rdfs"))
        if not ours(facts.term(node)):
            continue
        for key in _ABOVE:
            facts.take_if(node, key, lambda value: ours(facts.term_of(value)))
        for key in ("rdfs:label", "rdfs:comment"):
            facts.take_if(node, key, _english)
        for key in _NODES:
            _forget(facts, facts.take(node, key))
    _forget_disjoint(facts)


def _forget(facts: Facts, values: list[Value]) -> None:
    facts.copies.update(value for value in values if isinstance(value, int) and value < 0)


def _forget_disjoint(facts: Facts) -> None:
    for node, rows in facts.nodes.items():
        if node < 0 and any(
            facts.term_of(v) == "owl:AllDisjointClasses" for v in rows.get("rdf:type", ())
        ):
            members = [
                facts.term_of(value)
                for one in rows.get("owl:members", ())
                for value in members_of(facts, one)
            ]
            if set(members) <= set(DISJOINT):
                facts.copies.add(node)


def members_of(facts: Facts, value: Value) -> list[Value]:
    """Return the members of an RDF list."""
    found: list[Value] = []
    seen: set[Node] = set()
    while isinstance(value, int) and value < 0 and value not in seen:
        seen.add(value)
        found += facts.see(value, "rdf:first")
        rest = facts.see(value, "rdf:rest")
        value = rest[0] if rest else 0
    return found


def _english(value: Value) -> bool:
    return not isinstance(value, int) and value.kind == "@en"
