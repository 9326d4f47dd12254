"""What docs/ontology.md calls refused is refused."""

from collections.abc import Callable

import pytest
from rdflib import OWL, RDF, RDFS, Literal

from ontology_io.files.folder import read_folder
from ontology_io.owl.limits import OwlError
from ontology_io.owl.reading import read_owl
from tests.ontology.ontology_edits import (
    CAIR,
    KB,
    Edit,
    added,
    decimal,
    edited,
    only_persons,
    put,
    question,
    renamed,
    second_individual,
    without,
)
from tests.ontology.ontology_page import PAGE
from tests.ontology.owl_readers import exported, read_graph
from tests.ontology.small_content import write_files

TEXT = PAGE.read_text(encoding="utf-8")
FIRST_CELLS = {line.split("|")[1].strip() for line in TEXT.splitlines() if line.startswith("| ")}


@pytest.fixture(scope="module")
def export(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    """Return the export of the small content."""
    folder = write_files(tmp_path_factory.mktemp("small"))
    return exported(read_folder(folder).base)


#: First cell of a row of "What is refused" → bytes that must be refused.
REFUSED_BYTES: list[tuple[str, Callable[[bytes], bytes]]] = [
    (
        "Turtle, Manchester, functional syntax, JSON-LD",
        lambda data: read_graph(data).serialize(format="turtle").encode(),
    ),
    (
        "Turtle, Manchester, functional syntax, JSON-LD",
        lambda data: read_graph(data).serialize(format="json-ld").encode(),
    ),
    (
        "a file cut short, in another encoding than it says, or larger than the limits",
        lambda data: data[: len(data) // 2],
    ),
    (
        "a file cut short, in another encoding than it says, or larger than the limits",
        lambda data: data.replace("é".encode(), b"\xe9").replace("è".encode(), b"\xe8"),
    ),
    (
        "`owl:imports`",
        lambda data: data.replace(
            b"</owl:Ontology>", b'<owl:imports rdf:resource="urn:x:y"/></owl:Ontology>', 1
        ),
    ),
    (
        "a DOCTYPE with more than short plain entities, names of Python modules",
        lambda data: data.replace(
            b"?>\n", b'?>\n<!DOCTYPE r [<!ENTITY x SYSTEM "file:///etc/hostname">]>\n', 1
        ),
    ),
    (
        'property attributes, `rdf:parseType="Resource"` and `"Literal"`, a language tag on an '
        "outer element",
        lambda data: data.replace(
            b"</rdf:RDF>", b'<rdf:Description rdf:about="urn:x:y" rdfs:label="x"/></rdf:RDF>'
        ),
    ),
]
REFUSED_EDITS: list[tuple[str, Edit]] = [
    (
        "a circle of superclasses, a class that is an individual too",
        put("Drink", RDFS.subClassOf, KB.Tea),
    ),
    (
        "a circle of superclasses, a class that is an individual too",
        added("Tea", RDF.type, OWL.NamedIndividual),
    ),
    (
        "several superclasses without `treeParent`",
        added("GreenTea", RDFS.subClassOf, KB.Flower),
    ),
    (
        "a likeliness that is no number, outside 0 to 1, or there twice",
        put("EN_TEA", CAIR.hasLikeliness, Literal("much")),
    ),
    (
        "a likeliness that is no number, outside 0 to 1, or there twice",
        put("EN_TEA", CAIR.hasLikeliness, decimal("1.7")),
    ),
    (
        "a likeliness that is no number, outside 0 to 1, or there twice",
        added("EN_TEA", CAIR.hasLikeliness, decimal("0.25")),
    ),
    (
        "an individual without a culture or with two; two of one topic in one culture",
        without("EN_TEA", CAIR.hasCulture),
    ),
    (
        "an individual without a culture or with two; two of one topic in one culture",
        added("EN_TEA", CAIR.hasCulture, KB.CULTURE_JP),
    ),
    (
        "an individual without a culture or with two; two of one topic in one culture",
        second_individual,
    ),
    (
        "a text without a language tag, or in a language CAIR does not speak",
        question("Do you like it?", None),
    ),
    (
        "a text without a language tag, or in a language CAIR does not speak",
        question("Tu aimes ça ?", "fr"),
    ),
    ("a sentence that is too long, control characters", question("x" * 401)),
    ("a sentence that is too long, control characters", question("a\x85b")),
    (
        "a name that is used and not declared, a local name with other signs than letters, "
        "digits, `_`, `.`, `-`",
        added("EN_TEA", CAIR.hasTopic, KB.EN_NOTHING),
    ),
    ("another ontology: nothing below `Topic` and no intent", only_persons),
]


@pytest.mark.parametrize(("row", "edit"), REFUSED_BYTES)
def test_a_file_of_this_kind_is_refused(
    row: str, edit: Callable[[bytes], bytes], export: bytes
) -> None:
    assert row in FIRST_CELLS
    with pytest.raises(OwlError):
        read_owl(edit(export))


@pytest.mark.parametrize(("row", "edit"), REFUSED_EDITS)
def test_an_edit_of_this_kind_is_refused(row: str, edit: Edit, export: bytes) -> None:
    assert row in FIRST_CELLS
    try:
        problems = read_owl(edited(export, edit)).problems
    except OwlError as error:
        problems = error.problems
    assert [problem for problem in problems if problem.error]


def test_a_local_name_with_other_signs_is_refused(export: bytes) -> None:
    try:
        problems = read_owl(renamed("GreenTea", "Green,Tea")(export)).problems
    except OwlError as error:
        problems = error.problems
    assert [problem for problem in problems if problem.error]
