"""The Plan Manager's answers: plan sentence, plan, KBplan, capabilities, proposals."""

from random import Random

from plans.engine.catalogue import compile_catalogue
from plans.engine.intents import Intent, Library, PlanSentence
from plans.engine.manager import Action, PlanAnswer, Question, answer, carry_out
from plans.engine.plan_text import parse_plan
from tests.engine.plans.worlds import PHRASES, PLAYSONG, robot

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
    assert reply.question == Question("playsong", "title", {}, "Which song?")


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


def test_what_is_possible_of_a_plan_stays_and_the_rest_is_said() -> None:
    reply = asked("go charge", capabilities={"rest"})
    assert (reply.plan, reply.plan_sentence) == ("#action=rest", "Only a part of that.")


def test_what_a_robot_cannot_is_said_in_the_words_of_the_intent() -> None:
    reply = asked("go charge", capabilities=())
    assert (reply.plan, reply.plan_sentence) == ("", "This robot cannot charge my battery.")


def test_an_uncommon_action_is_promised_only_to_who_names_it() -> None:
    timer = Intent(
        number=9,
        key="timer",
        triggers={"en": ("set a timer",)},
        plan_sentences={"en": (PlanSentence(text="I will ring."),)},
        plan=parse_plan("#action=timer seconds=60"),
    )
    robot = compile_catalogue(Library(intents=(timer,), phrases=PHRASES))
    said = {
        capabilities: answer(
            robot, "set a timer", "en", chance=Random(1), capabilities=capabilities
        ).plan_sentence
        for capabilities in (None, ("timer",))
    }
    assert said == {None: "I am sorry, I cannot do that.", ("timer",): "I will ring."}


def test_what_is_nearly_understood_is_asked_about_and_not_done() -> None:
    reply = asked("go quickly and charge")
    assert (reply.intent, reply.plan, reply.plan_sentence) == ("", "", "")
    assert reply.question == Question("charge", "", {}, "Shall I charge my battery?")


def test_nothing_is_offered_that_this_robot_cannot_do() -> None:
    assert asked("go quickly and charge", capabilities={"hello"}).question is None


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
