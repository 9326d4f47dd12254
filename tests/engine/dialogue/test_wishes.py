"""What the person wants wins: the agent stays with them."""

import pytest

from dialogue.engine.wishes import (
    LONGEST_WISH,
    is_about_people,
    is_personal,
    listen,
    stay_with,
)
from tests.engine.dialogue.talk import mrs_smith, node, turn_in
from tests.engine.dialogue.world import NUMBERS, with_pool, without_topics


@pytest.mark.parametrize(
    ("language", "words", "topic", "personal"),
    [
        ("en", "my wife Margaret", None, True),
        ("en", "submarines", None, False),
        ("en", "my husband", "Husband", True),
        ("en", "my people", "People", True),
        ("en", "husbands", "Husband", False),
        ("en", "my green tea", "GreenTea", False),
        ("en", "tea", "Tea", False),
        ("it", "mia moglie", None, True),
        ("it", "mio marito", "Husband", True),
        ("it", "il mio latte", "Milk", False),
        ("ja", "妻", None, True),
        ("ja", "夫", "Husband", True),
        ("ja", "私の牛乳", "Milk", False),
        ("ja", "お茶", "Tea", False),
    ],
)
def test_people_of_theirs_and_unknown_things_of_theirs_are_personal(
    language, words, topic, personal
):
    turn = turn_in(mrs_smith(language=language))
    assert is_personal(turn, words, node(topic) if topic else None) is personal


@pytest.mark.parametrize(
    ("topic", "people"),
    [("People", True), ("Husband", True), ("Life", False), ("Grief", False), ("Tea", False)],
)
def test_the_group_of_people_and_what_is_below_it_is_about_people(topic, people):
    assert is_about_people(turn_in(mrs_smith()), node(topic)) is people


def test_in_a_world_without_people_nothing_known_is_personal():
    turn = turn_in(mrs_smith(), content=without_topics("People", "Husband"))
    assert not is_about_people(turn, node("Husband"))
    assert not is_personal(turn, "my milk", node("Milk"))
    assert is_personal(turn, "my wife Margaret", None)


@pytest.mark.parametrize(
    ("start", "sentence"),
    [
        ("q", "Tell me about your wife Margaret."),
        ("p", "You are fond of your wife Margaret."),
        ("", "Tell me about your wife Margaret."),
    ],
)
def test_the_person_hears_their_own_words(start, sentence):
    turn = turn_in(mrs_smith("Tea", noes=2, siblings=2))
    assert stay_with(turn, " my wife  Margaret ", start)
    assert turn.parts == [sentence]
    assert turn.state.topic == NUMBERS["OnYourMind"]
    assert turn.state.ordering == "cwc"
    assert (turn.state.noes, turn.state.siblings) == (0, 0)


@pytest.mark.parametrize(
    ("start", "sentence"),
    [
        ("q", "Tell me about submarines."),
        ("p", "You are fond of submarines."),
        ("", "Tell me about submarines."),
    ],
)
def test_an_unknown_thing_is_asked_about_with_one_more_question(start, sentence):
    turn = turn_in(mrs_smith("Tea", noes=2, siblings=2))
    assert stay_with(turn, "submarines", start)
    assert turn.parts == [sentence]
    assert turn.state.topic == NUMBERS["OnYourMind"]
    assert turn.state.ordering == "w"
    assert (turn.state.noes, turn.state.siblings) == (0, 0)


def test_after_an_unknown_thing_they_dislike_the_talk_carries_on():
    turn = turn_in(mrs_smith("Tea", ordering="wc"))
    assert stay_with(turn, "submarines", "n")
    assert turn.parts == ["Not submarines, I hear.", "What is special about tea?"]
    assert (turn.state.topic, turn.state.ordering) == (NUMBERS["Tea"], "c")


def test_after_an_unknown_thing_they_dislike_a_completed_topic_leads_to_the_next():
    turn = turn_in(mrs_smith("Tea"))
    assert stay_with(turn, "submarines", "n")
    assert turn.parts == [
        "Not submarines, I hear.",
        "Tea brings me to green tea.",
        "Do you like green tea?",
    ]
    assert turn.state.topic == NUMBERS["GreenTea"]


def test_who_dislikes_someone_of_theirs_is_listened_to():
    turn = turn_in(mrs_smith("Tea", ordering="wc"))
    assert stay_with(turn, "my neighbour", "n")
    assert turn.parts == ["Not your neighbour, I hear."]
    assert (turn.state.topic, turn.state.ordering) == (NUMBERS["OnYourMind"], "cwc")


@pytest.mark.parametrize("words", ["", "   ", "x" * (LONGEST_WISH + 1), "a $price {tag"])
def test_words_that_cannot_be_said_back_are_left_alone(words):
    turn = turn_in(mrs_smith("Tea"))
    assert not stay_with(turn, words, "q")
    assert turn.parts == []


def test_without_its_pool_a_wish_is_an_ordinary_sentence():
    turn = turn_in(mrs_smith("Tea"), content=with_pool("wish"))
    assert not stay_with(turn, "submarines", "q")


def test_without_a_topic_for_listening_the_talk_stays_where_it_is():
    content = without_topics("OnYourMind")
    turn = turn_in(mrs_smith("Tea", ordering="w"), content=content)
    listen(turn)
    assert (turn.state.topic, turn.state.ordering) == (NUMBERS["Tea"], "w")
    assert stay_with(turn_in(mrs_smith(), content=content), "my neighbour", "n")
