"""The Dialogue Manager alone: what to say next, why, and what a state holds."""

import pytest

from tests.api.conftest import Api, Json


def jump(topic: str | None, startsentence: str = "q") -> Json:
    return {"action": "jump", "parameters": {"topic": topic, "startsentence": startsentence}}


def likeliness(topic: str, value: str) -> Json:
    return {"action": "setlikeliness", "parameters": {"topic": topic, "value": value}}


def test_a_kbplan_moves_the_talk(api: Api) -> None:
    answer = api.post("dialogue/", client_sentence="x", kbplan_actions=[jump("Music")])
    assert answer["topic"] == "Music"
    assert answer["dialogue_sentence"]


def test_a_kbplan_changes_what_the_person_likes(api: Api) -> None:
    actions = [likeliness("Music", "1.0"), jump("Music", "p")]
    answer = api.post("dialogue/", client_sentence="x", kbplan_actions=actions)
    inspected = api.post("dialogue/inspect/", dialogue_state=answer["dialogue_state"])
    assert inspected["likeliness"]["Music"] == 1.0


def test_the_plan_managers_answer_can_be_sent_on(api: Api) -> None:
    state = api.start(seed=4)
    sentence = "Let us talk about music"
    plan = api.post("plan/", client_sentence=sentence, language="en")
    answer = api.post(
        "dialogue/",
        client_sentence=sentence,
        dialogue_state=state,
        kbplan_actions=plan["kbplan_actions"],
        intent=plan["intent"],
    )
    assert answer["topic"] == "Music"


@pytest.mark.parametrize(
    "action",
    [
        jump(None),
        jump("No such topic"),
        jump("Music", "?"),
        {"action": "jump"},
        {"action": "fly to the moon"},
        {"action": ""},
        {"action": "setlikeliness", "parameters": {}},
        *(
            likeliness("Music", value)
            for value in ("nan", "inf", "-1", "1e999", "", "１", "x" * 99)
        ),
    ],
)
def test_a_kbplan_that_makes_no_sense_costs_nothing(api: Api, action: Json) -> None:
    answer = api.post("dialogue/", client_sentence="x", kbplan_actions=[action])
    assert answer["dialogue_sentence"]


@pytest.mark.parametrize("actions", ["jump", [1], [{"topic": "Music"}], [{"action": 1}], {}])
def test_a_kbplan_of_another_shape_is_refused(api: Api, actions: object) -> None:
    refused = api.refused("dialogue/", client_sentence="x", kbplan_actions=actions)
    assert refused == (400, "body.invalid")


def test_explain_tells_the_steps(api: Api) -> None:
    answer = api.post("dialogue/explain/", client_sentence="I love music", seed=3)
    assert answer["steps"]
    assert all(set(step) == {"rule", "text", "candidates"} for step in answer["steps"])


def test_explain_answers_like_the_hub(api: Api) -> None:
    wish = {"client_sentence": "I love music", "dialogue_state": api.start(seed=3)}
    explained = api.post("dialogue/explain/", **wish)
    explained.pop("steps")
    assert explained == api.post("hub/", **wish)


def test_inspect_reads_a_state(api: Api) -> None:
    answer = api.post("dialogue/", client_sentence="x", kbplan_actions=[jump("Music")], seed=9)
    seen = api.post("dialogue/inspect/", dialogue_state=answer["dialogue_state"])
    assert (seen["topic"], seen["turn"], seen["seed"]) == ("Music", 1, 9)
    assert seen["sentence_type"] == answer["sentence_type"]
    assert seen["used_sentences"]["Music"]
    assert not seen["ended"]


def test_inspect_without_a_state_is_refused(api: Api) -> None:
    assert api.refused("dialogue/inspect/") == (400, "state.unreadable")


def test_the_three_services_agree(api: Api) -> None:
    """The Hub's answer is the Plan Manager's plan and the Dialogue Manager's sentence."""
    wish = {"client_sentence": "mmm", "dialogue_state": api.start(seed=6)}
    assert api.post("hub/", **wish) == api.post("dialogue/", **wish)
