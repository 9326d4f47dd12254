"""The one order of topics: branch after branch, classes before leaves."""

from dialogue.engine.concepts import ROOT, Topic
from dialogue.engine.tree_order import branches, in_tree_order
from tests.engine.dialogue.world import TOPICS


def topics(*pairs: str) -> tuple[Topic, ...]:
    """Return topics from "Tea < Drinks"."""
    return tuple(
        Topic(key=key, is_a=above) for key, _, above in (pair.partition(" < ") for pair in pairs)
    )


def order(*pairs: str) -> list[str]:
    return [topic.key for topic in in_tree_order(topics(*pairs))]


def test_classes_come_before_leaves_and_neighbours_keep_their_order():
    assert order("Milk < Drinks", "Drinks < Food", "Food < Topic", "Coffee < Drinks") == [
        "Drinks",
        "Food",
        "Milk",
        "Coffee",
    ]


def test_branches_do_not_mix():
    assert order("Tea < Food", "Piano < Music", "Food < Topic", "Music < Topic") == [
        "Food",
        "Tea",
        "Music",
        "Piano",
    ]


def test_each_topic_has_its_branch():
    found = branches(TOPICS)
    assert found["GreenTea"] == "FoodAndDrink"
    assert found["Life"] == "Life"


def test_an_unknown_parent_counts_as_a_branch():
    assert branches(topics("Tea < Nowhere")) == {"Tea": "Nowhere"}


def test_topics_in_a_circle_have_an_end():
    found = branches(topics("Tea < Milk", "Milk < Tea", f"Music < {ROOT}"))
    assert set(found) == {"Tea", "Milk", "Music"}
    assert found["Music"] == "Music"
