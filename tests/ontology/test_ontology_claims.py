"""What docs/ontology.md says of an edit is what an import makes of it."""

from pathlib import Path

import pytest
from rdflib import OWL, RDF, RDFS, XSD, Graph, Literal

from ontology_io.exporting import export_draft
from ontology_io.files.folder import Folder
from ontology_io.importing import Preview, preview
from tests.ontology.ontology_edits import (
    CAIR,
    KB,
    Edit,
    added,
    decimal,
    edited,
    put,
    question,
    renamed,
    without,
)
from tests.ontology.ontology_page import PAGE
from tests.ontology.owlapi import needs_java, owlapi

TEXT = PAGE.read_text(encoding="utf-8")
FIRST_CELLS = {line.split("|")[1].strip() for line in TEXT.splitlines() if line.startswith("| ")}


def looked_at(edit: Edit) -> tuple[set[tuple[str, str]], Preview]:
    """Return what an edit changes, as what and key, and the preview."""
    found = preview(edited(numbered_export(), edit))
    assert found.errors == ()
    return {(one.what, one.key) for one in found.changes}, found


#: First cell of a row of "Bring it back", an edit, what it changes, whether one is told.
CLAIMS: list[tuple[str, Edit, set[tuple[str, str]], bool]] = [
    ("nothing", lambda _graph: None, set(), False),
    (
        "a new class, individual, sentence, intent",
        question("Is $hasName your favourite?"),
        {("added", "Tea.q1")},
        False,
    ),
    (
        "a changed text, value, label, keyword, superclass",
        put("EN_TEA", CAIR.hasLikeliness, decimal("0.9")),
        {("changed", "Tea")},
        False,
    ),
    (
        "an individual is missing",
        without("EN_GREENTEA"),
        {("changed", "GreenTea")},
        True,
    ),
    (
        "likeliness with more than three decimals",
        put("EN_TEA", CAIR.hasLikeliness, decimal("0.12345")),
        {("changed", "Tea")},
        True,
    ),
    (
        "likeliness as xsd:double, a tag such as `en-GB`",
        put("EN_TEA", CAIR.hasLikeliness, Literal("0.5", datatype=XSD.double)),
        set(),
        True,
    ),
    (
        "likeliness as xsd:double, a tag such as `en-GB`",
        question("Is $hasName your favourite?", "en-GB"),
        {("added", "Tea.q1")},
        True,
    ),
    (
        "a link for some cultures only",
        added("EN_TEA", CAIR.hasTopic, KB.EN_MILK),
        {("changed", "Tea")},
        True,
    ),
    (
        "a link for some cultures only",
        without("EN_GREENTEA", CAIR.hasTopic, KB.EN_MILK),
        set(),
        True,
    ),
    (
        "an `id` that occurs twice (a copy)",
        question("Is $hasName your favourite?", id=Literal("f1.en")),
        {("added", "Tea.q1")},
        True,
    ),
]


@pytest.mark.parametrize(("row", "edit", "changes", "told"), CLAIMS)
def test_an_edit_is_taken_as_the_page_says(
    row: str,
    edit: Edit,
    changes: set[tuple[str, str]],
    told: bool,
    small_draft: Folder,
) -> None:
    assert row in FIRST_CELLS
    found, looked = looked_at(edit)
    assert found == changes
    assert bool(looked.problems) == told


def numbered_export() -> bytes:
    """Return the export of the draft, which has numbers."""
    return b"".join(export_draft())


@needs_java
def test_what_protege_saves_is_what_it_opened(small_draft: Folder, tmp_path: Path) -> None:
    opened, saved = tmp_path / "cair.owl", tmp_path / "saved.owl"
    opened.write_bytes(numbered_export())
    owlapi(opened, saved)
    found = preview(saved.read_bytes())
    assert saved.read_bytes() != opened.read_bytes()
    assert (found.problems, found.changes, found.unknown) == ((), (), {})


def test_one_frame_says_the_same_in_three_languages(small_draft: Folder) -> None:
    def edit(graph: Graph) -> None:
        for text, code in (("Tea?", "en"), ("Tè?", "it"), ("お茶ですか？", "ja")):
            question(text, code, frame=Literal("new1"))(graph)

    found, looked = looked_at(edit)
    assert found == {("added", "Tea.q1")}
    frames = {frame.key: frame for one in looked.plan.base.knowledge.topics for frame in one.frames}
    assert frames["Tea.q1"].texts == {"en": "Tea?", "it": "Tè?", "ja": "お茶ですか？"}


def test_a_new_name_with_the_old_id_is_a_rename(small_draft: Folder) -> None:
    found = preview(renamed("GreenTea", "Matcha")(numbered_export()))
    assert found.errors == ()
    assert [(one.old, one.new) for one in found.renamed] == [("GreenTea", "Matcha")]


def test_a_new_name_without_the_old_id_is_another_topic(small_draft: Folder) -> None:
    assert "a new local name without the old `id`" in FIRST_CELLS
    data = edited(renamed("Milk", "Latte")(numbered_export()), without("Latte", CAIR.id))
    found = {(one.what, one.key) for one in preview(data).changes if one.kind == "topics"}
    assert {("removed", "Milk"), ("added", "Latte")} <= found


def test_a_file_without_pools_leaves_those_of_the_draft(small_draft: Folder) -> None:
    def edit(graph: Graph) -> None:
        for kind in (CAIR.Pool, CAIR.Phrase, CAIR.ValueList, CAIR.CanonicalValue):
            for thing in list(graph.subjects(RDF.type, kind)):
                for note in list(graph.subjects(OWL.annotatedSource, thing)):
                    graph.remove((note, None, None))
                graph.remove((thing, None, None))

    found, looked = looked_at(edit)
    assert found == set()
    assert {problem.where for problem in looked.problems} == {"Pool", "Phrases"}


def test_what_is_missing_is_removed_or_kept(small_draft: Folder) -> None:
    def edit(graph: Graph) -> None:
        for name in ("Flower", "EN_FLOWER", "JP_FLOWER"):
            graph.remove((KB[name], None, None))
            graph.remove((None, None, KB[name]))

    data = edited(numbered_export(), edit)
    assert ("removed", "Flower") in {(one.what, one.key) for one in preview(data).changes}
    assert not preview(data, keep=True).changes


def test_a_topic_without_a_name_in_some_language_comes_in_and_is_told(small_draft: Folder) -> None:
    def edit(graph: Graph) -> None:
        graph.add((KB.Matcha, RDF.type, OWL.Class))
        graph.add((KB.Matcha, RDFS.subClassOf, KB.Tea))
        graph.add((KB.Matcha, RDFS.label, Literal("matcha", lang="en")))

    found, looked = looked_at(edit)
    assert found == {("added", "Matcha")}
    assert "in ja" in " ".join(map(str, looked.findings))


def test_a_sentence_that_is_not_active_is_not_said_and_kept(small_draft: Folder) -> None:
    found, looked = looked_at(question("Is it hot?", active=Literal(False)))
    assert found == set()
    assert looked.unknown["active"] == 1
    assert "Is it hot?" in looked.plan.remainder


def test_a_name_on_an_individual_does_not_replace_the_label(small_draft: Folder) -> None:
    found, looked = looked_at(added("EN_TEA", CAIR.hasName, Literal("cuppa", lang="en")))
    assert found == set()
    assert [problem.where for problem in looked.problems] == ["EN_TEA"]


def test_axioms_that_cair_does_not_know_are_counted_and_kept(small_draft: Folder) -> None:
    note = Literal("https://example.org/tea", datatype=XSD.anyURI)
    found = preview(edited(numbered_export(), added("Tea", RDFS.seeAlso, note)))
    assert found.changes == ()
    assert found.unknown == {"rdfs:seeAlso": 1}
    assert "example.org/tea" in found.plan.remainder
