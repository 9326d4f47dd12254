"""The test chat: what it answers, why, and what it refuses."""

import json
from collections.abc import Iterator
from typing import Any

import pytest
from django.test import Client
from django.urls import reverse
from pytest_django import DjangoAssertNumQueries
from pytest_django.fixtures import Settings

from authoring.chat import chat_contents, chat_limits
from authoring.chat.chat_limits import A_MINUTE, Limit
from authoring.chat.chat_rules import RULES
from authoring.chat.replaying import Talk, replay
from authoring.roles import ADMINISTRATOR, AUTHOR, PUBLISHER, RESEARCHER
from dialogue.draft import touch_draft
from dialogue.engine.content import Content
from dialogue.models import Frame, Sentence, Topic
from dialogue.publishing import publish, serve
from plans.models import Intent
from tests.authoring.people import logged_in

ROLES = (AUTHOR, PUBLISHER, RESEARCHER, ADMINISTRATOR)


@pytest.fixture(autouse=True)
def _fresh_worker() -> Iterator[None]:
    chat_contents.forget()
    chat_limits.limit.left.clear()
    serve(None)
    yield
    chat_contents.forget()
    serve(None)


@pytest.fixture
def author(small_draft: object) -> Client:
    return logged_in(AUTHOR)


def talk(**changes: object) -> dict[str, object]:
    return {"content": "draft", "language": "en", "culture": "EN", "seed": 7, **changes}


def post(client: Client, name: str, message: object) -> Any:
    text = message if isinstance(message, str) else json.dumps(message)
    return client.post(reverse(f"admin:{name}"), text, content_type="application/json")


def turn(client: Client, sentence: str = "", state: str = "", **changes: object) -> Any:
    answer = post(
        client, "chat_turn", {"talk": talk(**changes), "state": state, "sentence": sentence}
    )
    assert answer.status_code == 200, answer.content
    return answer.json()["turn"]


def said(client: Client, *sentences: str, **changes: object) -> list[Any]:
    turns = [turn(client, **changes)]
    for sentence in sentences:
        turns.append(turn(client, sentence, turns[-1]["state"], **changes))
    return turns


def told(step: Any) -> str:
    return "".join(piece["text"] for piece in step["pieces"])


def urls(found: Any) -> set[str]:
    return {piece["url"] for step in found["why"] for piece in step["pieces"]}


@pytest.mark.parametrize("role", ROLES)
@pytest.mark.usefixtures("small_draft")
def test_every_role_may_try_the_draft(role: str) -> None:
    client = logged_in(role)
    assert client.get(reverse("admin:chat")).status_code == 200
    assert turn(client)["sentence"] == "Well."


@pytest.mark.usefixtures("small_draft")
def test_nobody_else_may() -> None:
    assert logged_in("").get(reverse("admin:chat")).status_code == 403
    assert post(Client(), "chat_turn", {"talk": talk()}).status_code == 302


def test_a_page_elsewhere_cannot_talk_in_ones_name(author: Client) -> None:
    strict = Client(enforce_csrf_checks=True)
    strict.cookies = author.cookies
    assert post(strict, "chat_turn", {"talk": talk()}).status_code == 403


def test_a_reply_links_to_the_topic_and_the_sentence_it_came_from(author: Client) -> None:
    reply = said(author, "I drink green tea")[1]
    topic = Topic.objects.get(key="GreenTea")
    assert reply["topic_key"] == "GreenTea"
    assert reverse("admin:dialogue_topic_change", args=[topic.pk]) in urls(reply)
    frames = {
        reverse("admin:dialogue_frame_change", args=[frame.pk]) for frame in Frame.objects.all()
    }
    assert frames & urls(reply)


def test_the_trigger_its_words_and_the_plan_are_told(author: Client) -> None:
    reply = said(author, "play Hey Brother")[1]
    intent = Intent.objects.get(key="playsong")
    words = " ".join(map(told, reply["why"]))
    assert reply["plan"] == "#action=playsong title=Hey Brother"
    assert reply["actions"][0]["parameters"] == "title: Hey Brother"
    assert "(play|put on) [the song] {title}" in words
    assert "“Hey Brother” is taken as title = Hey Brother." in words
    assert reverse("admin:plans_intent_change", args=[intent.pk]) in urls(reply)


def test_a_robot_that_cannot_play_songs_is_told_of(author: Client) -> None:
    reply = said(author, "play Hey Brother", capabilities=["move"])[1]
    assert reply["plan"] == ""
    assert any("cannot do “playsong”" in told(step) for step in reply["why"])


def test_the_topics_a_topic_was_drawn_from_come_with_their_likeliness(author: Client) -> None:
    reply = said(author, "I drink green tea")[1]
    [drawn] = [step for step in reply["why"] if step["candidates"]][:1]
    assert drawn["candidates"][0]["chosen"]
    assert drawn["candidates"][0]["likeliness"] == 0.4


def test_what_the_robot_learns_is_shown_with_what_it_thought_before(author: Client) -> None:
    turns = said(author, topic="Tea")
    for _ in range(4):
        turns.append(turn(author, "yes", turns[-1]["state"]))
    learned = [one for each in turns for one in each["learned"] if one["changed"]]
    assert learned
    assert learned[0]["before"] == 0.5
    assert learned[0]["now"] == 0.9


def test_a_talk_can_begin_with_a_topic(author: Client) -> None:
    assert turn(author, topic="GreenTea")["topic_key"] == "GreenTea"


def test_the_same_seed_gives_the_same_talk(author: Client) -> None:
    first = said(author, "hello", "tea", "yes", seed=5)
    again = said(author, "hello", "tea", "yes", seed=5)
    assert [one["reply"] for one in first] == [one["reply"] for one in again]


def test_going_back_to_an_earlier_state_forgets_what_came_after(author: Client) -> None:
    turns = said(author, "tea", "yes")
    assert turn(author, "yes", turns[1]["state"])["reply"] == turns[2]["reply"]


def test_an_edited_sentence_is_marked_when_the_talk_is_had_again(author: Client) -> None:
    turns = said(author, topic="Tea")
    message = {
        "talk": talk(topic="Tea"),
        "turns": [{name: one[name] for name in ("heard", "reply", "plan")} for one in turns],
    }
    same = post(author, "chat_replay", message).json()["turns"]
    assert [one["changed"] for one in same] == [False]
    for sentence in Sentence.objects.filter(language="en"):
        sentence.text = sentence.text.replace(".", " indeed.").replace("?", " indeed?")
        sentence.save()
    [changed] = post(author, "chat_replay", message).json()["turns"]
    assert changed["changed"]
    come = [one["text"].strip() for one in changed["marks"] if one["kind"] == "come"]
    assert set(come) == {"indeed"}


def test_the_draft_is_built_once_for_each_version(
    author: Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    built = []
    build = chat_contents.draft
    monkeypatch.setattr(chat_contents, "draft", lambda: built.append(1) or build())
    said(author, "tea", "yes")
    assert len(built) == 1
    touch_draft()
    turn(author)
    assert len(built) == 2


def test_a_draft_with_errors_is_told_with_links_and_what_is_published_still_talks(
    author: Client,
) -> None:
    publish()
    sentence = Sentence.objects.filter(frame__key="Drink.q1", language="en")
    sentence.update(text="Do you like $nothingKnown?")
    touch_draft()
    answer = post(author, "chat_turn", {"talk": talk()})
    error = answer.json()["error"]
    frame = Frame.objects.get(key="Drink.q1")
    assert answer.status_code == 409
    assert error["code"] == "draft"
    [finding] = error["findings"]
    assert finding["url"] == reverse("admin:dialogue_frame_change", args=[frame.pk])
    assert (finding["where"], finding["more"]) == ("Drink.q1", "And 3 more like it.")
    assert turn(author, content="published")["sentence"]


def test_a_release_can_be_talked_with(author: Client) -> None:
    number = publish().pk
    Sentence.objects.filter(frame__key="start.1", language="en").update(text="Hello anew.")
    touch_draft()
    assert turn(author, content=str(number))["sentence"] == "Well."
    assert turn(author)["sentence"] == "Hello anew."


@pytest.mark.parametrize(
    ("message", "status", "code"),
    [
        ("", 400, "message"),
        ("[" * 50_000, 400, "message"),
        ('{"talk": 3}', 400, "message"),
        ({"talk": talk(seed=0)}, 400, "message"),
        ({"talk": talk(seed=2**40)}, 400, "message"),
        ({"talk": talk(language="tlh")}, 400, "choice"),
        ({"talk": talk(culture="XX")}, 400, "choice"),
        ({"talk": talk(topic="Nonsense")}, 400, "topic"),
        ({"talk": talk(content="999999")}, 400, "content"),
        ({"talk": talk(content="../etc")}, 400, "content"),
        ({"talk": talk(content="published")}, 503, "unpublished"),
        ({"talk": talk(), "state": "nonsense", "sentence": "hi"}, 400, "state"),
        ({"talk": talk(), "sentence": "x" * 250_000}, 413, "large"),
    ],
)
def test_what_cannot_be_answered_is_told_in_a_sentence(
    author: Client, message: object, status: int, code: str
) -> None:
    answer = post(author, "chat_turn", message)
    assert (answer.status_code, answer.json()["error"]["code"]) == (status, code)
    assert answer.json()["error"]["message"].endswith(".")


def test_a_sentence_is_cut_as_it_is_for_robots(author: Client, settings: Settings) -> None:
    settings.CAIR_LONGEST_SENTENCE = 10
    assert len(said(author, "y" * 500)[1]["heard"]) == 10


def test_too_many_turns_a_minute_must_wait(author: Client) -> None:
    limit = Limit(clock=lambda: 0.0)
    assert limit.take(1, A_MINUTE) == 0
    assert limit.take(1, 1) == 1
    assert limit.take(2, 1) == 0
    number = int(author.session["_auth_user_id"])
    chat_limits.limit.take(number, A_MINUTE)
    answer = post(author, "chat_turn", {"talk": talk()})
    assert (answer.status_code, answer.json()["error"]["code"]) == (429, "busy")


def test_a_bucket_fills_again() -> None:
    now = [0.0]
    limit = Limit(clock=lambda: now[0])
    limit.take(1, A_MINUTE)
    now[0] = 60.0
    assert limit.take(1, A_MINUTE) == 0


def test_a_turn_and_the_page_ask_little_of_the_database(
    author: Client, django_assert_max_num_queries: DjangoAssertNumQueries
) -> None:
    turn(author)
    with django_assert_max_num_queries(25):
        author.get(reverse("admin:chat"))
    with django_assert_max_num_queries(6):
        turn(author)


def test_markup_in_a_talk_stays_text(author: Client) -> None:
    page = author.get(reverse("admin:chat"), {"topic": '"><script>alert(1)</script>'})
    assert b"<script>alert" not in page.content


TALKS = {
    "en": "I like green tea|yes I love it|play Hey Brother|my wife died|tell me more|no|I hate it|"
    "let us talk about cats|change the subject|say that again|yes|what can you do|goodbye|hello|"
    "I need help|stop talking",
    "it": "mi piace il tè|sì|metti una canzone|mia moglie è morta|no|cambiamo argomento",
    "ja": "緑茶が好きです|はい|いいえ|音楽をかけて|話を変えて|さようなら",
}


@pytest.mark.parametrize("language", TALKS)
@pytest.mark.parametrize("seed", range(1, 9))
def test_every_step_of_a_talk_has_words_of_its_own(
    shipped: Content, language: str, seed: int
) -> None:
    heard = TALKS[language].split("|") * 3
    for one in replay(shipped, Talk(language, "", seed), heard, explain=True):
        for step in one.reply.steps:
            rules = [rule for rule in RULES if rule.name == step.rule]
            assert any(rule.pattern.fullmatch(step.text) for rule in rules), step
