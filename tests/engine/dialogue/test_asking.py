"""A missing parameter: asked for once, the bare answer understood, "never mind" leaves."""

from dialogue.engine.state import Pending
from dialogue.engine.turn import Asking
from tests.engine.dialogue.talk import act, hear, kinds_said, mrs_smith
from tests.engine.dialogue.world import WORLD

PLAYSONG = WORLD.catalogue.intents["playsong"]
WHICH = Asking(Pending(PLAYSONG.number, "title"), "Which song?")


def waiting():
    return hear(mrs_smith("Tea", ordering="wc"), "Play a song", plan_matched=True, asking=WHICH)


def test_the_question_is_all_that_is_said_and_the_plan_waits():
    reply = waiting()
    assert (reply.sentence, reply.sentence_type, reply.plan) == ("Which song?", "e", None)
    assert reply.state.pending == Pending(PLAYSONG.number, "title")
    assert reply.state.ordering == "wc"


def test_the_bare_answer_brings_the_plan_and_the_talk_goes_on():
    reply = hear(waiting().state, "Hey Jude.")
    assert reply.plan is not None
    assert reply.plan.plan == "#action=playsong title=Hey Jude"
    assert (reply.state.pending, reply.sentence_type) == (None, "w")


def test_never_mind_is_the_way_out():
    reply = hear(waiting().state, "Never mind")
    assert (reply.plan, reply.state.pending) == (None, None)
    assert "goal_refused" in kinds_said(waiting().state, reply)


def test_silence_is_a_way_out_too():
    assert hear(waiting().state, "  ").plan is None


def test_another_wish_wins_over_the_question():
    reply = hear(waiting().state, "Let us talk about milk", act("jump", topic="milk"))
    assert (reply.topic, reply.plan, reply.state.pending) == ("Milk", None, None)


def test_an_intent_that_is_gone_is_forgotten():
    before = mrs_smith("Tea", ordering="w", pending=Pending(999, "title"))
    reply = hear(before, "Hey Jude")
    assert (reply.plan, reply.state.pending) == (None, None)


def test_a_cry_for_help_does_not_leave_the_question_waiting():
    reply = hear(waiting().state, "Help, I have fallen", urgent=True, plan_matched=True)
    assert reply.state.pending is None
    assert reply.topic == "OnYourMind"


MEANT = Asking(Pending(PLAYSONG.number, "", (("title", "Volare"),)), "Shall I play a song?")


def nearly(**before):
    return hear(mrs_smith("Tea", **{"ordering": "wc"} | before), "Pley me Volare", asking=MEANT)


def test_what_was_nearly_understood_is_asked_about():
    reply = nearly()
    assert (reply.sentence, reply.plan) == ("Shall I play a song?", None)
    assert reply.state.pending == MEANT.pending


def test_a_yes_brings_the_plan():
    reply = hear(nearly().state, "Yes please")
    assert reply.plan is not None
    assert reply.plan.plan == "#action=playsong title=Volare"
    assert reply.sentence_type == "w"


def test_a_no_lets_it_be():
    reply = hear(nearly().state, "No")
    assert (reply.plan, reply.state.pending) == (None, None)
    assert "goal_refused" in kinds_said(nearly().state, reply)


def test_any_other_talk_lets_it_be_without_a_word():
    reply = hear(nearly().state, "My sister lived in Leeds")
    assert reply.plan is None
    assert "goal_refused" not in kinds_said(nearly().state, reply)


def test_an_answer_to_our_question_is_not_taken_for_a_request():
    before = mrs_smith("Tea", ordering="rw", last_type="q")
    assert hear(before, "Yes, I play it", asking=MEANT).state.pending is None


def test_an_answer_that_does_not_fit_lets_the_plan_be():
    before = mrs_smith("Tea", ordering="w", pending=Pending(PLAYSONG.number, "colour"))
    assert hear(before, "Blue").plan is None
