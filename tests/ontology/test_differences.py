"""What changes between two knowledge bases is named; numbers do not count."""

from pathlib import Path

import pytest

from ontology_io.differences import Differences, Kind, differences
from ontology_io.files.folder import read_folder
from ontology_io.records import KnowledgeBase
from tests.ontology.small_content import CULTURES, DRINK, FLOWER, INTENTS, write_files


@pytest.fixture
def before(small_folder: Path) -> KnowledgeBase:
    return read_folder(small_folder).base


def changed(folder: Path, before: KnowledgeBase, **files: str) -> list[str]:
    after = read_folder(write_files(folder, **files)).base
    return [" ".join(line.split()) for line in differences(before, after).lines()]


def test_the_same_content_has_no_differences(small_folder: Path, before: KnowledgeBase) -> None:
    assert not differences(before, read_folder(small_folder).base)
    assert changed(small_folder, before) == []


ROSE = '- {id: Rose, is_a: Topic, note: "new"}\n'
LINE = 'lines:\n- {at: Flower, id: c1, en: "Red.", it: "Rosso.", ja: "赤です。"}\n'


@pytest.mark.parametrize(
    ("files", "expected"),
    [
        ({"drink": DRINK.replace("milk", "warm milk")}, ["1 topics changed: Milk"]),
        ({"drink": DRINK.replace("Lovely", "Nice")}, ["1 sentences changed: Drink.p1"]),
        ({"flower": FLOWER + LINE}, ["1 topics changed: Flower", "1 sentences added: Flower.c1"]),
        ({"flower": FLOWER.replace("- ", ROSE + "- ", 1)}, ["1 topics added: Rose"]),
        ({"flower": FLOWER.replace("id: Flower", "id: Rose")}, ["topics added", "topics removed"]),
        ({"cultures": CULTURES.replace("inglese", "britannica")}, ["1 cultures changed: EN"]),
        ({"intents": INTENTS.replace("50", "60")}, ["1 intents changed: playsong"]),
        ({"intents": INTENTS.replace("|up", "")}, ["1 phrases and values changed: volume_level"]),
    ],
)
def test_each_kind_of_change_is_named(
    small_folder: Path, before: KnowledgeBase, files: dict[str, str], expected: list[str]
) -> None:
    found = changed(small_folder, before, **files)
    assert len(found) == len(expected)
    assert all(part in line for part, line in zip(expected, found, strict=True))


def test_the_order_of_neighbours_counts(small_folder: Path, before: KnowledgeBase) -> None:
    cocoa = "- {id: Cocoa, is_a: Drink}\n"
    last = DRINK.replace("lines:", f"{cocoa}lines:")
    one = read_folder(write_files(small_folder, drink=last)).base
    first = DRINK.replace("- {id: Milk", f"{cocoa}- {{id: Milk")
    assert changed(small_folder, one, drink=first) == ["2 topics changed: Cocoa, Milk"]


def test_only_the_first_names_are_shown() -> None:
    many = Differences({"topics": Kind(removed=tuple("ABCDEFGHIJ"))})
    assert many.lines() == ["    10 topics removed: A, B, C, D, E, F, G, H and 2 more"]
