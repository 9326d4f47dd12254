"""Which topic a sentence or the words of a wish mean."""

from random import Random

import msgspec
import pytest

from dialogue.engine.content import build_content
from dialogue.engine.find_topic import named_topic, topic_called, topic_of_sentence
from tests.engine.dialogue.talk import mrs_smith, turn_in
from tests.engine.dialogue.world import KNOWLEDGE, LIBRARY, NUMBERS, changed, without_topics


def meant(sentence: str, **fields: object) -> str:
    found = topic_of_sentence(turn_in(mrs_smith(**fields)), sentence)
    return found.key if found else ""


@pytest.mark.parametrize(
    ("language", "sentence", "topic"),
    [
        ("en", "I had some milk today", "Milk"),
        ("en", "there is green in the tea", "GreenTea"),
        ("it", "ho preso del caffè", "Coffee"),
        ("ja", "今日は牛乳を飲みました", "Milk"),
        ("en", "My teapot is new", ""),
        ("en", "", ""),
    ],
)
def test_keywords_in_a_sentence_say_what_it_is_about(language, sentence, topic):
    assert meant(sentence, language=language) == topic


def test_a_hard_subject_comes_before_others():
    assert meant("After the funerals we had a lot of milk") == "Funerals"


def test_one_word_of_a_hard_subject_gives_way_to_two_of_another():
    assert meant("After the funerals we had milk and green tea") == "GreenTea"


@pytest.mark.parametrize(
    ("sentence", "topic"),
    [
        ("At the churchyard it was cold, we had green tea", "Funerals"),
        ("At the churchyard it was warm, we had green tea", "GreenTea"),
        ("Grief, the cold churchyard, green tea", "Funerals"),
    ],
)
def test_a_hard_subject_named_by_two_words_comes_before_all_others(sentence, topic):
    content = build_content(
        changed("Funerals", keywords={"en": (("churchyard",), ("cold",))}), LIBRARY
    )
    found = topic_of_sentence(turn_in(mrs_smith(), content=content), sentence)
    assert found is not None
    assert found.key == topic


def test_two_keywords_beat_one_whatever_chance_says():
    for seed in range(20):
        turn = turn_in(mrs_smith())
        turn.chance = Random(seed)
        found = topic_of_sentence(turn, "there is green in the tea")
        assert found is not None
        assert found.key == "GreenTea"


def test_of_equal_matches_the_likelier_is_drawn_more_often():
    state = mrs_smith().with_likeliness(NUMBERS["Tea"], 1.0).with_likeliness(NUMBERS["Milk"], 0.0)
    knowledge = changed("Milk", keywords={"en": (("tea",), ("*",))})
    content = build_content(knowledge, LIBRARY)
    for seed in range(20):
        turn = turn_in(state, content=content)
        turn.chance = Random(seed)
        found = topic_of_sentence(turn, "some tea perhaps")
        assert found is not None
        assert found.key == "Tea"


def test_a_refused_topic_is_meant_where_nothing_else_matches():
    refused = mrs_smith().with_likeliness(NUMBERS["Milk"], 0.0)
    assert meant("some milk perhaps", levels=refused.levels) == "Milk"


def test_the_step_names_the_words_and_the_candidates():
    turn = turn_in(mrs_smith())
    topic_of_sentence(turn, "I had some Milk today")
    assert turn.steps[-1].text == "Milk → Milk"
    assert [one.topic for one in turn.steps[-1].candidates] == ["Milk"]


def test_a_name_said_alone_means_its_topic():
    turn = turn_in(mrs_smith())
    found = topic_called(turn, "The tea ceremony!")
    assert found is not None
    assert found.key == "TeaCeremony"


@pytest.mark.parametrize("liked", ["Milk", "Coffee"])
def test_of_two_topics_of_one_name_the_likelier_is_meant(liked):
    content = build_content(changed("Milk", names=KNOWLEDGE.topics[5].names), LIBRARY)
    likes_it = mrs_smith().with_likeliness(NUMBERS[liked], 1.0)
    found = topic_called(turn_in(likes_it, content=content), "coffee")
    assert found is not None
    assert found.key == liked


@pytest.mark.parametrize("words", ["GreenTea", "green_tea", " green tea ", "some Green tea"])
def test_an_action_names_a_topic_by_its_concept_or_its_words(words):
    found = named_topic(turn_in(mrs_smith()), words)
    assert found is not None
    assert found.key == "GreenTea"


@pytest.mark.parametrize("words", ["", " _ ", "submarines"])
def test_an_action_that_names_nothing_known_means_no_topic(words):
    assert named_topic(turn_in(mrs_smith()), words) is None


def test_a_very_long_sentence_is_read_from_its_beginning():
    assert meant("well " * 1000 + "milk") == ""


def test_keywords_of_a_topic_that_is_not_in_the_tree_mean_nothing():
    lost = msgspec.structs.replace(KNOWLEDGE.topics[4], is_a="Nowhere")
    topics = tuple(lost if one.key == "Milk" else one for one in KNOWLEDGE.topics)
    content = build_content(msgspec.structs.replace(KNOWLEDGE, topics=topics), LIBRARY)
    turn = turn_in(mrs_smith(), content=content)
    assert topic_of_sentence(turn, "some milk") is None
    assert topic_of_sentence(turn_in(mrs_smith(), content=without_topics("Milk")), "milk") is None


def test_the_same_words_mean_the_same_topic_in_one_turn():
    turn = turn_in(mrs_smith())
    first = named_topic(turn, "green tea")
    searches = len(turn.steps)
    assert named_topic(turn, "green_tea") is first
    assert len(turn.steps) == searches
