"""forget: the agent forgets what it learned."""

from tests.engine.dialogue.talk import act, hear, kinds_said, mrs_smith
from tests.engine.dialogue.world import NUMBERS

LIKES_TEA = mrs_smith("Tea").with_likeliness(NUMBERS["Tea"], 1.0)


def test_all_learned_likeliness_is_gone():
    reply = hear(LIKES_TEA, "Forget me", act("forget"))
    assert kinds_said(LIKES_TEA, reply) == ["forget"]
    assert reply.state.levels == b""


def test_what_the_plan_said_is_not_said_again():
    reply = hear(LIKES_TEA, "Forget me", act("forget"), plan_said=True)
    assert (reply.sentence, reply.state.levels) == ("", b"")
