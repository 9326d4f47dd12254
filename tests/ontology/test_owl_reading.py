"""Reading what the server itself has written, and what others write with the same vocabulary."""

from pathlib import Path

import msgspec
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from benchmarks.owl_synthetic import highest, synthetic
from dialogue.engine.concepts import Culture, Frame, Knowledge, Topic
from ontology_io.files.folder import read_folder
from ontology_io.owl.export import owl_bytes
from ontology_io.owl.file_records import OwlFile
from ontology_io.owl.reading import read_owl
from ontology_io.records import KnowledgeBase
from plans.engine.intents import Intent, IntentTest, Library, PlanSentence, Slot
from tests.ontology.hostile_owl import changed, document
from tests.ontology.owl_expected import expected
from tests.ontology.small_content import write_files

SHIPPED = Path(__file__).parents[2] / "content"


def written(base: KnowledgeBase, last: dict[str, int], remainder: str = "") -> bytes:
    chunks = owl_bytes(base, iri="urn:cair:kb", version="draft", highest=last, remainder=remainder)
    return b"".join(chunks)


def assert_same(found: OwlFile, wanted: OwlFile) -> None:
    """Compare part by part, so that a difference is short."""
    for name in OwlFile.__struct_fields__:
        mine, theirs = getattr(found, name), getattr(wanted, name)
        if mine != theirs and isinstance(mine, tuple) and len(mine) == len(theirs):
            for one, other in zip(mine, theirs, strict=True):
                assert one == other
        assert mine == theirs, name


def circle(base: KnowledgeBase, last: dict[str, int]) -> None:
    assert_same(read_owl(written(base, last)), expected(base, last))


def test_the_small_content_comes_back_with_the_same_facts(tmp_path: Path) -> None:
    folder = read_folder(write_files(tmp_path))
    circle(folder.base, dict(folder.last))


def test_the_shipped_content_comes_back_with_the_same_facts() -> None:
    folder = read_folder(SHIPPED)
    circle(folder.base, dict(folder.last))


def test_a_made_up_base_comes_back_with_the_same_facts() -> None:
    base = synthetic(topics=60, rows=480, intents=8)
    circle(base, highest(base))


TEXTS = st.text(
    st.characters(
        exclude_categories=("Cs", "Cc"),
        include_characters="\n\t",
        exclude_characters="\ufffe\uffff",
    ),
    min_size=1,
    max_size=60,
).filter(str.strip)


@settings(max_examples=12, deadline=None, suppress_health_check=list(HealthCheck))
@given(st.lists(TEXTS, min_size=8, max_size=8))
def test_any_text_comes_back_as_it_was(texts: list[str]) -> None:
    topic = Topic(
        key="Tea",
        is_a="Topic",
        number=1,
        note=texts[0],
        names={"en": {"name": texts[1]}, "ja": {"name": texts[1], "kana": texts[2]}},
        keywords={"it": ((texts[3].replace("|", "l"),), ("*",))},
        likeliness={"EN": 0.001},
        frames=(
            Frame(key="Tea.q1", type="q", number=1, texts={"en": texts[4], "it": texts[4]}),
            Frame(key="Tea.q2", type="q", number=2, texts={"en": texts[4]}),
            Frame(key="Tea.c1", type="c", number=3, texts={"en": texts[4]}, only=("EN",)),
            Frame(key="Tea.c2", type="c", number=4, texts={"en": texts[4]}, only=("EN",)),
        ),
    )
    intent = Intent(
        number=1,
        key="sing",
        slots=(Slot(name="title", questions={"en": texts[5]}),),
        triggers={"en": (texts[5], texts[6]), "it": (texts[6],)},
        plan_sentences={"en": (PlanSentence(text=texts[7], only=("EN",)),)},
        tests={"en": (IntentTest(sentence=texts[5], parameters={"title": texts[6]}),)},
        note=texts[7],
    )
    base = KnowledgeBase(
        knowledge=Knowledge(
            cultures=(Culture(code="EN", names={"en": texts[3]}, language="en"),), topics=(topic,)
        ),
        library=Library(intents=(intent,)),
    )
    circle(base, {"topic": 1})


def test_the_order_of_the_file_does_not_matter() -> None:
    sample = document()
    assert read_owl(sample.shuffled()) == read_owl(sample.bytes())


def test_terms_of_the_predecessor_are_read_as_ours() -> None:
    ours = document().bytes()
    theirs = ours.replace(b"urn:cair:vocab#", b"http://caressesrobot.org/ontology#")
    assert read_owl(theirs) == read_owl(ours)


def test_a_link_to_owl_xml_says_the_same() -> None:
    found = read_owl(document().as_owlxml())
    assert [topic.key for topic in found.topics] == ["Drink", "Tea"]
    assert found.topics[1].individuals[0].likeliness == 0.9
    assert [said.text for said in found.topics[0].said] == ["Do you like $hasName?"]


def test_what_the_vocabulary_does_not_know_is_kept_and_counted() -> None:
    data = changed(
        tea="""
        <rdfs:seeAlso rdf:resource="https://example.org/tea"/>
        <rdfs:subClassOf><owl:Restriction>
          <owl:onProperty rdf:resource="urn:cair:vocab#hasTopic"/>
          <owl:someValuesFrom rdf:resource="urn:cair:kb#Drink"/>
        </owl:Restriction></rdfs:subClassOf>"""
    )
    found = read_owl(data)
    assert found.unknown == {"owl:Restriction someValuesFrom": 1, "rdfs:seeAlso": 1}
    assert found.remainder.count("\n") == 5
    assert not found.problems


def test_the_remainder_goes_out_and_comes_back_the_same(tmp_path: Path) -> None:
    folder = read_folder(write_files(tmp_path))
    first = read_owl(
        changed(
            tea="""<rdfs:subClassOf><owl:Class><owl:unionOf rdf:parseType="Collection">
            <rdf:Description rdf:about="urn:cair:kb#Drink"/><owl:Restriction>
            <owl:onProperty rdf:resource="urn:cair:vocab#hasLikeliness"/>
            <owl:hasValue rdf:datatype="http://www.w3.org/2001/XMLSchema#decimal">0.00001</owl:hasValue>
            </owl:Restriction></owl:unionOf></owl:Class></rdfs:subClassOf>
            <rdfs:comment xml:lang="en">Two\nlines "quoted" \\ é 緑</rdfs:comment>"""
        )
    )
    assert first.remainder
    again = read_owl(written(folder.base, {}, first.remainder))
    assert again.remainder == first.remainder
    assert again.unknown == first.unknown


def test_a_sentence_that_is_not_active_is_kept_but_not_said() -> None:
    data = (
        document()
        .bytes()
        .replace(b"<cair:id>s1</cair:id>", b"<cair:id>s1</cair:id><cair:active>false</cair:active>")
    )
    found = read_owl(data)
    assert found.topics[0].said == ()
    assert "Do you like $hasName?" in found.remainder


def test_a_comment_on_a_sentence_is_kept_beside_it() -> None:
    data = (
        document()
        .bytes()
        .replace(
            b"<cair:id>s1</cair:id>", b"<cair:id>s1</cair:id><rdfs:comment>Nice</rdfs:comment>"
        )
    )
    found = read_owl(data)
    assert found.topics[0].said[0].id == "s1"
    assert found.unknown == {"rdfs:comment": 1}
    assert "annotatedTarget" in found.remainder
    assert "s1" not in found.remainder


def test_persons_are_left_out_and_counted() -> None:
    data = changed(
        end="""<owl:NamedIndividual rdf:about="urn:cair:kb#ROSA">
          <rdf:type rdf:resource="urn:cair:vocab#User"/>
          <cair:hasName xml:lang="en">Rosa</cair:hasName>
        </owl:NamedIndividual>
        <owl:NamedIndividual rdf:about="urn:cair:kb#ROSA_TEA">
          <rdf:type rdf:resource="urn:cair:kb#Tea"/>
          <cair:concernsUser rdf:resource="urn:cair:kb#ROSA"/>
          <cair:hasPositiveSentence xml:lang="en">Rosa loves it.</cair:hasPositiveSentence>
        </owl:NamedIndividual>
        <rdf:Description rdf:about="urn:cair:kb#EN_TEA">
          <cair:hasSpecific rdf:resource="urn:cair:kb#ROSA_TEA"/>
        </rdf:Description>
        <owl:Axiom><owl:annotatedSource rdf:resource="urn:cair:kb#ROSA_TEA"/>
          <owl:annotatedProperty rdf:resource="urn:cair:vocab#hasPositiveSentence"/>
          <owl:annotatedTarget xml:lang="en">Rosa loves it.</owl:annotatedTarget>
          <cair:id>s99</cair:id></owl:Axiom>"""
    )
    found = read_owl(data)
    assert found.persons == 2
    assert "osa" not in msgspec.json.encode(found).decode()
    assert read_owl(document().bytes()).topics == found.topics


@pytest.mark.parametrize("tag", ["EN", "en-GB"])
def test_a_language_tag_is_understood_in_other_spellings(tag: str) -> None:
    data = document().bytes().replace(b'xml:lang="en">Do you', f'xml:lang="{tag}">Do you'.encode())
    found = read_owl(data)
    assert found.topics[0].said[0].language == "en"
    assert any(tag in problem.text and not problem.error for problem in found.problems)


def test_what_is_left_over_is_what_another_reader_finds() -> None:
    rdflib = pytest.importorskip("rdflib")
    compare = pytest.importorskip("rdflib.compare")
    added = """
        <rdfs:seeAlso rdf:nodeID="nothing"/>
        <owl:equivalentClass><owl:Class><owl:intersectionOf rdf:parseType="Collection">
          <rdf:Description rdf:about="urn:cair:kb#Drink"/>
          <owl:Restriction><owl:onProperty rdf:resource="urn:cair:kb#hot"/>
            <owl:allValuesFrom><owl:Class><owl:complementOf rdf:resource="urn:cair:kb#Cold"/>
            </owl:Class></owl:allValuesFrom></owl:Restriction>
        </owl:intersectionOf></owl:Class></owl:equivalentClass>"""
    plain = {*rdflib.Graph().parse(data=document().bytes(), format="xml")}
    everything = rdflib.Graph().parse(data=changed(tea=added), format="xml")
    bare = rdflib.Graph()
    known = {triple for triple in plain if not any(isinstance(x, rdflib.BNode) for x in triple)}
    restriction = rdflib.URIRef("urn:cair:vocab#hasQuestion")
    said = set(everything.subjects(rdflib.OWL.onProperty, restriction))
    said |= set(everything.subjects(rdflib.RDF.type, rdflib.OWL.Axiom))
    for triple in everything:
        if triple not in known and not said & {triple[0], triple[2]}:
            bare.add(triple)
    found = read_owl(changed(tea=added))
    assert compare.isomorphic(bare, rdflib.Graph().parse(data=found.remainder, format="nt"))
    assert len(bare) == 13


def test_a_property_that_could_not_be_written_again_is_told() -> None:
    added = "<k:tè xmlns:k='urn:cair:kb#'>x</k:tè>"
    found = read_owl(changed(tea=added))
    assert [problem.where for problem in found.problems if problem.error] == ["tè"]


def test_an_annotation_of_a_sentence_that_is_gone_is_left_out_with_a_word() -> None:
    data = document().bytes().replace(b'<rdfs:subClassOf rdf:nodeID="r1"/>', b"")
    found = read_owl(data)
    assert found.topics[0].said == ()
    assert [problem.error for problem in found.problems] == [False]
    assert found.remainder == ""
