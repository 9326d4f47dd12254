"""A small ontology as text, and every way in which a file may be broken or hostile."""

from random import Random
from xml.sax.saxutils import quoteattr

HEAD = """<?xml version="1.0" encoding="UTF-8"?>
<rdf:RDF xml:base="urn:cair:kb"
  xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#"
  xmlns:rdfs="http://www.w3.org/2000/01/rdf-schema#"
  xmlns:owl="http://www.w3.org/2002/07/owl#"
  xmlns:xsd="http://www.w3.org/2001/XMLSchema#"
  xmlns:cair="urn:cair:vocab#">
"""
END = "</rdf:RDF>\n"
DECIMAL = "http://www.w3.org/2001/XMLSchema#decimal"
PARTS = {
    "ontology": '<owl:Ontology rdf:about="urn:cair:kb">{}</owl:Ontology>',
    "terms": """<owl:Class rdf:about="urn:cair:vocab#Topic"/>
<owl:Class rdf:about="urn:cair:vocab#Culture"/>
<owl:ObjectProperty rdf:about="urn:cair:vocab#hasTopic"/>
<owl:DatatypeProperty rdf:about="urn:cair:vocab#hasQuestion"/>{}""",
    "culture": """<owl:NamedIndividual rdf:about="urn:cair:kb#CULTURE_EN">
  <rdf:type rdf:resource="urn:cair:vocab#Culture"/><cair:hasCode>EN</cair:hasCode>{}
</owl:NamedIndividual>""",
    "drink": """<owl:Class rdf:about="urn:cair:kb#Drink">
  <rdfs:subClassOf rdf:resource="urn:cair:vocab#Topic"/>
  <rdfs:subClassOf rdf:nodeID="r1"/>
  <rdfs:label xml:lang="en">drinks</rdfs:label>{}
</owl:Class>""",
    "said": """<owl:Restriction rdf:nodeID="r1">
  <owl:onProperty rdf:resource="urn:cair:vocab#hasQuestion"/>
  <owl:hasValue xml:lang="en">Do you like $hasName?</owl:hasValue>
</owl:Restriction>""",
    "about": """<owl:Axiom>
  <owl:annotatedSource rdf:resource="urn:cair:kb#Drink"/>
  <owl:annotatedProperty rdf:resource="http://www.w3.org/2000/01/rdf-schema#subClassOf"/>
  <owl:annotatedTarget rdf:nodeID="r1"/>
  <cair:id>s1</cair:id>{}
</owl:Axiom>""",
    "tea": """<owl:Class rdf:about="urn:cair:kb#Tea">
  <rdfs:subClassOf rdf:resource="urn:cair:kb#Drink"/>
  <rdfs:label xml:lang="en">tea</rdfs:label>{}
</owl:Class>""",
    "en_tea": f"""<owl:NamedIndividual rdf:about="urn:cair:kb#EN_TEA">
  <rdf:type rdf:resource="urn:cair:kb#Tea"/>
  <cair:hasCulture rdf:resource="urn:cair:kb#CULTURE_EN"/>
  <cair:hasLikeliness rdf:datatype="{DECIMAL}">0.9</cair:hasLikeliness>{{}}
</owl:NamedIndividual>""",
    "intent": """<owl:NamedIndividual rdf:about="urn:cair:kb#INTENT_sing">
  <rdf:type rdf:resource="urn:cair:vocab#Intent"/>
  <cair:hasTrigger xml:lang="en">sing a song</cair:hasTrigger>{}
</owl:NamedIndividual>""",
    "end": "{}",
}


class Document:
    """The parts of a small ontology."""

    def __init__(self, parts: dict[str, str]) -> None:
        self.parts = parts

    def bytes(self) -> bytes:
        return (HEAD + "\n".join(self.parts.values()) + END).encode()

    def shuffled(self) -> bytes:
        parts = list(self.parts.values())
        Random(7).shuffle(parts)
        return (HEAD + "\n".join(parts) + END).encode()

    def as_owlxml(self) -> bytes:
        return OWL_XML.encode()


def document() -> Document:
    """Return the ontology as it should be."""
    return Document({name: part.replace("{}", "") for name, part in PARTS.items()})


def changed(**added: str) -> bytes:
    """Return it with `added` within the named parts."""
    parts = {name: part.replace("{}", added.get(name, "")) for name, part in PARTS.items()}
    return Document(parts).bytes()


def replaced(old: str, new: str) -> bytes:
    """Return it with another text in place of one that it has."""
    data = document().bytes()
    assert old.encode() in data
    return data.replace(old.encode(), new.encode())


def with_doctype(declarations: str, text: str = "") -> bytes:
    """Return it with a DOCTYPE, and `text` as Tea's comment."""
    data = changed(tea=f"<rdfs:comment>{text}</rdfs:comment>")
    return data.replace(b"<rdf:RDF", f"<!DOCTYPE rdf:RDF {declarations}>\n<rdf:RDF".encode(), 1)


def deep(levels: int) -> bytes:
    """Return elements within elements."""
    inner = (
        "<rdf:Description><rdfs:seeAlso>" * levels + "</rdfs:seeAlso></rdf:Description>" * levels
    )
    return (HEAD + inner + END).encode()


def long_literal(size: int) -> bytes:
    """Return one text of `size` bytes."""
    start, end = changed(tea="<rdfs:comment>@</rdfs:comment>").split(b"@")
    return b"".join((start, b"x" * size, end))


def one_line() -> bytes:
    """Return it on one line that seems to end in a full stop, as N-Triples do."""
    line = document().bytes().replace(b"\n", b" ")
    cut = line.index(b"<owl:Class")
    return line[:cut] + b"<!-- " + b"x" * (995 - cut - 6) + b".\n -->" + line[cut:]


PIZZA = (
    HEAD.replace("urn:cair:kb", "http://pizza.example/onto")
    + """<owl:Ontology rdf:about="http://pizza.example/onto"/>
<owl:Class rdf:about="http://pizza.example/onto#Pizza"/>
<owl:Class rdf:about="http://pizza.example/onto#Margherita">
  <rdfs:subClassOf rdf:resource="http://pizza.example/onto#Pizza"/>
</owl:Class>
"""
    + END
).encode()

_CLASS = "<Class IRI={}/>".format
OWL_XML = f"""<?xml version="1.0"?>
<Ontology xmlns="http://www.w3.org/2002/07/owl#" xml:base="urn:cair:kb"
  xmlns:xml="http://www.w3.org/XML/1998/namespace" ontologyIRI="urn:cair:kb">
<Prefix name="" IRI="urn:cair:kb#"/><Prefix name="cair" IRI="urn:cair:vocab#"/>
<Declaration>{_CLASS(quoteattr("#Drink"))}</Declaration>
<Declaration>{_CLASS(quoteattr("#Tea"))}</Declaration>
<Declaration><NamedIndividual IRI="#EN_TEA"/></Declaration>
<Declaration><NamedIndividual IRI="#CULTURE_EN"/></Declaration>
<SubClassOf>{_CLASS(quoteattr("#Drink"))}<Class abbreviatedIRI="cair:Topic"/></SubClassOf>
<SubClassOf>{_CLASS(quoteattr("#Tea"))}{_CLASS(quoteattr("#Drink"))}</SubClassOf>
<SubClassOf>
  <Annotation><AnnotationProperty abbreviatedIRI="cair:id"/><Literal>s1</Literal></Annotation>
  {_CLASS(quoteattr("#Drink"))}
  <DataHasValue><DataProperty abbreviatedIRI="cair:hasQuestion"/>
    <Literal xml:lang="en">Do you like $hasName?</Literal></DataHasValue>
</SubClassOf>
<ClassAssertion><Class abbreviatedIRI="cair:Culture"/><NamedIndividual IRI="#CULTURE_EN"/>
</ClassAssertion>
<ClassAssertion>{_CLASS(quoteattr("#Tea"))}<NamedIndividual IRI="#EN_TEA"/></ClassAssertion>
<ObjectPropertyAssertion><ObjectProperty abbreviatedIRI="cair:hasCulture"/>
  <NamedIndividual IRI="#EN_TEA"/><NamedIndividual IRI="#CULTURE_EN"/></ObjectPropertyAssertion>
<DataPropertyAssertion><DataProperty abbreviatedIRI="cair:hasCode"/>
  <NamedIndividual IRI="#CULTURE_EN"/><Literal>EN</Literal></DataPropertyAssertion>
<DataPropertyAssertion><DataProperty abbreviatedIRI="cair:hasLikeliness"/>
  <NamedIndividual IRI="#EN_TEA"/><Literal datatypeIRI="{DECIMAL}">0.9</Literal>
</DataPropertyAssertion>
<AnnotationAssertion><AnnotationProperty abbreviatedIRI="rdfs:label"/><IRI>#Tea</IRI>
  <Literal xml:lang="en">tea</Literal></AnnotationAssertion>
</Ontology>
""".replace('abbreviatedIRI="rdfs:label"', 'IRI="http://www.w3.org/2000/01/rdf-schema#label"')
