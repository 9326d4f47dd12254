"""The pass before anything interprets a file: what it refuses, and in which words."""

import pytest

from ontology_io.owl.limits import Limits, OwlError
from ontology_io.owl.prescan import scan
from tests.ontology import hostile_owl as hostile

LIMITS = Limits()
LAUGHS = '[<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;">]'


def refused(data: bytes, limits: Limits = LIMITS) -> str:
    with pytest.raises(OwlError) as caught:
        scan(data, limits)
    assert len(caught.value.problems) >= 1
    return str(caught.value)


def test_what_protege_writes_is_accepted() -> None:
    protege = hostile.with_doctype(
        '[<!ENTITY owl "http://www.w3.org/2002/07/owl#"><!ENTITY kb "urn:cair:kb#">]'
    ).replace(b'rdf:about="urn:cair:kb#Tea"', b'rdf:about="&kb;Tea"')
    assert scan(protege, LIMITS) == "rdfxml"
    assert scan(hostile.document().bytes(), LIMITS) == "rdfxml"
    assert scan(hostile.document().as_owlxml(), LIMITS) == "owlxml"


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"", "empty"),
        (b" \n\t", "empty"),
        (b"PK\x03\x04\x14\0\0\0", "compressed"),
        (b"\x1f\x8b\x08\0", "compressed"),
        (b"\x7fELF\x02\x01\0\0\0", "binary"),
        (b"%PDF-1.7 ...", "binary"),
        (b"<!DOCTYPE html><html><body>Sign in</body></html>", "HTML"),
        (b"<HTML lang='en'>", "HTML"),
        (b"@prefix owl: <http://www.w3.org/2002/07/owl#> .\n:Tea a owl:Class .", "Turtle"),
        (b"PREFIX : <urn:x#>\n:Tea a :Class .", "Turtle"),
        (b"Prefix(:=<urn:x#>)\nOntology(<urn:x>)", "functional"),
        (b"Prefix: : <urn:x#>\nOntology: <urn:x>\nClass: Tea", "Manchester"),
        (b"<urn:a#b> <urn:a#c> <urn:a#d> .\n", "N-Triples"),
        (b'{"@context": {}}', "JSON"),
        (b"[1, 2]", "JSON"),
        (b"Dear colleagues, here is the ontology", "not XML"),
        (b"<?xml version='1.0'?><svg/>", "neither rdf:RDF nor Ontology"),
        (b"<?xml version='1.0' encoding='EBCDIC-X'?><a/>", "encoding"),
    ],
)
def test_other_kinds_of_file_are_told_by_their_name(data: bytes, words: str) -> None:
    assert words in refused(data)


def test_what_is_no_xml_is_told_how_to_save() -> None:
    assert "File > Save as > RDF/XML" in refused(b"@prefix : <urn:x#> .")


def test_a_file_cut_short_is_told_with_its_line() -> None:
    data = hostile.document().bytes()
    text = refused(data[: len(data) // 2])
    assert text.startswith("Line ")
    assert "well-formed" in text


def test_bytes_that_are_not_utf_8_are_told_with_their_line() -> None:
    data = hostile.replaced(">tea<", ">t@<").replace(b"t@", b"t\xe8")
    assert "well-formed" in refused(data)


@pytest.mark.parametrize("character", ["\x00", "\x01", "\x1f", "\ufffe"])
def test_characters_that_xml_forbids_are_refused(character: str) -> None:
    refused(hostile.replaced(">tea<", f">t{character}a<"))


@pytest.mark.parametrize(
    "doctype",
    [
        LAUGHS,
        '[<!ENTITY a SYSTEM "file:///etc/passwd">]',
        '[<!ENTITY a PUBLIC "x" "http://127.0.0.1/x">]',
        '[<!ENTITY % a "b"> %a;]',
        '[<!ENTITY % a SYSTEM "http://127.0.0.1/x"> %a;]',
        '[<!ENTITY a "<b/>">]',
        "[<!ELEMENT a ANY>]",
        '[<!ATTLIST a b CDATA "c">]',
        '[<!NOTATION a SYSTEM "b">]',
        'SYSTEM "http://127.0.0.1/owl.dtd"',
        'PUBLIC "-//X" "http://127.0.0.1/owl.dtd"',
        "[" + "".join(f'<!ENTITY e{n} "x">' for n in range(101)) + "]",
        f'[<!ENTITY a "{"x" * 501}">]',
    ],
)
def test_a_doctype_holds_short_names_for_iris_and_nothing_else(doctype: str) -> None:
    text = refused(hostile.with_doctype(doctype))
    assert "entit" in text or "DOCTYPE" in text


def test_a_plain_entity_that_is_used_a_million_times_is_too_long() -> None:
    doctype = f'[<!ENTITY a "{"x" * 400}">]'
    assert "longer than" in refused(hostile.with_doctype(doctype, "&a;" * 1000))


@pytest.mark.parametrize("iri", ["http://127.0.0.1:9/x", "file:///etc/passwd", "urn:x"])
def test_no_other_ontology_is_imported(iri: str) -> None:
    text = refused(hostile.changed(ontology=f'<owl:imports rdf:resource="{iri}"/>'))
    assert "owl:imports" in text
    owlxml = hostile.OWL_XML.replace("<Prefix", f"<Import>{iri}</Import><Prefix", 1)
    assert "owl:imports" in refused(owlxml.encode())


def test_no_python_module_is_named() -> None:
    space = "http://www.lesfleursdunormal.fr/static/_downloads/owlready_ontology.owl#"
    element = f'<o:python_module xmlns:o="{space}">os</o:python_module>'
    assert "Python code" in refused(hostile.changed(ontology=element))
    assert "Python code" in refused(
        hostile.changed(tea=f'<rdfs:seeAlso rdf:resource="{space}python_name"/>')
    )
    owlxml = hostile.OWL_XML.replace("urn:cair:vocab#", space)
    assert "Python code" in refused(owlxml.encode())


@pytest.mark.parametrize(
    ("added", "words"),
    [
        ('<rdfs:seeAlso rdf:parseType="Literal"><b/></rdfs:seeAlso>', "parseType"),
        ('<rdfs:seeAlso rdf:parseType="Resource"><b/></rdfs:seeAlso>', "parseType"),
        ('<rdfs:seeAlso><rdf:Description rdf:ID="x"/></rdfs:seeAlso>', "rdf:ID"),
        ('<rdfs:seeAlso><owl:Class cair:id="t1"/></rdfs:seeAlso>', "'id'"),
        ('<rdfs:seeAlso><owl:Class xml:lang="en"/></rdfs:seeAlso>', "xml:lang"),
        ('<rdfs:seeAlso><owl:Class xml:base="urn:x"/></rdfs:seeAlso>', "xml:base"),
        ("<rdfs:seeAlso><owl:Class/><owl:Class/></rdfs:seeAlso>", "more than one value"),
        ("<rdfs:seeAlso>x<owl:Class/></rdfs:seeAlso>", "mixed"),
        ('<rdfs:seeAlso rdf:resource="urn:x">x</rdfs:seeAlso>', "text as well"),
        ('<owl:unionOf rdf:parseType="Collection"/>', "collection is empty"),
        ("stray words", "between the elements"),
        ("<rdf:li>x</rdf:li>", "'li'"),
        ('<rdfs:seeAlso rdf:resource="tea.html"/>', "absolute IRI"),
        ('<rdfs:seeAlso rdf:resource="urn:a b"/>', "absolute IRI"),
        ("<rdfs:seeAlso rdf:resource='urn:a\"b'/>", "absolute IRI"),
        ('<rdfs:seeAlso rdf:resource="urn:a&lt;b"/>', "absolute IRI"),
        ('<rdfs:seeAlso rdf:resource="urn:a#b#c"/>', "absolute IRI"),
        ('<rdfs:seeAlso rdf:resource="_:b1"/>', "absolute IRI"),
        ('<rdfs:seeAlso rdf:resource="http://example.org/"/>', "ends in '/'"),
        (f'<rdfs:seeAlso rdf:resource="urn:{"x" * 3000}"/>', "too long"),
        (f"<rdfs:comment>{'x' * 10_001}</rdfs:comment>", "longer than"),
        ('<cair:order rdf:datatype="http://www.w3.org/2001/XMLSchema#integer">five</cair:order>',
         "not a number"),
        (f'<cair:order rdf:datatype="{hostile.DECIMAL}">1_0</cair:order>', "not a number"),
        (f'<cair:order rdf:datatype="{hostile.DECIMAL}">NaN</cair:order>', "not a number"),
        (f'<cair:order rdf:datatype="{hostile.DECIMAL}"/>', "not a number"),
        ('<cair:order rdf:datatype="http://www.w3.org/2001/XMLSchema#long">99999999999999999999'
         "</cair:order>", "not a number"),
        ('<rdfs:comment rdf:datatype="http://www.w3.org/1999/02/22-rdf-syntax-ns#XMLLiteral">x'
         "</rdfs:comment>", "XMLLiteral"),
    ],
)  # fmt: skip
def test_rdf_xml_that_would_be_misread_is_refused(added: str, words: str) -> None:
    assert words in refused(hostile.changed(tea=added))


def test_two_ontologies_in_one_file_are_refused() -> None:
    assert "two ontologies" in refused(hostile.changed(end='<owl:Ontology rdf:about="urn:y"/>'))


def test_all_wrong_iris_and_numbers_are_told_at_once() -> None:
    number = f'<cair:order rdf:datatype="{hostile.DECIMAL}">many</cair:order>'
    with pytest.raises(OwlError) as caught:
        scan(hostile.changed(tea=number, drink=number, en_tea=number), LIMITS)
    assert len(caught.value.problems) == 3


def test_a_file_above_the_limit_is_not_even_parsed() -> None:
    assert "larger than 1 MB" in refused(b"x" * 1_100_000, Limits(size=1024 * 1024))


def test_an_endless_text_is_not_gathered() -> None:
    assert "longer than" in refused(hostile.long_literal(60_000_000))


@pytest.mark.parametrize("filler", ["<!--{}-->", "<?x {}?>", "<{}/>", '<rdf:x y="{}"/>'])
def test_endless_comments_names_and_attributes_are_refused(filler: str) -> None:
    refused(hostile.changed(end=filler.replace("{}", "x" * 20_000_000)))


def test_elements_within_elements_end_early() -> None:
    assert "deep" in refused(hostile.deep(100_000))


def test_too_many_elements_are_refused() -> None:
    assert "elements" in refused(hostile.document().bytes(), Limits(elements=10))


def test_words_that_only_look_like_a_doctype_are_text() -> None:
    assert scan(hostile.changed(tea="<rdfs:comment>&lt;!DOCTYPE a []&gt;</rdfs:comment>"), LIMITS)


@pytest.mark.parametrize(
    ("added", "words"),
    [
        ("<HasKey/>", "HasKey"),
        ("<NegativeDataPropertyAssertion/>", "NegativeDataPropertyAssertion"),
        ('<SameIndividual><AnonymousIndividual nodeID="_:a"/></SameIndividual>', "AnonymousInd"),
        ("<SameIndividual>" + '<NamedIndividual IRI="#A"/>' * 3 + "</SameIndividual>", "than two"),
        ("<FunctionalDataProperty><Annotation/></FunctionalDataProperty>", "annotation of Func"),
        ('<Class IRI="tea"/>', "absolute IRI"),
        ("<IRI>tea</IRI>", "absolute IRI"),
        ("<AbbreviatedIRI>x:tea</AbbreviatedIRI>", "not declared"),
        ('<Class abbreviatedIRI="tea"/>', "not declared"),
        ("stray words", "between the elements"),
        ("<Ontology/>", "'Ontology'"),
        ('<x xmlns="urn:x"/>', "'x'"),
        ('<Class xml:lang="en" IRI="#A"/>', "lang"),
        ('<Class IRI="#A" xml:base="urn:x"/>', "xml:base"),
        (f'<Literal datatypeIRI="{hostile.DECIMAL}">much</Literal>', "not a number"),
    ],
)
def test_owl_xml_that_would_be_misread_is_refused(added: str, words: str) -> None:
    data = hostile.OWL_XML.replace("<Declaration>", f"{added}<Declaration>", 1)
    assert words in refused(data.encode())


def test_relative_names_need_the_base_that_owl_xml_gives_them() -> None:
    data = hostile.OWL_XML.replace('xml:base="urn:cair:kb"', 'xml:base="urn:other"')
    assert "absolute IRI" in refused(data.encode())
