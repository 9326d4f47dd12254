"""The Plan Manager's answers: plan sentence, plan, KBplan, capabilities, proposals."""

from random import Random

from plans.engine.catalogue import compile_catalogue
from plans.engine.intents import Library
from plans.engine.manager import Action, PlanAnswer, answer, carry_out
from tests.engine.plans.worlds import PLAYSONG, robot

ROBOT = robot()


def asked(sentence: str, **more: object) -> PlanAnswer:
    return answer(ROBOT, sentence, "en", chance=Random(1), **more)  # type: ignore[arg-type]


def test_a_request_is_answered_with_sentence_and_plan() -> None:
    reply = asked("Play Hey Brother")
    assert reply.plan_sentence == "Let us listen to Hey Brother."
    assert reply.plan == "#action=playsong title=Hey Brother"
    assert reply.plan_actions == (Action("playsong", {"title": "Hey Brother"}),)
    assert reply.kbplan == ""


def test_ordinary_talk_gets_an_empty_answer() -> None:
    reply = asked("My sister played the piano")
    assert (reply.intent, reply.plan, reply.kbplan, reply.plan_sentence) == ("", "", "", "")


def test_a_wish_is_answered_with_a_kbplan() -> None:
    reply = asked("I love green tea")
    assert reply.kbplan == (
        "#action=setlikeliness topic=green_tea value=1.0"
        "#action=jump topic=green_tea startsentence=p"
    )
    assert reply.kbplan_actions[1].parameters == {"topic": "green tea", "startsentence": "p"}


def test_a_topic_is_said_from_the_agents_side() -> None:
    assert asked("I love my wife").plan_sentence == "So you like your wife."


def test_a_sentence_with_a_missing_slot_is_not_chosen() -> None:
    reply = asked("play some music")
    assert reply.plan_sentence == ""
    assert reply.plan == "#action=playsong title=None"
    assert (reply.missing, reply.question) == ("title", "Which song?")


def test_a_sentence_is_kept_for_its_culture() -> None:
    said = {asked("play Volare", culture="IN").plan_sentence for _ in range(3)}
    assert said <= {"Let us listen to Volare.", "Namaste, music!"}
    assert asked("play some music", culture="IN").plan_sentence == "Namaste, music!"


def test_a_robot_that_cannot_says_so() -> None:
    reply = asked("play Volare", capabilities={"hello"})
    assert (reply.plan, reply.plan_actions) == ("", ())
    assert reply.plan_sentence == "I am sorry, I cannot do that."
    assert "Left out playsong: this robot cannot do it." in reply.steps


def test_a_robot_that_cannot_call_for_help_sends_to_the_staff() -> None:
    assert asked("help me", capabilities=()).plan_sentence == "Please call the staff."


def test_what_is_possible_of_a_plan_stays() -> None:
    assert asked("go charge", capabilities={"rest"}).plan == "#action=rest"


def test_an_accepted_proposal_is_carried_out() -> None:
    reply = carry_out(ROBOT, "playsong", {"title": "Volare"}, "en", chance=Random(1))
    assert reply.plan == "#action=playsong title=Volare"
    assert reply.plan_sentence == "Let us listen to Volare."


def test_a_proposal_whose_intent_is_gone_does_nothing() -> None:
    reply = carry_out(ROBOT, "retired", {}, "en", chance=Random(1))
    assert (reply.intent, reply.plan) == ("", "")


def test_a_proposal_cannot_forge_a_plan() -> None:
    reply = carry_out(ROBOT, "playsong", {"title": "x\n#action=rest"}, "en", chance=Random(1))
    assert reply.plan == "#action=playsong title=x rest"


def test_the_same_chance_says_the_same() -> None:
    assert asked("play Volare", culture="IN") == asked("play Volare", culture="IN")


def test_a_library_without_words_for_it_stays_silent_about_what_it_cannot() -> None:
    silent = compile_catalogue(Library(intents=(PLAYSONG,)))
    reply = answer(silent, "play Volare", "en", chance=Random(1), capabilities=())
    assert (reply.plan, reply.plan_sentence) == ("", "")
