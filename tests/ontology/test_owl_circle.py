"""Out, in, out again: nothing is lost, nothing changes, and the same bytes come out."""

import pytest

from ontology_io.files.folder import Folder, read_folder
from ontology_io.importing import preview
from ontology_io.numbering import last_numbers
from ontology_io.records import KnowledgeBase
from ontology_io.remainder import keep_remainder, remainder_text
from ontology_io.store import read_base, write_base
from tests.ontology.owl_edits import brought, empty_tables, exported
from tests.site_fixtures import CONTENT

SEE = "http://www.w3.org/2000/01/rdf-schema#seeAlso"
REMAINDER = f"<urn:cair:kb#Tea> <{SEE}> <https://example.org/tea> .\n"


def by_key(base: KnowledgeBase) -> tuple[object, ...]:
    """Return it without the order of topics that are no siblings."""
    topics = {topic.key: topic for topic in base.knowledge.topics}
    below: dict[str, list[str]] = {}
    for topic in base.knowledge.topics:
        below.setdefault(topic.is_a, []).append(topic.key)
    return base.library, base.knowledge.cultures, base.knowledge.pools, topics, below


def test_our_own_export_changes_nothing(small_draft: Folder) -> None:
    found = preview(exported())
    assert found.problems == ()
    assert found.changes == ()
    assert not found
    assert found.plan.base == read_base()


def test_what_is_brought_into_an_empty_database_goes_out_as_the_same_bytes(
    small_draft: Folder,
) -> None:
    before, data, last = read_base(), exported(), last_numbers()
    empty_tables()
    assert brought(data).counts["topics"] == {"added": 5}
    assert exported() == data
    assert by_key(read_base()) == by_key(before)
    assert last_numbers() == last


@pytest.mark.usefixtures("empty_draft")
def test_the_shipped_content_comes_back_byte_for_byte() -> None:
    folder = read_folder(CONTENT)
    write_base(folder.base, folder.last)
    data = exported()
    assert not preview(data)
    empty_tables()
    assert brought(data).problems == ()
    assert exported() == data


def test_importing_twice_is_importing_once(small_draft: Folder) -> None:
    data = exported()
    empty_tables()
    brought(data)
    once = read_base()
    brought(data)
    assert read_base() == once


def test_what_the_vocabulary_does_not_know_goes_round(small_draft: Folder) -> None:
    keep_remainder(REMAINDER)
    data = exported()
    assert SEE.encode() in data or b"rdfs:seeAlso" in data
    found = brought(data)
    assert not found
    assert found.unknown == {"rdfs:seeAlso": 1}
    assert remainder_text() == REMAINDER
    brought(exported())
    assert exported() == data


def test_a_file_without_the_remainder_takes_it_away_and_tells(small_draft: Folder) -> None:
    data = exported()
    keep_remainder(REMAINDER)
    found = preview(data)
    assert (found.changes, found.kept) == ((), (0, 1))
    assert preview(data, keep=True).kept == (0, 0)
    brought(data)
    assert remainder_text() == ""
