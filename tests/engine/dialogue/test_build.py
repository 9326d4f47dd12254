"""The Dialogue Tree: inheritance of sentences, patterns, variables and gentleness."""

import pytest

from dialogue.engine.build import build_tree
from dialogue.engine.concepts import ROOT, Frame, Knowledge, Topic
from dialogue.engine.sentence_types import SENTENCE_TYPES
from languages.language import FormError
from tests.engine.dialogue.talk import node
from tests.engine.dialogue.world import NUMBERS, TOPICS, WORLD


def said(topic: Topic, *others: Topic) -> set[str]:
    """Return the keys of what a topic can say."""
    tree = build_tree(Knowledge(topics=(topic, *others)))
    lines = tree.nodes[topic.number].lines
    return {line.key for some in lines.values() for line in some}


def line(key: str, scope: str = "") -> Frame:
    return Frame(key=key, type="c", texts={"en": "Tea!"}, scope=scope)


def test_subclasses_become_children_and_has_topic_becomes_a_link():
    tea = node("Tea")
    assert tea.children == (NUMBERS["GreenTea"],)
    assert tea.links == (NUMBERS["Milk"], NUMBERS["TeaCeremony"])
    assert tea.ancestors == (NUMBERS["Drinks"], NUMBERS["FoodAndDrink"])
    assert tea.parent == NUMBERS["Drinks"]
    assert tea.branch == NUMBERS["FoodAndDrink"]


def test_branches_lie_directly_below_the_root():
    branches = [WORLD.tree.nodes[number].key for number in WORLD.tree.branches]
    assert branches == ["FoodAndDrink", "Music", "Traditions", "Life"]
    assert node("Music").parent == 0
    assert node("Music").branch == NUMBERS["Music"]


def test_a_topic_says_its_own_sentences_and_those_of_its_classes():
    keys = {line.key for line in node("GreenTea").lines["c"]}
    assert {"FoodAndDrink.c1", "Tea.c1"} <= keys
    assert "Music.c1" not in keys


def test_every_line_can_be_found_by_its_number():
    assert WORLD.tree.lines[node("Tea").lines["q"][0].number].key == "FoodAndDrink.q1"


def test_a_stopped_type_is_not_inherited():
    assert "q" in node("Life").lines
    assert "q" not in node("Grief").lines
    assert set(SENTENCE_TYPES) > set(node("Grief").lines)


def test_a_topic_can_borrow_from_another_class_but_does_not_hand_it_down():
    tea = Topic(key="Tea", is_a=ROOT, number=1, also=("Herb", "Gone"))
    herb = Topic(key="Herb", is_a=ROOT, number=2, frames=(line("Herb.c1"), line("Herb.c2", "self")))
    green = Topic(key="GreenTea", is_a="Tea", number=3)
    assert said(tea, herb, green) == {"Herb.c1"}
    assert said(green, herb, tea) == set()


def test_the_scope_keeps_a_sentence_at_or_below_its_topic():
    frames = (line("Tea.c1", "self"), line("Tea.c2", "below"), line("Tea.c3"))
    tea = Topic(key="Tea", is_a=ROOT, number=1, frames=frames)
    green = Topic(key="GreenTea", is_a="Tea", number=2)
    assert said(tea) == {"Tea.c1", "Tea.c3"}
    assert said(green, tea) == {"Tea.c2", "Tea.c3"}


def test_patterns_come_from_the_nearest_class_that_has_some():
    assert [letter for letter, _ in node("Piano").patterns[0]] == ["q", "r", "w", "c", "g"]
    assert [letter for letter, _ in node("Festivals").patterns[0]] == ["q", "r", "w", "c"]
    assert [letter for letter, _ in node("Funerals").patterns[0]] == ["c", "w", "c"]


def test_what_lies_below_a_gentle_class_is_gentle():
    assert node("Funerals").gentle
    assert not node("Gardening").gentle


def test_a_topic_overrides_single_variables_of_its_class():
    above = {"en": {"unit": "cup", "when": "at five"}}
    tea = Topic(key="Tea", is_a=ROOT, number=1, variables=above)
    green = Topic(key="GreenTea", is_a="Tea", number=2, variables={"en": {"unit": "bowl"}})
    variables = build_tree(Knowledge(topics=(tea, green))).nodes[2].variables
    assert variables["en"] == {"unit": "bowl", "when": "at five"}


def test_links_to_unknown_topics_and_unknown_languages_are_left_out():
    tea = Topic(key="Tea", is_a=ROOT, number=1, see=("Gone",), names={"fr": {"name": "thé"}})
    tea_node = build_tree(Knowledge(topics=(tea,))).nodes[1]
    assert tea_node.links == ()
    assert tea_node.names == {}


def test_a_wrong_name_is_refused():
    tea = Topic(key="Tea", is_a=ROOT, number=1, names={"it": {"name": "tè"}})
    with pytest.raises(FormError):
        build_tree(Knowledge(topics=(tea,)))


def test_a_tree_knows_neighbours():
    tree = WORLD.tree
    assert set(tree.siblings(node("Tea"))) == {NUMBERS["Milk"], NUMBERS["Coffee"]}
    assert NUMBERS["Music"] in tree.siblings(node("Life"))
    assert tree.is_same_or_below(NUMBERS["GreenTea"], NUMBERS["Drinks"])
    assert not tree.is_same_or_below(NUMBERS["Drinks"], NUMBERS["GreenTea"])
    assert not tree.is_same_or_below(999, NUMBERS["Tea"])
    assert len(tree.nodes) == len(TOPICS)
