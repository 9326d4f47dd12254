"""What the person wants wins: the agent stays with them."""

import pytest

from dialogue.engine.wishes import LONGEST_WISH, is_personal, listen, stay_with
from tests.engine.dialogue.talk import mrs_smith, turn_in
from tests.engine.dialogue.world import NUMBERS, with_pool, without_topics


@pytest.mark.parametrize(
    ("language", "words", "personal"),
    [
        ("en", "my wife Margaret", True),
        ("en", "tea", False),
        ("it", "mia moglie", True),
        ("ja", "妻", True),
        ("ja", "お茶", False),
    ],
)
def test_someones_own_is_personal(language, words, personal):
    assert is_personal(turn_in(mrs_smith(language=language)), words) is personal


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


def test_what_they_dislike_is_followed_by_a_remark_and_a_question():
    turn = turn_in(mrs_smith("Tea"))
    assert stay_with(turn, "submarines", "n")
    assert turn.parts == ["Not submarines, I hear.", "I am all ears."]
    assert turn.state.ordering == "w"


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
    assert stay_with(turn_in(mrs_smith(), content=content), "submarines", "n")
