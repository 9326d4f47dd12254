"""The file itself: the same bytes, well-formed, everything declared, within OWL 2 DL."""

from xml.etree import ElementTree

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from msgspec.structs import replace
from rdflib import OWL, RDF, RDFS, XSD, BNode, Graph, Literal, URIRef
from rdflib.compare import IsomorphicGraph, graph_diff, to_isomorphic

from benchmarks.owl_synthetic import highest, synthetic
from languages import english_names, italian_names, japanese_names
from ontology_io.owl.export import CHUNK, owl_bytes
from ontology_io.owl.vocabulary import (
    ANNOTATION_PROPERTIES,
    CLASSES,
    DATA_PROPERTIES,
    DISJOINT,
    NAME_FORMS,
    OBJECT_PROPERTIES,
    VOCABULARY,
    Term,
)
from ontology_io.owl.write_remainder import RemainderError
from ontology_io.owl.xml_writer import UnwritableError
from tests.ontology.owl_bases import LAST, RICH, with_text
from tests.ontology.owl_readers import IRI, KB, about, exported, read_graph, value_of

TERMS = (*CLASSES, *OBJECT_PROPERTIES, *DATA_PROPERTIES, *ANNOTATION_PROPERTIES)
KINDS = {
    OWL.Class: CLASSES,
    OWL.ObjectProperty: OBJECT_PROPERTIES,
    OWL.DatatypeProperty: DATA_PROPERTIES,
    OWL.AnnotationProperty: ANNOTATION_PROPERTIES,
}
XML_TEXT = st.text(
    st.characters(exclude_categories=("Cs",)).filter(lambda letter: letter not in "\ufffe\uffff")
).filter(lambda text: all(letter in "\t\n\r" or letter >= " " for letter in text))


@pytest.fixture(scope="module")
def graph() -> Graph:
    return read_graph(exported(RICH, highest=LAST))


def parsed_texts(data: bytes) -> set[str | None]:
    return {element.text for element in ElementTree.fromstring(data).iter()}  # noqa: S314


def test_the_same_knowledge_gives_the_same_bytes() -> None:
    assert exported(RICH, highest=LAST) == exported(RICH, highest=LAST)


def test_the_order_of_dictionaries_changes_nothing() -> None:
    first, *rest = RICH.knowledge.topics
    names = {code: dict(reversed(first.names[code].items())) for code in reversed(first.names)}
    liked = dict(reversed(first.likeliness.items()))
    turned = replace(first, names=names, likeliness=liked)
    other = replace(RICH, knowledge=replace(RICH.knowledge, topics=(turned, *rest)))
    assert exported(other) == exported(RICH)


def test_the_order_of_topics_that_are_no_siblings_changes_nothing() -> None:
    topics = RICH.knowledge.topics
    order = ("Milk", "Drink", "GreenTea", "Gift", "Greentea")
    mixed = sorted(topics, key=lambda topic: order.index(topic.key))
    assert tuple(mixed) != topics
    other = replace(RICH, knowledge=replace(RICH.knowledge, topics=tuple(mixed)))
    assert exported(other) == exported(RICH)


def test_the_file_comes_in_small_chunks() -> None:
    base = synthetic(topics=120, rows=900, intents=5)
    sizes = [len(chunk) for chunk in owl_bytes(base, iri=IRI, version="d", highest=highest(base))]
    assert len(sizes) > 10
    assert max(sizes) < 3 * CHUNK


@given(XML_TEXT)
@example("a\rb\r\nc")
@example("]]> & <b> \"q\" 'a' \t\n ")
@example("NFD e\u0301 é, 👩‍👩‍👧, नमस्ते, \U0001f375, \u202eabc\ufeff\u0085\u2028\x7f")
@example("")
def test_any_text_comes_back_through_an_xml_parser(text: str) -> None:
    texts = parsed_texts(exported(with_text(text)))
    assert (text or None) in texts


@given(XML_TEXT.filter(bool))
@example("\r")
@example("  outer and  double blanks ")
def test_any_text_comes_back_through_rdflib(text: str) -> None:
    found = read_graph(exported(with_text(text)))
    assert ("label", f"{text}@en") in about(found, "Drink")
    assert ("comment", text) in about(found, "Drink")
    assert ("hasTrigger", f"{text}@en") in about(found, "INTENT_playsong")


@pytest.mark.parametrize("letter", ["\x00", "\x08", "\x0b", "\x1f", "\ufffe", "\ud800"])
def test_a_character_that_xml_has_not_is_refused_with_its_place(letter: str) -> None:
    with pytest.raises(UnwritableError, match="after 'bad'"):
        exported(with_text(f"bad{letter}"))


def test_a_language_that_is_no_tag_is_refused() -> None:
    (first, *_) = RICH.knowledge.topics
    odd = replace(first, names={'en" x="': {"name": "tea"}}, frames=())
    with pytest.raises(UnwritableError, match="not the code of a language"):
        exported(replace(RICH, knowledge=replace(RICH.knowledge, topics=(odd,))))


def test_every_term_is_declared_with_label_and_comment(graph: Graph) -> None:
    for kind, terms in KINDS.items():
        for term in terms:
            said = about(graph, term.name, VOCABULARY)
            assert (URIRef(VOCABULARY + term.name), RDF.type, kind) in graph
            assert {("label", f"{term.name}@en"), ("comment", f"{term.comment}@en")} <= said


@pytest.mark.parametrize("term", TERMS, ids=lambda term: term.name)
def test_a_term_has_its_domain_range_and_place(graph: Graph, term: Term) -> None:
    subject = URIRef(VOCABULARY + term.name)
    above = RDFS.subClassOf if term in CLASSES else RDFS.subPropertyOf
    expected = {VOCABULARY + term.above} if term.above else set()
    assert {str(iri) for iri in graph.objects(subject, above)} == expected
    domains = {VOCABULARY + term.domain} if term.domain else set()
    assert {str(iri) for iri in graph.objects(subject, RDFS.domain)} == domains
    if term.name != "hasLikeliness":
        full = term.range if ":" in term.range else VOCABULARY + term.range
        found = {str(iri) for iri in graph.objects(subject, RDFS.range)}
        assert found == ({full} if term.range else set())
    assert ((subject, RDF.type, OWL.FunctionalProperty) in graph) == term.functional


def test_likeliness_ranges_from_0_to_1(graph: Graph) -> None:
    datatype = graph.value(URIRef(f"{VOCABULARY}hasLikeliness"), RDFS.range)
    assert graph.value(datatype, OWL.onDatatype) == XSD.decimal
    facets = graph.items(graph.value(datatype, OWL.withRestrictions))
    bounds = [(prop, value) for facet in facets for prop, value in graph.predicate_objects(facet)]
    assert bounds == [
        (XSD.minInclusive, Literal("0.0", datatype=XSD.decimal)),
        (XSD.maxInclusive, Literal("1.0", datatype=XSD.decimal)),
    ]


def test_the_classes_of_the_vocabulary_are_disjoint(graph: Graph) -> None:
    (axiom,) = graph.subjects(RDF.type, OWL.AllDisjointClasses)
    members = {str(iri) for iri in graph.items(graph.value(axiom, OWL.members))}
    assert members == {VOCABULARY + name for name in DISJOINT}


def test_every_property_used_is_known_or_declared(graph: Graph) -> None:
    declared = {
        prop for kind in KINDS if kind != OWL.Class for prop in graph.subjects(RDF.type, kind)
    }
    spaces = (str(OWL), str(RDF), str(RDFS), str(XSD))
    used = set(graph.predicates()) - declared
    assert {prop for prop in used if not str(prop).startswith(spaces)} == set()
    assert set(graph.objects(None, OWL.onProperty)) <= declared


def test_every_iri_that_is_named_is_declared(graph: Graph) -> None:
    typed = set(graph.subjects(RDF.type, None))
    named = {
        value
        for triple in graph
        for value in triple
        if isinstance(value, URIRef) and str(value).startswith((VOCABULARY, KB))
    }
    assert named - typed == set()


def test_nothing_is_of_two_kinds(graph: Graph) -> None:
    for one in set(graph.subjects(RDF.type, None)):
        if not isinstance(one, BNode):
            kinds = set(graph.objects(one, RDF.type)) & {*KINDS, OWL.NamedIndividual, OWL.Ontology}
            assert len(kinds) == 1, one


def test_functional_properties_have_one_value(graph: Graph) -> None:
    for prop in graph.subjects(RDF.type, OWL.FunctionalProperty):
        for subject in set(graph.subjects(prop, None)):
            assert len(list(graph.objects(subject, prop))) == 1, (subject, prop)


def test_literals_are_typed_as_their_property_says(graph: Graph) -> None:
    plain = {"hasPattern", "hasLine", *(term.name for term in DATA_PROPERTIES)}
    for _, prop, value in graph:
        name = str(prop).removeprefix(VOCABULARY)
        if not isinstance(value, Literal) or name == str(prop):
            continue
        if name in ("order", "stateSlot", "hasPriority", "hasOrder"):
            assert value.datatype == XSD.integer
        elif name == "hasLikeliness":
            assert value.datatype == XSD.decimal
        elif name in ("gentle", "isRequired"):
            assert value.datatype == XSD.boolean
        else:
            assert value.datatype is None
            term = next((each for each in DATA_PROPERTIES if each.name == name), None)
            tagged = term is not None and term.range.endswith("PlainLiteral")
            assert name not in plain or bool(value.language) == tagged, (name, value)


def test_every_form_of_a_name_has_a_property() -> None:
    """A form that no property carries would be lost without a word."""
    forms = english_names.FIELDS | italian_names.FIELDS | japanese_names.FIELDS
    assert forms - {"name"} == NAME_FORMS.keys()


def test_a_property_that_no_field_can_be_is_not_left_out_in_silence() -> None:
    remainder = "<urn:x> <urn:y#1> <urn:z> .\n"
    with pytest.raises(RemainderError, match="Rename"):
        owl_bytes(RICH, iri=IRI, version="draft", highest={}, remainder=remainder)


REMAINDER = """\
<urn:cair:kb#Drink> <http://www.w3.org/2000/01/rdf-schema#seeAlso> <https://example.org/a?b&c> .
<urn:cair:kb#Drink> <https://example.org/p> "two\\nlines \\"q\\" \\u00e8 \\\\ \\U0001F375"@en-GB .
<urn:cair:kb#Drink> <https://example.org/p> "" .
_:b1 <http://www.w3.org/1999/02/22-rdf-syntax-ns#type> <http://www.w3.org/2002/07/owl#Restriction> .
_:b1 <http://www.w3.org/2002/07/owl#onProperty> <https://example.org/q> .
_:b1 <http://www.w3.org/2002/07/owl#someValuesFrom> _:b2 .
_:b2 <https://example.org/n> "5"^^<http://www.w3.org/2001/XMLSchema#integer> .
"""


def test_the_remainder_is_written_as_it_was_kept() -> None:
    kept = Graph().parse(data=REMAINDER, format="nt")
    plain = read_graph(exported(RICH))
    both = read_graph(exported(RICH, remainder=REMAINDER))
    assert len(both) == len(plain) + len(kept)
    texts = {value_of(value) for value in both.objects(URIRef(f"{KB}Drink"))}
    assert {'two\nlines "q" è \\ 🍵@en-GB'} <= texts
    _, missing, invented = graph_diff(with_example(kept), with_example(both))
    assert (len(missing), len(invented)) == (0, 0)


def with_example(graph: Graph) -> IsomorphicGraph:
    """Return the triples that name something of example.org."""
    found = Graph()
    for triple in graph:
        if any(str(part).startswith("https://example.org/") for part in triple):
            found.add(triple)
    return to_isomorphic(found)


@pytest.mark.parametrize("line", ["nonsense", "<a> <b> <c>", '<urn:a> <urn:b#c> "x .'])
def test_a_remainder_that_is_no_n_triples_is_refused(line: str) -> None:
    with pytest.raises(RemainderError, match="not a line of N-Triples"):
        exported(RICH, remainder=line)
