"""tell: a joke, a riddle, a story ... that the person asked for."""

import pytest

from dialogue.engine.actions.tell import KINDS
from dialogue.engine.pools import POOLS
from tests.engine.dialogue.talk import act, hear, kinds_said, mrs_smith


@pytest.mark.parametrize("kind", sorted(KINDS))
def test_a_line_of_the_pool_is_told_and_the_talk_stays(kind: str):
    before = mrs_smith("Tea", ordering="wc")
    reply = hear(before, "Tell me something", act("tell", kind=kind))
    assert kinds_said(before, reply) == [kind]
    assert (reply.topic, reply.state.ordering) == ("Tea", "wc")


def test_another_one_is_another_one():
    first = hear(mrs_smith("Tea"), "A joke", act("tell", kind="joke"))
    second = hear(first.state, "Another joke", act("tell", kind="joke"))
    assert first.sentence != second.sentence


def test_what_cannot_be_told_is_left_to_the_talk():
    before = mrs_smith("Tea", ordering="c")
    assert kinds_said(before, hear(before, "Sing", act("tell", kind="opera"))) == ["c"]


def test_every_kind_is_a_pool():
    assert set(POOLS) > KINDS
