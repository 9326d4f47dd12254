"""Numbers are given once: keys keep theirs, and what is gone never lends its number again."""

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dialogue import models
from dialogue.engine.concepts import Frame, Knowledge, Topic
from ontology_io.files.folder import Folder, read_folder, write_folder
from ontology_io.numbering import last_numbers, numbered, raise_last_numbers
from ontology_io.records import KnowledgeBase
from ontology_io.store import read_base, write_base
from tests.ontology.small_content import DRINK, write_files

pytestmark = pytest.mark.usefixtures("empty_draft")


def base(**numbers: int) -> KnowledgeBase:
    """Return topics with numbers, each with one frame of the same number."""
    return KnowledgeBase(
        knowledge=Knowledge(
            topics=tuple(
                Topic(
                    key=key,
                    is_a="Topic",
                    number=number,
                    frames=(Frame(key=f"{key}.q1", type="q", texts={}, number=number),),
                )
                for key, number in numbers.items()
            )
        )
    )


def given_numbers(found: KnowledgeBase) -> dict[str, int]:
    return {topic.key: topic.number for topic in found.knowledge.topics}


def test_a_known_key_keeps_its_number_whatever_the_file_says() -> None:
    assert given_numbers(numbered(base(Tea=9, Milk=0), base(Tea=3, Milk=5))) == {
        "Tea": 3,
        "Milk": 5,
    }


def test_a_new_key_keeps_the_number_it_brings() -> None:
    assert given_numbers(numbered(base(Tea=3, Milk=9), base(Tea=3))) == {"Tea": 3, "Milk": 9}


def test_a_number_taken_by_somebody_else_is_not_given_twice() -> None:
    assert given_numbers(numbered(base(Milk=3, Tea=0), base(Tea=3))) == {"Milk": 4, "Tea": 3}
    assert given_numbers(numbered(base(Milk=3, Rose=3), base())) == {"Milk": 3, "Rose": 4}


def test_a_new_name_with_the_number_of_one_that_is_gone_is_a_renaming() -> None:
    assert given_numbers(numbered(base(Chai=3), base(Tea=3))) == {"Chai": 3}


def test_the_number_of_what_goes_is_not_given_to_what_comes() -> None:
    assert given_numbers(numbered(base(Milk=0), base(Tea=3))) == {"Milk": 4}


def test_a_frame_keeps_the_slot_it_has_here() -> None:
    (topic,) = base(Tea=3).knowledge.topics
    frame = Frame(key="Tea.q1", type="q", texts={}, number=3, slot=17)
    old = KnowledgeBase(
        knowledge=Knowledge(topics=(Topic(key="Tea", is_a="Topic", number=3, frames=(frame,)),))
    )
    (topic,) = numbered(base(Tea=3), old).knowledge.topics
    assert topic.frames[0].slot == 17


keys = st.sampled_from(["Tea", "Milk", "Rose", "Elm"])


@given(st.dictionaries(keys, st.integers(0, 6)), st.dictionaries(keys, st.integers(1, 6)))
def test_numbers_are_always_different_and_known_keys_keep_theirs(
    brought: dict[str, int], known: dict[str, int]
) -> None:
    old = numbered(base(**known), base())
    found = given_numbers(numbered(base(**brought), old))
    assert len({*found.values()}) == len(brought)
    assert 0 not in found.values()
    kept = given_numbers(old)
    assert all(found[key] == kept[key] for key in found if key in kept)


def test_a_deleted_number_never_comes_back_from_files(small_draft: Folder, tmp_path: Path) -> None:
    rose = models.Topic.objects.create(key="Rose")
    taken = rose.pk
    rose.delete()
    more = DRINK.replace("lines:", "- {id: Cocoa, is_a: Drink}\nlines:")
    write_base(read_folder(write_files(tmp_path, drink=more)).base)
    assert models.Topic.objects.get(key="Cocoa").pk == taken + 1


def test_a_deleted_number_never_comes_back_from_the_admin(small_draft: Folder) -> None:
    rose = models.Topic.objects.create(key="Rose")
    number = rose.pk
    rose.delete()
    assert models.Topic.objects.create(key="Tulip").pk == number + 1
    frame = models.Frame.objects.create(key="start.9", pool="start")
    last = frame.pk
    frame.delete()
    assert models.Frame.objects.create(key="start.9", pool="start").pk == last + 1


def test_a_removed_number_stays_taken_through_files(small_draft: Folder, tmp_path: Path) -> None:
    rose = models.Topic.objects.create(key="Rose")
    taken = rose.pk
    rose.delete()
    write_folder(tmp_path, read_base(), last_numbers())
    assert read_folder(tmp_path).last["topic"] == taken


@pytest.mark.parametrize("loads", [1, 2])
def test_the_ledger_raises_the_last_number(small_draft: Folder, loads: int) -> None:
    for _ in range(loads):
        write_base(small_draft.base, {"topic": 500, "frame": 600, "intent": 70})
    assert last_numbers() == {"topic": 500, "frame": 600, "intent": 70}
    assert models.Topic.objects.create(key="Rose").pk == 501
    raise_last_numbers({"topic": 3})
    assert models.Topic.objects.create(key="Tulip").pk == 502
