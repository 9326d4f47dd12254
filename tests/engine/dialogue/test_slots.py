"""Slots: unique among all that one topic can say, so that "said already" is true."""

from itertools import pairwise

import msgspec
from hypothesis import given
from hypothesis import strategies as some

from dialogue.engine.build import build_tree
from dialogue.engine.concepts import ROOT, Frame, Knowledge, Topic
from dialogue.engine.slots import missing_slots
from dialogue.engine.state import MAX_SLOT
from tests.engine.dialogue.world import KNOWLEDGE, WORLD


def frames(first: int, count: int) -> tuple[Frame, ...]:
    return tuple(
        Frame(key=f"f{number}", type="c", texts={"en": "x"}, number=number)
        for number in range(first, first + count)
    )


def chain(*counts: int, also: tuple[str, ...] = ()) -> Knowledge:
    """Return Drink > HotDrink > Tea …, each with so many frames; the last one borrows."""
    keys = [ROOT, *(f"T{number}" for number in range(1, len(counts) + 1))]
    topics = [
        Topic(key=key, is_a=above, number=place, frames=frames(1000 * place, count))
        for place, ((above, key), count) in enumerate(zip(pairwise(keys), counts, strict=True), 1)
    ]
    topics[-1] = msgspec.structs.replace(topics[-1], also=also)
    return Knowledge(topics=tuple(topics))


def test_no_two_sentences_of_a_topic_share_a_slot():
    for node in WORLD.tree.nodes.values():
        slots = [line.slot for lines in node.lines.values() for line in lines]
        assert len(set(slots)) == len(slots)


def test_slots_given_before_stay():
    given = missing_slots(KNOWLEDGE)
    assert given == {}


def test_a_new_sentence_avoids_the_slots_above_and_below_it():
    knowledge = chain(2, 1, 2)
    old = {frame.number: slot for slot, frame in enumerate(knowledge.topics[0].frames)}
    topics = tuple(
        msgspec.structs.replace(
            topic,
            frames=tuple(
                msgspec.structs.replace(frame, slot=old.get(frame.number, -1))
                for frame in topic.frames
            ),
        )
        for topic in knowledge.topics
    )
    assert sorted(missing_slots(Knowledge(topics=topics)).values()) == [2, 3, 4]


def test_brothers_may_share_slots():
    topics = (
        Topic(key="Tea", is_a=ROOT, number=1, frames=frames(1, 1)),
        Topic(key="Milk", is_a=ROOT, number=2, frames=frames(2, 1)),
    )
    assert missing_slots(Knowledge(topics=topics)) == {1: 0, 2: 0}


def test_a_class_that_is_borrowed_from_and_lies_above_hides_no_other():
    knowledge = chain(1, 1, 1, 1, also=("T2", "Gone"))
    assert sorted(missing_slots(knowledge).values()) == [0, 1, 2, 3]


def test_a_new_sentence_avoids_what_a_topic_below_borrows():
    herb = msgspec.structs.replace(frames(3, 1)[0], slot=0)
    topics = (
        Topic(key="Tea", is_a=ROOT, number=1, frames=frames(1, 1)),
        Topic(key="MintTea", is_a="Tea", number=2, also=("Herb",)),
        Topic(key="Herb", is_a=ROOT, number=3, frames=(herb,)),
    )
    assert missing_slots(Knowledge(topics=topics)) == {1: 1}


def test_a_circle_or_an_unknown_parent_does_not_hang():
    topics = (
        Topic(key="Tea", is_a="Milk", number=1, frames=frames(1, 1)),
        Topic(key="Milk", is_a="Tea", number=2, frames=frames(2, 1)),
        Topic(key="Music", is_a="Gone", number=3, frames=frames(3, 1)),
    )
    slots = missing_slots(Knowledge(topics=topics))
    assert slots[1] != slots[2]


def test_where_more_than_128_sentences_meet_slots_are_shared():
    slots = missing_slots(chain(MAX_SLOT + 3))
    assert set(slots.values()) == set(range(MAX_SLOT + 1))


@given(some.lists(some.integers(0, 6), min_size=1, max_size=6))
def test_along_every_path_slots_are_unique(counts):
    knowledge = chain(*counts)
    slots = missing_slots(knowledge)
    assert len(set(slots.values())) == sum(counts)
    assert len(build_tree(knowledge).nodes) == len(counts)
