"""The Plan Manager alone: did the person ask for something?"""

from itertools import pairwise

import pytest

from tests.api.conftest import Api

EMPTY = {
    "intent": "",
    "parameters": {},
    "plan_sentence": "",
    "plan": "",
    "plan_actions": [],
    "kbplan": "",
    "kbplan_actions": [],
    "question": None,
}


def test_a_request_gives_a_plan(api: Api) -> None:
    answer = api.post("plan/", client_sentence="Play the song Hey Brother", language="en")
    assert set(answer) == set(EMPTY)
    assert answer["intent"] == "playsong"
    assert answer["parameters"] == {"title": "Hey Brother"}
    assert answer["plan"] == "#action=playsong title=Hey Brother"
    assert answer["plan_sentence"]


def test_a_wish_to_talk_gives_a_kbplan(api: Api) -> None:
    answer = api.post("plan/", client_sentence="Let us talk about music", language="en")
    assert answer["plan"] == ""
    assert "#action=jump topic=music" in answer["kbplan"]
    assert {"jump"} <= {one["action"] for one in answer["kbplan_actions"]}


def test_nothing_asked_for_gives_nothing(api: Api) -> None:
    assert api.post("plan/", client_sentence="mmm", language="en") == EMPTY


def test_a_language_may_be_a_tag(api: Api) -> None:
    wish = "Suona la canzone Hey Brother"
    answer = api.post("plan/", client_sentence=wish, language="it-IT")
    assert answer["plan"] == "#action=playsong title=Hey Brother"


def test_a_plan_in_an_unknown_language_is_refused(api: Api) -> None:
    asked = {"client_sentence": "Play Hey Brother", "language": "xx"}
    assert api.refused("plan/", **asked) == (400, "language.unknown")


def test_a_parameter_nobody_gave_is_none(api: Api) -> None:
    answer = api.post("plan/", client_sentence="play some music", language="en")
    assert answer["plan_actions"][0]["parameters"] == {"title": None}
    assert answer["plan"] == "#action=playsong title=None"


def test_capabilities_hold_for_the_plan_manager_too(api: Api) -> None:
    wish = {"client_sentence": "Play the song Hey Brother", "language": "en"}
    assert api.post("plan/", **wish, capabilities=[])["plan"] == ""


def test_intents_tell_what_people_can_ask_for(api: Api) -> None:
    intents = api.get("intents/")
    song = next(one for one in intents if one["name"] == "playsong")
    assert set(song) == {
        "name",
        "priority",
        "parameters",
        "triggers",
        "plan",
        "kbplan",
        "note",
    }
    assert song["plan"].startswith("#action=playsong title=")
    assert song["triggers"]["en"]


def test_actions_tell_their_parameters(api: Api) -> None:
    actions = {one["name"]: one for one in api.get("actions/")}
    assert actions["translate"]["parameters"] == ["language", "what"]
    assert actions["jump"]["kb"]
    assert not actions["playsong"]["kb"]


def test_every_plan_uses_a_known_action(api: Api) -> None:
    known = {one["name"] for one in api.get("actions/")}
    for intent in api.get("intents/"):
        for item in filter(None, (intent["plan"] + intent["kbplan"]).split("#")):
            assert item.split()[0].removeprefix("action=") in known


@pytest.mark.parametrize("wish", ["play # and\n more", "play a#action=alert", "play #"])
def test_a_sentence_cannot_write_actions_of_its_own(api: Api, wish: str) -> None:
    answer = api.post("plan/", client_sentence=wish, language="en")
    assert answer["plan"].count("#") == len(answer["plan_actions"])
    assert all(one["action"] == "playsong" for one in answer["plan_actions"])
    assert "\n" not in answer["plan"]


def test_intents_come_in_a_stable_order(api: Api) -> None:
    names = [one["name"] for one in api.get("intents/")]
    assert names == [one["name"] for one in api.get("intents/")]
    assert all(one != other for one, other in pairwise(names))


def test_what_is_missing_is_a_question(api: Api) -> None:
    answer = api.post("plan/", client_sentence="look something up for me", language="en")
    assert answer["plan"] == "#action=wikisearch what=None"
    assert answer["question"]["slot"] == "what"
    assert answer["question"]["text"]


def test_what_was_nearly_understood_is_a_question_and_no_plan(api: Api) -> None:
    answer = api.post("plan/", client_sentence="brightly step to the left", language="en")
    assert (answer["intent"], answer["plan"]) == ("", "")
    assert answer["question"]["intent"] == "move"
    assert answer["question"]["parameters"] == {"where": "left"}
