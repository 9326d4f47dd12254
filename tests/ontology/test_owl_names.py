"""Local names: minted once, never twice the same, read back."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace

from dialogue.engine.concepts import Knowledge, Topic
from ontology_io.owl import names
from ontology_io.owl.names import individual_names
from tests.ontology.owl_bases import RICH, topic


def named(*topics: Topic) -> dict[tuple[str, str], str]:
    return individual_names(Knowledge(topics=topics))


def test_an_individual_is_called_after_culture_and_topic() -> None:
    found = named(topic("GreenTea", "Topic", 4))
    assert found == {("GreenTea", "EN"): "EN_GREENTEA", ("GreenTea", "IT"): "IT_GREENTEA"}


def test_a_stored_name_is_used() -> None:
    found = named(topic("GreenTea", "Topic", 4, individuals={"EN": "EN_MATCHA", "JP": "unused"}))
    assert set(found.values()) == {"EN_MATCHA", "IT_GREENTEA"}


def test_of_two_topics_that_differ_in_capitals_the_older_keeps_the_usual_name() -> None:
    found = named(topic("GreenTEA", "Topic", 9), topic("GreenTea", "Topic", 4))
    assert found["GreenTea", "EN"] == "EN_GREENTEA"
    assert found["GreenTEA", "EN"] == "EN_GREENTEA_t9"


@pytest.mark.parametrize("stored", ["Tea", "unit", "CULTURE_EN", "INTENT_playsong", "EN_TEA"])
def test_a_stored_name_that_is_taken_gives_way(stored: str) -> None:
    first = topic("Tea", "Topic", 1, variables={"en": {"unit": "cup"}})
    first = replace(first, individuals={"EN": "EN_TEA"})
    found = named(first, topic("Milk", "Topic", 2, individuals={"EN": stored}))
    assert found["Milk", "EN"] == "EN_MILK"
    assert len(set(found.values())) == len(found)


def test_a_culture_with_the_name_of_a_kind_makes_no_second_pool() -> None:
    found = named(topic("start", "Topic", 5, likeliness={"POOL": 0.5}))
    assert found == {("start", "POOL"): "POOL_START_t5"}


@given(
    st.lists(
        st.tuples(
            st.from_regex(r"\A[tT][eE]?[aA]?\Z"),
            st.dictionaries(st.sampled_from(["EN", "IT"]), st.sampled_from(["EN_TEA", "t", "X"])),
        ),
        unique_by=lambda row: row[0],
        max_size=8,
    )
)
def test_no_name_is_given_twice(rows: list[tuple[str, dict[str, str]]]) -> None:
    topics = [
        topic(key, "Topic", number, individuals=stored)
        for number, (key, stored) in enumerate(rows, start=1)
    ]
    found = named(*topics)
    every = [*found.values(), *(one.key for one in topics)]
    assert len(found) == 2 * len(topics)
    assert len(set(every)) == len(every)


def test_what_is_minted_is_a_local_name() -> None:
    every = [*individual_names(RICH.knowledge).values(), names.pattern_name(("q r", "c"))]
    every += [names.culture_name("EN"), names.pool_name("stay_or_go"), names.slot_name("a", "b")]
    every += [names.plan_name("a" * 60, on_knowledge=True), names.slot_name("a" * 60, "b" * 40)]
    assert all(names.LOCAL_NAME.fullmatch(name) for name in every)


@pytest.mark.parametrize("name", ["", "1Tea", "d'oro", "a b", "tè", "a#b", "x" * 151])
def test_other_names_are_not_local_names(name: str) -> None:
    assert not names.LOCAL_NAME.fullmatch(name)


def test_keys_come_back_from_names() -> None:
    assert names.intent_key(names.intent_name("playsong")) == "playsong"
    assert names.intent_key("INTENT_MUSIC") == "music"
    assert names.phrase_key(names.phrase_name("of_the")) == "of_the"
    assert names.list_key(names.list_name("volume_1")) == "volume_1"


def test_ids_come_back_as_numbers() -> None:
    assert names.number_of("t", names.topic_id(12)) == 12
    assert names.number_of("f", names.frame_id(7, "ja")) == 7
    assert names.number_of("i", names.intent_id(3)) == 3


@pytest.mark.parametrize("text", ["", "t", "t0", "t01", "topic-drink", "t5 ", "T5", "t99999999999"])
def test_ids_of_others_have_no_number(text: str) -> None:
    assert names.number_of("t", text) == 0


def test_a_pattern_has_a_name_for_its_sequence() -> None:
    assert names.pattern_name(("q", "c")) == names.pattern_name(("q", "c"))
    assert names.pattern_name(("q", "c")) != names.pattern_name(("c", "q"))
    assert names.pattern_sequence(("q r", "c")) == "q r | c"


def test_values_of_lists_never_share_a_name() -> None:
    found = names.value_names(RICH.library)
    assert found["volume", "louder"] == "VALUES_volume_1_v"
    assert found["volume", "quieter"] == "VALUES_volume_2"
    assert found["volume_1", "one"] == "VALUES_volume_1_1"
