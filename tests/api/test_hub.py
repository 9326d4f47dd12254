"""The Hub: a talk starts, a turn is taken."""

import pytest
from pytest_django.fixtures import DjangoAssertNumQueries

from tests.api.conftest import Api

TURN = {
    "dialogue_state",
    "dialogue_sentence",
    "plan_sentence",
    "plan",
    "plan_actions",
    "topic",
    "sentence_type",
}


def test_a_start_brings_a_state_and_a_sentence(api: Api) -> None:
    said = api.get("hub/")
    assert set(said) == {"dialogue_state", "first_sentence", "language", "culture", "topic"}
    assert said["dialogue_state"]
    assert said["first_sentence"]
    assert (said["language"], said["culture"]) == ("en", "EN")


@pytest.mark.parametrize(
    ("asked", "language", "culture"),
    [
        ({"language": "it"}, "it", "IT"),
        ({"language": "it-IT"}, "it", "IT"),
        ({"language": "JA"}, "ja", "JP"),
        ({"language": "en", "culture": "IN"}, "en", "IN"),
        ({"language": "it", "culture": "jp"}, "it", "JP"),
    ],
)
def test_a_talk_has_the_language_and_culture_asked_for(
    api: Api, asked: dict[str, str], language: str, culture: str
) -> None:
    said = api.get("hub/", **asked)
    assert (said["language"], said["culture"]) == (language, culture)


def test_the_same_seed_starts_the_same_talk(api: Api) -> None:
    assert api.get("hub/", seed=7) == api.get("hub/", seed=7)


def test_the_same_seed_gives_the_same_talk(api: Api) -> None:
    assert talk(api, 11) == talk(api, 11)
    assert talk(api, 11) != talk(api, 12)


def talk(api: Api, seed: int) -> list[str]:
    state, said = api.start(seed=seed), []
    for sentence in ("I love music", "yes", "let us change the subject", "no", "I don't know"):
        answer = api.post("hub/", client_sentence=sentence, dialogue_state=state)
        state = answer["dialogue_state"]
        said.append(answer["plan_sentence"] + answer["dialogue_sentence"])
    return said


@pytest.mark.parametrize("seed", ["abc", "-1", "4294967296", "9" * 5000, "1.5"])
def test_a_wrong_seed_is_refused(api: Api, seed: str) -> None:
    answer = api.client.get("/api/v1/hub/", {"seed": seed})
    assert (answer.status_code, answer.json()["error"]["code"]) == (400, "body.invalid")


def test_a_turn_answers_with_every_field(api: Api) -> None:
    answer = api.post("hub/", client_sentence="I love music", dialogue_state=api.start())
    assert set(answer) == TURN
    assert answer["dialogue_sentence"]
    assert answer["topic"]


def test_a_turn_without_a_plan_has_empty_texts(api: Api) -> None:
    answer = api.post("hub/", client_sentence="mmm", dialogue_state=api.start())
    assert (answer["plan_sentence"], answer["plan"], answer["plan_actions"]) == ("", "", [])


def test_a_turn_without_a_state_starts_a_talk(api: Api) -> None:
    answer = api.post("hub/", client_sentence="Mi piace la musica", language="it", culture="IT")
    talked = api.post("dialogue/inspect/", dialogue_state=answer["dialogue_state"])
    assert (talked["language"], talked["culture"], talked["turn"]) == ("it", "IT", 1)


def test_a_request_brings_its_plan(api: Api) -> None:
    answer = api.post("hub/", client_sentence="Play the song Hey Brother", seed=1)
    assert answer["plan"] == "#action=playsong title=Hey Brother"
    assert answer["plan_actions"] == [
        {"action": "playsong", "parameters": {"title": "Hey Brother"}}
    ]
    assert answer["plan_sentence"]


def test_what_the_client_cannot_do_is_not_promised(api: Api) -> None:
    wish = {"client_sentence": "Play the song Hey Brother", "seed": 1}
    able, unable = api.post("hub/", **wish), api.post("hub/", **wish, capabilities=["hello"])
    assert (unable["plan"], unable["plan_actions"]) == ("", [])
    assert unable["plan_sentence"]
    assert unable["plan_sentence"] != able["plan_sentence"]


def test_capabilities_that_include_the_action_change_nothing(api: Api) -> None:
    wish = {"client_sentence": "Play the song Hey Brother", "seed": 1}
    assert api.post("hub/", **wish) == api.post("hub/", **wish, capabilities=["playsong"])


def test_an_accepted_offer_brings_its_plan(api: Api) -> None:
    answer = api.post("hub/", client_sentence="yes, please", dialogue_state=offered(api))
    assert answer["plan"].startswith("#action=")
    assert answer["plan_actions"]
    assert answer["plan_sentence"] or answer["dialogue_sentence"]


def test_a_refused_offer_brings_no_plan(api: Api) -> None:
    answer = api.post("hub/", client_sentence="no, thank you", dialogue_state=offered(api))
    assert (answer["plan"], answer["plan_actions"]) == ("", [])


def offered(api: Api) -> str:
    """Return the state of a talk in which the agent has just offered something to do."""
    rows = [row for page in (1, 2, 3, 4) for row in api.get("topics/", page=page)["results"]]
    for row in rows:
        if "g" not in api.get(f"topics/{row['name']}/")["sentences"]:
            continue
        jump = {"action": "jump", "parameters": {"topic": row["name"], "startsentence": "g"}}
        state = api.post("dialogue/", client_sentence="x", seed=1, kbplan_actions=[jump])
        if api.post("dialogue/inspect/", dialogue_state=state["dialogue_state"])["offer"]:
            return str(state["dialogue_state"])
    pytest.fail("No topic offers anything.")


def test_a_state_serves_again_and_again(api: Api) -> None:
    state = api.start(seed=3)
    wish = {"client_sentence": "I love music", "dialogue_state": state}
    assert api.post("hub/", **wish) == api.post("hub/", **wish)


def test_options_name_languages_and_cultures(api: Api) -> None:
    options = api.get("hub/options/")
    assert [one["code"] for one in options["languages"]] == ["en", "it", "ja"]
    assert {"EN", "IT", "JP", "IN"} <= {one["code"] for one in options["cultures"]}


@pytest.mark.django_db
def test_a_turn_asks_the_database_nothing(
    api: Api, django_assert_num_queries: DjangoAssertNumQueries
) -> None:
    with django_assert_num_queries(0):
        state = api.start()
        api.post("hub/", client_sentence="I love music", dialogue_state=state)
        api.post("hub/", client_sentence="play Hey Brother", dialogue_state=state)


def test_an_address_without_its_last_slash_is_the_same_address(api: Api) -> None:
    answer = api.client.post("/api/v1/hub", b'{"client_sentence": "x"}', "application/json")
    assert answer.status_code == 200
    assert set(answer.json()) == TURN


def test_help_is_never_held_back_by_a_question_of_ours(api: Api) -> None:
    asked = api.post("hub/", client_sentence="search the internet")
    assert (asked["plan"], asked["dialogue_sentence"]) == ("", "What shall I look up?")
    state = asked["dialogue_state"]
    helped = api.post("hub/", client_sentence="help, I have fallen", dialogue_state=state)
    assert helped["plan"] == "#action=alert"
