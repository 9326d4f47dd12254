"""abilities: the person asks what the agent can do."""

from tests.engine.dialogue.talk import act, hear, kinds_said, mrs_smith


def test_what_the_robot_can_do_is_named():
    before = mrs_smith("Tea")
    reply = hear(before, "What can you do?", act("abilities"))
    assert kinds_said(before, reply) == ["abilities"]
    assert "play a song" in reply.sentence
    assert "wave" in reply.sentence


def test_each_language_says_it_in_its_own_words():
    reply = hear(mrs_smith("Tea", language="it"), "Che cosa sai fare?", act("abilities"))
    assert "mettere una canzone" in reply.sentence


def test_what_this_robot_cannot_do_is_not_named():
    reply = hear(mrs_smith("Tea"), "What can you do?", act("abilities"), capabilities=["playsong"])
    assert "play a song" in reply.sentence
    assert "wave" not in reply.sentence


def test_a_robot_that_can_do_nothing_goes_on_talking():
    before = mrs_smith("Tea", ordering="c")
    reply = hear(before, "What can you do?", act("abilities"), capabilities=[])
    assert kinds_said(before, reply)[-1] == "c"
