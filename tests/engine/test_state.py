"""What a dialogue state remembers, and that it never changes in place."""

import pytest
from hypothesis import given
from hypothesis import strategies as some

from dialogue.engine.state import MAX_SLOT, MAX_TOPIC, DialogueState, Pending

TEA, MILK, MUSIC = 1, 2, 900
MRS_SMITH = DialogueState("en", "EN")


def test_a_new_person_has_no_likeliness_of_her_own():
    assert MRS_SMITH.likeliness(TEA) is None
    assert MRS_SMITH.covered_topics() == ()


@pytest.mark.parametrize(("value", "kept"), [(0.0, 0.0), (0.44, 0.4), (0.96, 1.0), (7, 1.0)])
def test_likeliness_is_kept_in_tenths_between_nothing_and_one(value, kept):
    assert MRS_SMITH.with_likeliness(TEA, value).likeliness(TEA) == kept


def test_a_likeliness_taken_back_leaves_the_decision_to_the_culture():
    state = MRS_SMITH.with_likeliness(MUSIC, 0.9).with_likeliness(MUSIC, None)
    assert state == MRS_SMITH


def test_a_change_is_a_copy():
    liking = MRS_SMITH.with_likeliness(TEA, 1.0)
    assert liking.likeliness(TEA) == 1.0
    assert MRS_SMITH.likeliness(TEA) is None


def test_one_topic_does_not_disturb_another():
    state = MRS_SMITH.with_likeliness(MUSIC, 0.3).with_likeliness(TEA, 1.0).with_used(MILK, 9)
    assert state.likeliness(MUSIC) == 0.3
    assert state.likeliness(MILK) is None
    assert state.covered_topics() == (TEA, MILK, MUSIC)


def test_a_sentence_said_about_tea_is_not_said_about_milk():
    state = MRS_SMITH.with_used(TEA, 2).with_used(TEA, MAX_SLOT)
    assert state.has_used(TEA, 2)
    assert state.has_used(TEA, MAX_SLOT)
    assert not state.has_used(TEA, 3)
    assert not state.has_used(MILK, 2)


def test_sentences_can_be_said_again_after_without_used():
    state = MRS_SMITH.with_used(TEA, 2).with_used(TEA, 3).with_used(TEA, 70)
    assert state.without_used(TEA, 1 << 2 | 1 << 70).used_slots(TEA) == 1 << 3
    assert state.without_used(TEA, -1) == MRS_SMITH


@given(some.sets(some.tuples(some.integers(0, 40), some.integers(0, MAX_SLOT)), max_size=30))
def test_exactly_the_sentences_said_are_used(said):
    state = MRS_SMITH
    for topic, slot in said:
        state = state.with_used(topic, slot)
    assert {(t, s) for t in range(41) for s in range(MAX_SLOT + 1) if state.has_used(t, s)} == said
    assert set(state.covered_topics()) == {topic for topic, _ in said}


def test_the_rings_keep_the_newest():
    state = MRS_SMITH
    for number in range(1, 101):
        state = state.with_frame(number).with_topic_started(number)
    assert state.frames == tuple(range(69, 101))
    assert state.topics == tuple(range(85, 101))
    assert state.topic == 100


def test_a_topic_stays_out_up_to_and_with_its_last_turn():
    state = DialogueState("en", "EN", turn=10).with_avoided(TEA, 15)
    assert state.avoids([MILK, TEA])
    assert not state.avoids([MILK])
    assert DialogueState("en", "EN", turn=15, avoided=state.avoided).avoids((TEA,))
    assert not DialogueState("en", "EN", turn=16, avoided=state.avoided).avoids((TEA,))


def test_at_most_eight_topics_stay_out_and_the_oldest_goes():
    state = MRS_SMITH
    for topic in (*range(1, 10), 5):
        state = state.with_avoided(topic, 20)
    assert [topic for topic, _ in state.avoided] == [2, 3, 4, 6, 7, 8, 9, 5]


def test_forgotten_takes_all_likings_and_keeps_what_was_said():
    state = MRS_SMITH.with_likeliness(TEA, 1.0).with_used(MILK, 0)
    assert state.forgotten() == MRS_SMITH.with_used(MILK, 0)


def test_numbers_out_of_range_are_refused():
    with pytest.raises(ValueError, match="Topic number 131072"):
        MRS_SMITH.with_likeliness(MAX_TOPIC + 1, 1.0)
    with pytest.raises(ValueError, match="Slot 128"):
        MRS_SMITH.with_used(TEA, 128)


def test_what_people_say_is_cut_to_fit():
    long = tuple((f"name{number}" * 20, "\ud800" + "a" * 999) for number in range(20))
    pending = Pending(7, "title", long).cut_to_fit()
    assert len(pending.parameters) == 8
    assert pending.parameters[0][1] == "?" + "a" * 299
    assert all(len(name) <= 40 for name, _ in pending.parameters)
