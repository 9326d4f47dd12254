"""The page docs/ontology.md names every term and limit; its code runs on the shipped content."""

import io
import re
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from contextlib import chdir
from pathlib import Path

import owlready2
import pytest
import rdflib

from ontology_io.files.folder import read_folder
from ontology_io.owl.file_records import OwlFile
from ontology_io.owl.limits import Limits
from ontology_io.owl.reading import read_owl
from ontology_io.owl.vocabulary import VOCABULARY
from ontology_io.records import KnowledgeBase
from tests.ontology.ontology_page import EXAMPLES, KINDS, PAGE, terms_table
from tests.ontology.ontology_picture import PICTURE, picture
from tests.ontology.owl_readers import IRI, exported
from tests.ontology.owl_snippets import (
    CODE,
    QUERIES,
    TEXT,
    Facts,
    Row,
    by_owlready2,
    by_rdflib,
    run,
)


@pytest.fixture(scope="module")
def base() -> KnowledgeBase:
    """Return the shipped content."""
    return read_folder(PAGE.parents[1] / "content").base


@pytest.fixture(scope="module")
def folder(base: KnowledgeBase, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder that holds the export of the shipped content."""
    folder = tmp_path_factory.mktemp("ontology")
    (folder / "cair.owl").write_bytes(exported(base))
    return folder


@pytest.fixture(scope="module")
def printed(folder: Path) -> Iterator[dict[str, str]]:
    """Return what the snippets for owlready2 print, run one after the other."""
    shared: dict[str, object] = {}
    printed = {}
    with chdir(folder):
        for kind, name in CODE:
            if kind == "python" and name != "change":
                printed[name] = run(CODE[kind, name], shared)
    yield printed
    shared["world"].close()  # type: ignore[attr-defined]


@pytest.fixture(scope="module")
def graph(folder: Path) -> rdflib.Graph:
    """Return the export as rdflib reads it."""
    graph = rdflib.Graph()
    graph.parse(folder / "cair.owl", format="xml")
    return graph


@pytest.fixture(scope="module")
def world(folder: Path) -> Iterator[owlready2.World]:
    """Return the export as owlready2 reads it."""
    world = owlready2.World()
    world.get_ontology(IRI).load(fileobj=io.BytesIO((folder / "cair.owl").read_bytes()))
    yield world
    world.close()


def test_the_page_explains_every_term() -> None:
    assert {term.name for _, terms in KINDS for term in terms} == set(EXAMPLES)
    assert terms_table() in TEXT


def test_the_picture_is_the_one_that_is_drawn() -> None:
    assert PICTURE.read_text(encoding="utf-8") == picture()
    assert f"(pictures/{PICTURE.name})" in TEXT


def test_the_examples_name_what_the_export_holds(folder: Path) -> None:
    export = (folder / "cair.owl").read_text(encoding="utf-8")
    names = set(re.findall(r"\b(?:EN|JP|INTENT|PHRASE|POOL|VALUES|CULTURE)_\w+", TEXT))
    invented = {"JP_MATCHA"}
    assert len(names) > 15
    assert {name for name in names - invented if f"{IRI}#{name}" not in export} == set()


def test_terms_named_in_the_text_exist() -> None:
    named = set(re.findall(r"(?<!urn:)\bcair:(\w+)", TEXT))
    assert named - set(EXAMPLES) == set()


def test_the_limits_are_those_of_the_reader() -> None:
    limits = Limits()
    rows = dict(re.findall(r"^\| ([^|]+?) \| (\d+)(?: characters)? \|$", TEXT, re.MULTILINE))
    assert {name: int(value) for name, value in rows.items()} == {
        "a sentence": limits.sentence,
        "any other text": limits.text,
        "elements nested in each other": limits.depth,
        "levels of the tree": limits.levels,
        "elements in all": limits.elements,
    }


def test_every_query_has_facts_to_be_compared_with() -> None:
    assert [name for name in QUERIES if not hasattr(Facts, name)] == []
    assert len(QUERIES) > 6


ENGINES: Mapping[str, Callable[..., list[Row]]] = {"graph": by_rdflib, "world": by_owlready2}


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("name", [name for name in QUERIES if name != "most_linked"])
def test_a_query_finds_what_the_records_say(
    name: str, engine: str, base: KnowledgeBase, request: pytest.FixtureRequest
) -> None:
    found = ENGINES[engine](request.getfixturevalue(engine), name)
    expected = getattr(Facts(base), name)()
    assert Counter(found) == Counter(expected)
    assert expected


@pytest.mark.parametrize("engine", ENGINES)
def test_the_most_linked_topics_are_counted(
    engine: str, base: KnowledgeBase, request: pytest.FixtureRequest
) -> None:
    found = ENGINES[engine](request.getfixturevalue(engine), "most_linked")
    assert [count for _, count in found] == Facts(base).most_linked()


@pytest.mark.parametrize("engine", ENGINES)
def test_queries_with_an_order_keep_it(engine: str, request: pytest.FixtureRequest) -> None:
    fixture = request.getfixturevalue(engine)
    values = [row[1] for row in ENGINES[engine](fixture, "by_likeliness")]
    assert values == sorted(values, reverse=True)


def test_the_snippet_of_one_topic_prints_its_facts(
    base: KnowledgeBase, printed: dict[str, str]
) -> None:
    topic = Facts(base).topics["GreenTea"]
    likeliness, links, questions = printed["one_topic"].splitlines()
    assert float(likeliness) == topic.likeliness["JP"]
    assert set(re.findall(r"\w+", links)) == {f"JP_{key.upper()}" for key in topic.see}
    inherited = [row for row in Facts(base).inherited() if row[1] == "hasQuestion"]
    assert inherited
    assert all(repr(text) in questions for _, _, text in inherited)


def test_the_snippet_of_the_tree_prints_all_branches(
    base: KnowledgeBase, printed: dict[str, str]
) -> None:
    topics = base.knowledge.topics
    branches = {topic.key for topic in topics if topic.is_a == "Topic"}
    rows = [line.split() for line in printed["tree"].splitlines() if not line.startswith(" ")]
    assert {name for name, _ in rows} == branches
    assert sum(int(count) for _, count in rows) == len(topics) - len(branches)


def test_the_snippet_of_cultures_prints_where_they_differ_most(
    base: KnowledgeBase, printed: dict[str, str]
) -> None:
    rows = [line.split() for line in printed["cultures"].splitlines()]
    values = {topic.key: topic.likeliness for topic in base.knowledge.topics}
    assert {(key, float(one), float(two)) for key, one, two in rows} == {
        (key, values[key]["EN"], values[key]["JP"]) for key, *_ in rows
    }
    apart = sorted((one["JP"] - one["EN"] for one in values.values()), reverse=True)
    assert [float(two) - float(one) for _, one, two in rows] == apart[:10]


def test_the_snippet_of_a_change_changes_exactly_that(small_folder: Path, tmp_path: Path) -> None:
    before = exported(read_folder(small_folder).base)
    (tmp_path / "cair.owl").write_bytes(before)
    with chdir(tmp_path):
        run(CODE["python", "change"], {})
    old = facts_of(read_owl(before))
    new = facts_of(read_owl((tmp_path / "changed.owl").read_bytes()))
    assert old - new == {"EN_GREENTEA 0.4"}
    assert new - old == {"EN_GREENTEA 0.6", "GreenTea q en Is $hasName your favourite?"}


def facts_of(file: OwlFile) -> set[str]:
    """Return likeliness and sentences of a file as lines, and how many topics and problems."""
    lines = {f"{len(file.topics)} topics, problems: {file.problems}"}
    for topic in file.topics:
        lines |= {f"{one.name} {one.likeliness}" for one in topic.individuals}
        lines |= {f"{topic.key} {one.type} {one.language} {one.text}" for one in topic.said}
    return lines


def test_the_page_names_the_namespaces_of_the_code() -> None:
    assert f"`{VOCABULARY}`" in TEXT
