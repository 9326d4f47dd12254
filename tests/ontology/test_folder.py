"""The folder content/ as a whole: canonical, complete, and never more than ours is touched."""

from pathlib import Path

import msgspec
import pytest

from dialogue.engine.concepts import Topic
from dialogue.engine.tree_order import in_tree_order
from ontology_io.check import check_base
from ontology_io.files.folder import file_name, folder_texts, read_folder, write_folder
from ontology_io.numbering import last_numbers
from ontology_io.store import read_base
from tests.ontology.small_content import FILES, FLOWER, write_files
from tests.site_fixtures import CONTENT

COMPLETE = (CONTENT / "numbers.tsv").exists()


@pytest.mark.skipif(not COMPLETE, reason="content/ is being written: run make content")
def test_the_shipped_content_is_canonical(db: None, loaded_database: None) -> None:
    texts = folder_texts(read_base(), last_numbers())
    files = {file.name: file.read_bytes() for file in CONTENT.iterdir()}
    assert files.keys() == texts.keys()
    assert [name for name, text in texts.items() if files[name] != text.encode()] == []


def test_the_small_folder_is_written_as_it_was_read(small_folder: Path) -> None:
    folder = read_folder(small_folder)
    assert check_base(folder.base) == []
    texts = folder_texts(folder.base, folder.last)
    assert {name: text for name, text in texts.items() if name != "numbers.tsv"} == FILES
    assert write_folder(small_folder, folder.base, folder.last) == ("numbers.tsv",)
    assert write_folder(small_folder, folder.base, folder.last) == ()


def test_the_file_of_a_branch_that_is_gone_goes(small_folder: Path) -> None:
    folder = read_folder(small_folder)
    write_files(small_folder, old_flower=FLOWER)
    assert "old_flower.yaml" in write_folder(small_folder, folder.base, folder.last)
    assert not (small_folder / "old_flower.yaml").exists()


def test_a_yaml_file_that_holds_no_topics_is_left_alone(small_folder: Path) -> None:
    folder = read_folder(small_folder)
    write_files(small_folder, compose="services: {db: {image: postgres}}", broken="a: [", empty="#")
    write_folder(small_folder, folder.base, folder.last)
    assert {file.name for file in small_folder.iterdir()} >= {
        "compose.yaml",
        "broken.yaml",
        "empty.yaml",
    }


def test_a_branch_has_the_file_of_its_name() -> None:
    assert file_name("FoodAndDrink") == "food_and_drink.yaml"
    assert file_name("Pools") == "pools_topics.yaml"


def rose(**changed: object) -> Topic:
    return msgspec.structs.replace(Topic(key="Rose", is_a="Topic"), **changed)


def test_branches_called_like_our_files_or_alike_lose_nothing(small_folder: Path) -> None:
    folder = read_folder(small_folder)
    likeliness = {"EN": 0.5, "JP": 0.5}
    more = tuple(rose(key=key, likeliness=likeliness) for key in ("Cultures", "Tea", "tea"))
    knowledge = msgspec.structs.replace(folder.base.knowledge, topics=in_tree_order(more))
    base = msgspec.structs.replace(folder.base, knowledge=knowledge)
    write_folder(small_folder, base, folder.last)
    assert read_folder(small_folder).base.knowledge == knowledge


def test_a_circle_of_topics_can_be_written(small_folder: Path) -> None:
    folder = read_folder(small_folder)
    circle = (rose(is_a="Tulip"), rose(key="Tulip", is_a="Rose"), rose(key="Elm", is_a="Tulip"))
    knowledge = msgspec.structs.replace(folder.base.knowledge, topics=circle)
    base = msgspec.structs.replace(folder.base, knowledge=knowledge)
    assert "Tulip" in folder_texts(base, folder.last)["rose.yaml"]


def test_a_new_topic_is_checked_though_it_has_no_number_yet(small_folder: Path) -> None:
    files = {"flower": FLOWER + FLOWER.replace("Flower", "Rose").replace("leaves:\n", "")}
    folder = read_folder(write_files(small_folder, **files))
    first, *others = folder.base.knowledge.topics
    broken = msgspec.structs.replace(first, variables={})
    knowledge = msgspec.structs.replace(folder.base.knowledge, topics=(broken, *others))
    found = check_base(msgspec.structs.replace(folder.base, knowledge=knowledge))
    assert {(finding.code, finding.where) for finding in found} == {
        ("D022", key) for key in ("Tea", "Milk", "GreenTea")
    }
