"""more: the person wants to stay with the topic."""

from itertools import pairwise

from tests.engine.dialogue.talk import act, hear, kinds_said, mrs_smith


def test_a_remark_comes_now_and_an_open_question_next():
    before = mrs_smith("Tea")
    reply = hear(before, "Tell me more", act("more"))
    assert (reply.topic, kinds_said(before, reply)) == ("Tea", ["c"])
    assert hear(reply.state, "Ah").sentence_type == "w"


def test_however_often_it_is_asked_for_no_remark_comes_twice_in_a_row():
    reply, said = hear(mrs_smith("Grief"), "More", act("more")), []
    for _ in range(10):
        said.append(reply.sentence)
        reply = hear(reply.state, "More", act("more"))
    assert all(one != other for one, other in pairwise(said))


def test_before_any_topic_one_begins():
    assert hear(mrs_smith(), "Tell me more", act("more")).topic


def test_after_a_joke_more_is_another_joke():
    first = hear(mrs_smith("Tea"), "A joke", act("tell", kind="joke"))
    second = hear(first.state, "Another one", act("more"))
    assert kinds_said(first.state, second) == ["joke"]
    assert first.sentence != second.sentence
