"""stop: the person wants to end the talk."""

from dialogue.engine.actions.stop import stop
from tests.engine.dialogue.talk import act, hear, kinds_said, mrs_smith, turn_in


def test_the_agent_says_goodbye_and_keeps_everything():
    before = mrs_smith("Tea", ordering="wc", questions=2).with_likeliness(3, 0.9)
    reply = hear(before, "Goodbye", act("stop"))
    assert kinds_said(before, reply) == ["end"]
    assert reply.state.ended
    assert (reply.state.levels, reply.state.ordering) == (before.levels, "wc")
    assert reply.state.questions == 0


def test_the_action_itself_ends_the_talk():
    turn = turn_in(mrs_smith("Tea"))
    assert stop(turn, {})
    assert turn.state.ended


def test_another_goodbye_is_answered_too():
    before = mrs_smith("Tea", ended=True)
    reply = hear(before, "Goodbye", act("stop"))
    assert kinds_said(before, reply) == ["end"]


def test_another_action_opens_the_talk_again():
    assert not hear(mrs_smith("Tea", ended=True), "More", act("more")).state.ended
