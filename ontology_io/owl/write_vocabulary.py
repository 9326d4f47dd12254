"""The head of a file: the ontology itself, and the declaration of every term."""

from collections.abc import Iterator, Mapping

from ontology_io.owl import xml_writer as xml
from ontology_io.owl.vocabulary import (
    ANNOTATION_PROPERTIES,
    CLASSES,
    DATA_PROPERTIES,
    DISJOINT,
    FORMAT,
    OBJECT_PROPERTIES,
    OWL,
    VOCABULARY,
    XSD,
    Term,
)

LABEL = "CAIR knowledge base"
#: Kinds of numbers, in the order in which highestNumbers names them.
NUMBERED = ("topic", "frame", "intent")
_LIKELINESS = f"""  <rdfs:range>
    <rdfs:Datatype>
      <owl:onDatatype rdf:resource="{XSD}decimal"/>
      <owl:withRestrictions rdf:parseType="Collection">
        <rdf:Description>
          <xsd:minInclusive rdf:datatype="{XSD}decimal">0.0</xsd:minInclusive>
        </rdf:Description>
        <rdf:Description>
          <xsd:maxInclusive rdf:datatype="{XSD}decimal">1.0</xsd:maxInclusive>
        </rdf:Description>
      </owl:withRestrictions>
    </rdfs:Datatype>
  </rdfs:range>
"""


def head(iri: str, version: str, highest: Mapping[str, int]) -> str:
    """Return the ontology's own element."""
    numbers = " ".join(f"{kind}={highest[kind]}" for kind in NUMBERED if kind in highest)
    return xml.element(
        "owl:Ontology",
        iri,
        xml.text("rdfs:label", LABEL, "en"),
        xml.text("owl:versionInfo", version),
        xml.text("cair:formatVersion", FORMAT),
        xml.text("cair:highestNumbers", numbers) if numbers else "",
    )


def vocabulary() -> Iterator[str]:
    """Yield the declarations of all terms, with what is said about them."""
    yield "\n<!-- Vocabulary -->\n"
    for term in CLASSES:
        yield _declared("owl:Class", term, above="rdfs:subClassOf")
    yield _disjoint()
    for term in OBJECT_PROPERTIES:
        yield _declared("owl:ObjectProperty", term)
    for term in DATA_PROPERTIES:
        yield _declared("owl:DatatypeProperty", term)
    for term in ANNOTATION_PROPERTIES:
        yield _declared("owl:AnnotationProperty", term)


def _declared(kind: str, term: Term, above: str = "rdfs:subPropertyOf") -> str:
    return xml.element(
        kind,
        VOCABULARY + term.name,
        xml.resource("rdf:type", f"{OWL}FunctionalProperty") if term.functional else "",
        xml.resource(above, VOCABULARY + term.above) if term.above else "",
        xml.resource("rdfs:domain", VOCABULARY + term.domain) if term.domain else "",
        _range(term),
        xml.text("rdfs:label", term.name, "en"),
        xml.text("rdfs:comment", term.comment, "en"),
    )


def _range(term: Term) -> str:
    if term.name == "hasLikeliness":
        return _LIKELINESS
    if not term.range:
        return ""
    return xml.resource("rdfs:range", term.range if ":" in term.range else VOCABULARY + term.range)


def _disjoint() -> str:
    members = "".join(
        f'    <rdf:Description rdf:about="{VOCABULARY}{name}"/>\n' for name in DISJOINT
    )
    return (
        '<owl:AllDisjointClasses>\n  <owl:members rdf:parseType="Collection">\n'
        f"{members}  </owl:members>\n</owl:AllDisjointClasses>\n"
    )
