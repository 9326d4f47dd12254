"""Topics by name: said alone, a name means its topic."""

import msgspec
import pytest

from dialogue.engine.build import build_tree
from dialogue.engine.concepts import Knowledge, Topic
from dialogue.engine.names import name_index, spelled
from languages.known import LANGUAGES
from tests.engine.dialogue.world import NUMBERS, TOPICS, WORLD

ENGLISH = LANGUAGES["en"]


@pytest.mark.parametrize(
    ("code", "words"),
    [("en", "The  PIANO!"), ("it", "il pianoforte"), ("it", "pianoforte"), ("ja", "ピアノ。")],
)
def test_a_name_is_known_however_it_is_written(code, words):
    key = spelled(words, LANGUAGES[code])
    assert WORLD.names[code][key] == (NUMBERS["Piano"],)


def test_a_form_with_a_preposition_is_no_name():
    assert "del pianoforte" not in WORLD.names["it"]


def test_of_two_topics_of_one_name_the_more_special_comes_first():
    names = {"en": {"name": "food and drink"}}
    green = msgspec.structs.replace(
        next(topic for topic in TOPICS if topic.key == "GreenTea"), names=names
    )
    topics = tuple(green if topic.key == "GreenTea" else topic for topic in TOPICS)
    index = name_index(build_tree(Knowledge(topics=topics)), ENGLISH)
    assert index["food and drink"] == (NUMBERS["GreenTea"], NUMBERS["FoodAndDrink"])


def test_a_topic_without_a_name_or_with_signs_only_is_in_no_index():
    topics = (
        Topic(key="Tea", is_a="Topic", number=1, names={"it": {"name": "tè", "g": "m"}}),
        Topic(key="Signs", is_a="Topic", number=2, names={"en": {"name": "!!"}}),
    )
    index = name_index(build_tree(Knowledge(topics=topics)), ENGLISH)
    # The article of the empty name is a word of its own.
    assert "" not in index
    assert 1 not in {number for numbers in index.values() for number in numbers}
