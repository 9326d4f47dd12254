"""Topics stand branch by branch, classes before leaves, else as experts put them."""

from dialogue.engine.concepts import Topic
from dialogue.engine.tree_order import branches, in_tree_order


def topics(**parents: str) -> tuple[Topic, ...]:
    return tuple(Topic(key=key, is_a=parent) for key, parent in parents.items())


def test_branches_come_by_name_and_classes_before_leaves() -> None:
    found = topics(Milk="Drink", Drink="Topic", GreenTea="Tea", Animal="Topic", Tea="Drink")
    in_order = [topic.key for topic in in_tree_order(found)]
    assert in_order == ["Animal", "Drink", "Tea", "Milk", "GreenTea"]


def test_neighbours_keep_their_order() -> None:
    found = topics(Drink="Topic", Tea="Drink", Coffee="Drink", Beer="Drink")
    assert in_tree_order(found) == found


def test_every_topic_of_a_circle_has_a_branch() -> None:
    circle = topics(Rose="Tulip", Tulip="Rose", Elm="Tulip")
    assert branches(circle) == {"Rose": "Rose", "Tulip": "Rose", "Elm": "Rose"}
    assert branches(topics(Rose="Rose")) == {"Rose": "Rose"}


def test_a_topic_below_an_unknown_one_belongs_to_that() -> None:
    assert branches(topics(Rose="Flower")) == {"Rose": "Flower"}
