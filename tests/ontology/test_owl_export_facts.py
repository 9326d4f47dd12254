"""What rdflib and py-horned-owl read in an export is what the records say, and nothing else."""

from collections import Counter

import pytest
from rdflib import Graph

from dialogue.engine.tree_order import in_tree_order
from ontology_io.files.folder import read_folder
from ontology_io.owl.names import individual_names
from ontology_io.records import KnowledgeBase
from ontology_io.store import read_base
from tests.ontology.owl_bases import LAST, RICH
from tests.ontology.owl_export_expected import expected_class, expected_individual, expected_rows
from tests.ontology.owl_readers import (
    IRI,
    Row,
    about,
    exported,
    instances,
    read_graph,
    read_horned,
    rows_of_graph,
    rows_of_horned,
)
from tests.site_fixtures import CONTENT

SENTENCES = ("hasQuestion", "hasPositive", "hasNegative", "hasTransition", "hasInitiative")


@pytest.fixture(scope="module")
def shipped_base() -> KnowledgeBase:
    return read_folder(CONTENT).base


@pytest.fixture(scope="module")
def shipped_export(shipped_base: KnowledgeBase) -> bytes:
    return exported(shipped_base)


@pytest.fixture(scope="module")
def rich() -> Graph:
    return read_graph(exported(RICH, highest=LAST))


def told_once(rows: Counter[Row]) -> Counter[Row]:
    """Return the rows of texts that stand only once: py-horned-owl takes equal axioms for one."""
    times = Counter(row[:4] for row in rows.elements())
    return Counter({row: count for row, count in rows.items() if times[row[:4]] == 1})


def compare_topics(graph: Graph, base: KnowledgeBase) -> None:
    names = individual_names(base.knowledge)
    places: dict[str, int] = {}
    for topic in in_tree_order(base.knowledge.topics):
        places[topic.is_a] = places.get(topic.is_a, 0) + 1
        assert about(graph, topic.key) == expected_class(topic, places[topic.is_a], base.knowledge)
        for culture in topic.likeliness:
            said = about(graph, names[topic.key, culture])
            facts = {pair for pair in said if not pair[0].startswith(SENTENCES)}
            assert facts == expected_individual(topic, culture, names)


def test_rdflib_reads_every_sentence_with_its_annotations(rich: Graph) -> None:
    assert rows_of_graph(rich) == expected_rows(RICH, individual_names(RICH.knowledge))


def test_horned_owl_reads_every_sentence_with_its_annotations() -> None:
    found = rows_of_horned(read_horned(exported(RICH)))
    expected = told_once(expected_rows(RICH, individual_names(RICH.knowledge)))
    assert len(expected) > 30
    assert expected <= found


def test_every_topic_and_individual_says_what_the_records_say(rich: Graph) -> None:
    compare_topics(rich, RICH)


def test_the_small_draft_says_what_its_records_say(small_draft: object) -> None:
    base = read_base()
    data = exported(base)
    names = individual_names(base.knowledge)
    compare_topics(read_graph(data), base)
    assert rows_of_graph(read_graph(data)) == expected_rows(base, names)
    assert told_once(expected_rows(base, names)) <= rows_of_horned(read_horned(data))


def test_horned_owl_reads_the_shipped_content_whole(
    shipped_base: KnowledgeBase, shipped_export: bytes
) -> None:
    ontology = read_horned(shipped_export)
    names = individual_names(shipped_base.knowledge)
    assert told_once(expected_rows(shipped_base, names)) <= rows_of_horned(ontology)
    topics = {topic.key for topic in shipped_base.knowledge.topics}
    assert {str(iri).rpartition("#")[2] for iri in ontology.get_classes()} >= topics


def test_rdflib_reads_the_shipped_content_whole(
    shipped_base: KnowledgeBase, shipped_export: bytes
) -> None:
    graph = read_graph(shipped_export)
    names = individual_names(shipped_base.knowledge)
    assert rows_of_graph(graph) == expected_rows(shipped_base, names)
    compare_topics(graph, shipped_base)
    assert len(instances(graph, "Intent")) == len(shipped_base.library.intents)
    assert len(instances(graph, "Pool")) == len(shipped_base.knowledge.pools)


def test_the_header_tells_version_format_and_numbers(rich: Graph) -> None:
    assert about(rich, "", IRI) == {
        ("type", "Ontology"),
        ("label", "CAIR knowledge base@en"),
        ("versionInfo", "draft"),
        ("formatVersion", "1"),
        ("highestNumbers", "topic=12 frame=50 intent=4"),
    }


def test_cultures_and_languages_are_individuals(rich: Graph) -> None:
    assert instances(rich, "Language") == {"LANGUAGE_EN", "LANGUAGE_IT", "LANGUAGE_JA"}
    assert about(rich, "CULTURE_EN") == {
        ("type", "NamedIndividual"),
        ("type", "Culture"),
        ("hasCode", "EN"),
        ("hasDefaultLanguage", "LANGUAGE_EN"),
        ("label", "English@en"),
        ("label", "inglese@it"),
        ("label", "イギリス@ja"),
        ("order", "2"),
    }


def test_an_intent_keeps_its_slots_plans_and_words(rich: Graph) -> None:
    said = about(rich, "INTENT_playsong")
    assert {pair for pair in said if pair[0] not in ("hasTrigger", "hasTest")} == {
        ("type", "NamedIndividual"),
        ("type", "Intent"),
        ("id", "i4"),
        ("order", "1"),
        ("hasPriority", "60"),
        ("hasFamily", "media"),
        ("hasAbility", "play a song@en"),
        ("comment", "The song of Mrs Smith."),
        ("hasPlanSentence", "Here it is.@en"),
        ("hasSlot", "INTENT_playsong_SLOT_title"),
        ("hasSlot", "INTENT_playsong_SLOT_level"),
        ("hasPlan", "INTENT_playsong_PLAN"),
        ("hasKBPlan", "INTENT_playsong_KBPLAN"),
    }
    assert about(rich, "INTENT_playsong_SLOT_title") == {
        ("type", "NamedIndividual"),
        ("type", "Slot"),
        ("hasSlotName", "title"),
        ("hasSlotKind", "text"),
        ("isRequired", "true"),
        ("hasSlotQuestion", "Which song?@en"),
        ("hasSlotQuestion", "Quale?@it"),
        ("hasOrder", "1"),
    }


def test_plans_are_ordered_actions_with_ordered_parameters(rich: Graph) -> None:
    actions = {pair[1] for pair in about(rich, "INTENT_playsong_PLAN") if pair[0] == "hasAction"}
    assert actions == {"INTENT_playsong_PLAN_A1", "INTENT_playsong_PLAN_A2"}
    assert about(rich, "INTENT_playsong_PLAN_A1") == {
        ("type", "NamedIndividual"),
        ("type", "Action"),
        ("hasActionName", "playsong"),
        ("hasOrder", "1"),
        ("hasParameter", "INTENT_playsong_PLAN_A1_P1"),
        ("hasParameter", "INTENT_playsong_PLAN_A1_P2"),
    }
    assert about(rich, "INTENT_playsong_PLAN_A1_P2") == {
        ("type", "NamedIndividual"),
        ("type", "Parameter"),
        ("hasParameterName", "to"),
        ("hasParameterValue", "all"),
        ("hasOrder", "2"),
    }
    assert ("type", "KBPlan") in about(rich, "INTENT_playsong_KBPLAN")


def test_an_intent_without_anything_is_still_there(rich: Graph) -> None:
    assert about(rich, "INTENT_empty") == {
        ("type", "NamedIndividual"),
        ("type", "Intent"),
        ("id", "i2"),
        ("order", "2"),
        ("hasPriority", "50"),
    }


def test_phrases_lists_and_empty_pools_are_written(rich: Graph) -> None:
    phrase = about(rich, "PHRASE_kindly")
    assert {("hasPattern", "please|kindly@en"), ("hasPattern", "どうか@ja")} <= phrase
    values = {pair[1] for pair in about(rich, "VALUES_volume") if pair[0] == "hasValue"}
    assert values == {"VALUES_volume_1_v", "VALUES_volume_2", "VALUES_volume_3"}
    assert ("hasCode", "louder") in about(rich, "VALUES_volume_1_v")
    assert ("type", "ValueList") in about(rich, "VALUES_volume_1")
    assert {("hasCode", "stay_or_go"), ("order", "2")} <= about(rich, "POOL_STAY_OR_GO")


def test_a_pattern_is_one_individual_that_the_class_uses(rich: Graph) -> None:
    (name,) = instances(rich, "DialoguePattern")
    assert ("hasSequence", "q r w c [g] | c q r") in about(rich, name)
    used = rich.query(
        "SELECT ?c WHERE { ?c rdfs:subClassOf [ owl:onProperty <urn:cair:vocab#usesPattern> ;"
        f" owl:hasValue <urn:cair:kb#{name}> ] }}"
    )
    assert [str(row[0]) for row in used] == ["urn:cair:kb#Drink"]
