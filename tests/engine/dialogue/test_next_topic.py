"""Where the talk goes when a topic is completed: child, sibling, link, far."""

from random import Random

from dialogue.engine.content import build_content
from dialogue.engine.next_topic import (
    MOST_SIBLINGS,
    another_branch,
    far_topic,
    next_topic,
)
from dialogue.engine.state import DialogueState
from tests.engine.dialogue.talk import mrs_smith, node, turn_in
from tests.engine.dialogue.world import LIBRARY, NUMBERS, changed, without_topics


def steps(topic: str, **fields: object) -> set[tuple[str, str]]:
    """Return all topics that follow one, with the way there, over many draws."""
    found = set()
    for seed in range(60):
        turn = turn_in(mrs_smith(topic, **fields))
        turn.chance = Random(seed)
        step = next_topic(turn, turn.node)
        if step:
            found.add((step.way, step.node.key))
    return found


def test_a_child_comes_first():
    assert steps("Tea") == {("child", "GreenTea")}


def test_without_a_child_a_sibling_or_a_linked_topic_follows():
    topics = (NUMBERS["GreenTea"], NUMBERS["Tea"])
    found = steps("Tea", topics=topics)
    assert {way for way, _ in found} == {"sibling", "link"}
    assert {key for _, key in found} == {"Milk", "Coffee", "TeaCeremony"}


def test_after_a_no_the_children_are_left_alone():
    dislikes = mrs_smith("Tea").with_likeliness(NUMBERS["Tea"], 0.1)
    assert {way for way, _ in steps("Tea", levels=dislikes.levels)} == {"sibling", "link"}


def test_after_three_siblings_a_link_or_another_branch_follows():
    topics = (NUMBERS["GreenTea"], NUMBERS["Tea"])
    found = steps("Tea", topics=topics, siblings=MOST_SIBLINGS)
    assert {way for way, _ in found} == {"link"}
    assert {way for way, _ in steps("Coffee", siblings=MOST_SIBLINGS)} == {"far"}


def test_without_any_neighbour_a_topic_of_another_branch_follows():
    found = steps("GreenTea")
    assert {way for way, _ in found} == {"far"}
    assert {key for _, key in found} == {
        "Piano",
        "Singing",
        "TeaCeremony",
        "Festivals",
        "Gardening",
    }


def test_a_talk_without_a_topic_begins_with_a_concrete_one():
    turn = turn_in(mrs_smith())
    step = next_topic(turn, None)
    assert step is not None
    assert (step.way, step.node.key) == ("far", "GreenTea")


def test_a_topic_just_talked_about_does_not_come_again():
    topics = tuple(NUMBERS[key] for key in ("GreenTea", "Milk", "TeaCeremony", "Tea"))
    assert {key for _, key in steps("Tea", topics=topics)} == {"Coffee"}


def coffees(state: DialogueState) -> int:
    """Return how often coffee follows in 400 draws."""
    keys = []
    for seed in range(400):
        turn = turn_in(state)
        turn.chance = Random(seed)
        step = next_topic(turn, turn.node)
        keys.append(step.node.key if step else "")
    return keys.count("Coffee")


def test_a_topic_said_something_about_is_less_likely_to_come_again():
    covered = mrs_smith("Milk").with_used(NUMBERS["Coffee"], 0)
    assert 0 < coffees(covered) < coffees(mrs_smith("Milk")) / 2


def test_the_explanation_names_likeliness_not_weights():
    turn = turn_in(mrs_smith("Milk"), chance=0.9)
    next_topic(turn, turn.node)
    named = {one.topic: one.likeliness for step in turn.steps for one in step.candidates}
    assert named["Coffee"] == turn.likeliness(node("Coffee"))


def test_a_topic_liked_in_the_culture_is_likelier_to_come():
    assert coffees(mrs_smith("Milk", culture="IT")) > coffees(mrs_smith("Milk"))


def test_gentle_topics_are_never_proposed():
    found = steps("Gardening") | steps("Grief") | steps("Festivals")
    assert not {"Grief", "Funerals", "OnYourMind"} & {key for _, key in found}


def test_a_refused_topic_is_not_proposed():
    refused = mrs_smith("Milk").with_likeliness(NUMBERS["Coffee"], 0.0)
    found = steps("Milk", levels=refused.levels)
    assert "Coffee" not in {key for _, key in found}


def test_a_topic_nearly_unknown_in_the_culture_is_not_proposed():
    content = build_content(changed("Coffee", likeliness={"EN": 0.04}), LIBRARY)
    turn = turn_in(mrs_smith("Milk", avoided=((NUMBERS["Tea"], 99),)), content=content, chance=0.9)
    step = next_topic(turn, turn.node)
    assert step is not None
    assert (step.way, step.node.key) != ("sibling", "Coffee")


def test_an_avoided_branch_stays_out_until_its_turn_has_come():
    away = ((NUMBERS["Music"], 25),)
    assert not {"Piano", "Singing"} & {key for _, key in steps("GreenTea", avoided=away, turn=25)}
    assert {"Piano", "Singing"} & {key for _, key in steps("GreenTea", avoided=away, turn=26)}


def test_two_noes_lead_out_of_the_branch():
    for seed in range(40):
        turn = turn_in(mrs_smith("Tea"))
        turn.chance = Random(seed)
        step = another_branch(turn, node("Tea"))
        assert step is not None
        assert step.node.branch != node("Tea").branch


def test_a_link_out_of_the_branch_is_preferred_after_two_noes():
    turn = turn_in(mrs_smith("Tea"))
    step = another_branch(turn, node("Tea"))
    assert step is not None
    assert (step.way, step.node.key) == ("link", "TeaCeremony")


def test_a_far_topic_lies_where_the_talk_has_not_been():
    topics = tuple(NUMBERS[key] for key in ("Piano", "Festivals", "Tea"))
    turn = turn_in(mrs_smith("Tea", topics=topics))
    step = far_topic(turn, node("Tea"))
    assert step is not None
    assert step.node.key == "Gardening"


def test_where_every_branch_was_visited_another_one_than_this_follows():
    topics = tuple(NUMBERS[key] for key in ("Piano", "Festivals", "Gardening", "Tea"))
    turn = turn_in(mrs_smith("Tea", topics=topics))
    step = far_topic(turn, node("Tea"))
    assert step is not None
    assert step.node.key == "Singing"


def test_with_one_branch_left_the_talk_stays_in_it():
    away = tuple((NUMBERS[key], 99) for key in ("Music", "Traditions", "Life"))
    assert steps("GreenTea", avoided=away) == {("far", "Milk"), ("far", "Coffee"), ("far", "Tea")}


def test_where_everything_is_avoided_there_is_no_next_topic():
    away = tuple((NUMBERS[key], 99) for key in ("FoodAndDrink", "Music", "Traditions", "Life"))
    assert steps("Tea", avoided=away) == set()


def test_links_and_topics_that_are_gone_are_passed_over():
    content = without_topics("TeaCeremony")
    turn = turn_in(mrs_smith("Tea", topics=(999, NUMBERS["Tea"])), content=content)
    step = another_branch(turn, content.tree.by_key["Tea"])
    assert step is not None
    assert step.way == "far"


def test_the_agent_does_not_bring_up_somebodys_husband():
    assert "Husband" not in {key for _, key in steps("GreenTea")}
