"""The person-specific layer: a file that opens by itself, and that an import leaves out."""

from pathlib import Path

import pytest
from rdflib import OWL, RDF, Graph, URIRef

from ontology_io.exporting import export_draft
from ontology_io.files.folder import Folder
from ontology_io.importing import Preview, preview
from ontology_io.owl.limits import OwlError
from ontology_io.owl.reading import read_owl
from ontology_io.owl.vocabulary import VOCABULARY
from ontology_io.owl.write_person import (
    Liking,
    Person,
    PersonalIndividual,
    can_be_written,
    person_owl,
    personal_individuals,
    prefix_of,
)
from ontology_io.owl.xml_writer import UnwritableError
from tests.ontology.owl_readers import IRI, KB, about, local, read_graph, read_horned
from tests.ontology.owlapi import needs_java, owlapi

SMITH = Person("Dorothy Smith", "DS", "EN")
TEA = Liking("Tea", 2, ("Drink",), 0.9, "EN_TEA")
GREEN_TEA = Liking("GreenTea", 4, ("Tea", "Drink"), 0.0, "EN_GREENTEA")
MILK = Liking("Milk", 3, ("Drink",), 1.0, "")


def written(*likings: Liking, person: Person = SMITH) -> bytes:
    return person_owl(personal_individuals(likings, person), person, iri=IRI).encode()


def test_a_liking_is_the_individual_of_the_paper() -> None:
    graph = read_graph(written(TEA))
    assert about(graph, "DS_TEA") == {
        ("type", "NamedIndividual"),
        ("type", "Tea"),
        ("concernsUser", "USER_DS"),
        ("hasLikeliness", "0.9"),
    }
    assert ("hasSpecific", "DS_TEA") in about(graph, "EN_TEA")
    assert ("hasCulture", "CULTURE_EN") in about(graph, "EN_TEA")
    assert ("label", "Dorothy Smith") in about(graph, "USER_DS")


def test_what_a_liking_is_about_lies_below_topic() -> None:
    graph = read_graph(written(GREEN_TEA))
    assert about(graph, "GreenTea") == {("type", "Class"), ("subClassOf", "Tea")}
    assert about(graph, "Drink") == {("type", "Class"), ("subClassOf", "Topic")}


def test_a_culture_without_an_individual_is_not_named() -> None:
    graph = read_graph(written(MILK))
    assert about(graph, "CULTURE_EN") == set()
    assert ("concernsUser", "USER_DS") in about(graph, "DS_MILK")


def test_everything_that_is_named_is_declared() -> None:
    graph = read_graph(written(TEA, GREEN_TEA, MILK))
    kinds = (OWL.Class, OWL.ObjectProperty, OWL.DatatypeProperty, OWL.NamedIndividual)
    declared = {thing for kind in kinds for thing in graph.subjects(RDF.type, kind)}
    spaces = (VOCABULARY, KB)
    named = {
        term
        for triple in graph
        for term in triple
        if isinstance(term, URIRef) and term.startswith(spaces)
    }
    assert {local(term) for term in named - declared} == set()


def test_other_readers_find_the_same_individuals() -> None:
    ontology = read_horned(written(TEA, MILK))
    names = {local(name) for name in ontology.get_named_individuals()}
    assert names == {"DS_TEA", "DS_MILK", "EN_TEA", "CULTURE_EN", "USER_DS"}


@needs_java
def test_the_file_is_owl_2_dl(tmp_path: Path) -> None:
    file = tmp_path / "person.owl"
    file.write_bytes(written(TEA, GREEN_TEA, MILK))
    told = owlapi(file)
    assert [line for line in told if line.startswith("violation")] == []
    assert "individuals 7" in told


@pytest.mark.parametrize(
    ("label", "prefix"),
    [
        ("", "PS"),
        ("Dorothy Smith", "DS"),
        ("DS", "DS"),
        ("dorothy", "D"),
        ("Mrs. Élodie de la Tour", "MEDLT"),
        ("R2D2", "R2D2"),
        ("a b c d e f g h i j", "ABCDEFGH"),
        ("ABCDEFGHIJ", "A"),
        ("山田花子", "PS"),
        ("12", "PS"),
        ("EN", "PSEN"),
        ("Ivo Turri", "PSIT"),
        ("USER", "PSUSER"),
        ("INTENT", "PSINTENT"),
        ("../../x <y>", "XY"),
    ],
)
def test_the_names_begin_with_initials(label: str, prefix: str) -> None:
    assert prefix_of(label, ("EN", "IT")) == prefix


def test_topics_that_differ_in_capitals_only_get_names_of_their_own() -> None:
    other = Liking("TEA", 9, (), 0.5, "")
    found = personal_individuals((TEA, other), SMITH)
    assert found == (PersonalIndividual("DS_TEA", TEA), PersonalIndividual("DS_TEA_t9", other))


@pytest.mark.parametrize("label", ["a\x00", "\x1b", "\ufffe", "\ud800"])
def test_a_label_that_xml_cannot_hold_is_refused(label: str) -> None:
    assert not can_be_written(label)
    with pytest.raises(UnwritableError):
        written(TEA, person=Person(label, "DS", "EN"))


def merged(*files: bytes) -> bytes:
    """Return the triples of the files in one."""
    graph = Graph()
    for file in files:
        graph += read_graph(file)
    return graph.serialize(format="xml").encode()


def previewed(*files: bytes) -> Preview:
    found = preview(merged(*files))
    assert found.problems == ()
    return found


def test_an_import_leaves_persons_out_and_counts_them(small_draft: Folder) -> None:
    export = b"".join(export_draft())
    found = previewed(export, written(TEA, GREEN_TEA))
    assert (found.changes, found.unknown, found.persons) == ((), {}, 3)
    assert not found
    assert previewed(export).persons == 0


def test_nothing_of_a_person_is_kept_for_the_next_export(small_draft: Folder) -> None:
    found = previewed(b"".join(export_draft()), written(TEA))
    assert "Smith" not in found.plan.remainder
    assert "DS" not in found.plan.remainder


def test_the_likings_of_a_person_alone_are_no_knowledge_base() -> None:
    with pytest.raises(OwlError, match="the likings of a person"):
        read_owl(written(TEA))
