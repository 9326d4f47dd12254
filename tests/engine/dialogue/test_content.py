"""Content: one immutable value for each publication; `^` stands for the parent's keywords."""

import msgspec

from dialogue.engine.concepts import ROOT, Knowledge, Topic, usual_likeliness
from dialogue.engine.content import build_content, keyword_rows
from plans.engine.intents import Library
from tests.engine.dialogue.world import KNOWLEDGE, LIBRARY, NUMBERS, WORLD

TEA = Topic(key="Tea", is_a=ROOT, number=1, keywords={"en": (("tea",), ("*",))})
GREEN = Topic(key="GreenTea", is_a="Tea", number=2, keywords={"en": (("green",), ("^", "cup"))})


def test_content_knows_its_cultures_and_where_it_came_from():
    assert WORLD.cultures == ("EN", "IT", "JP")
    assert (WORLD.number, WORLD.knowledge, WORLD.library) == (1, KNOWLEDGE, LIBRARY)


def test_keywords_can_be_found_in_each_language():
    for code, sentence in (("en", "some tea"), ("it", "il tè"), ("ja", "お茶")):
        assert WORLD.keywords[code].search(sentence)[0].topic == NUMBERS["Tea"]


def test_the_sign_for_the_parents_words_is_replaced():
    rows = keyword_rows(Knowledge(topics=(TEA, GREEN)), "en")
    assert rows[1].second == ("cup", "tea")


def test_without_a_parent_the_sign_stands_for_nothing():
    rows = keyword_rows(Knowledge(topics=(GREEN,)), "en")
    assert rows[0].second == ("cup",)
    silent = msgspec.structs.replace(TEA, keywords={"it": (("tè",), ("*",))})
    assert keyword_rows(Knowledge(topics=(silent, GREEN)), "en")[0].second == ("cup",)


def test_a_topic_without_keywords_in_a_language_has_no_row():
    assert keyword_rows(Knowledge(topics=(TEA, GREEN)), "it") == []


def test_an_empty_knowledge_base_can_be_built():
    assert build_content(Knowledge(), Library()).tree.branches == ()


def test_the_usual_likeliness_is_higher_at_home():
    assert usual_likeliness("JP", ("EN", "JP")) == {"EN": 0.3, "JP": 0.7}
    assert usual_likeliness("", ("EN",)) == {"EN": 0.5}
