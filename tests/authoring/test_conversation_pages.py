"""The pages of regression conversations: saving, looking, deciding, by whom it is allowed."""

import json
from collections.abc import Iterator
from typing import Any

import pytest
from django.test import Client
from django.urls import reverse
from pytest_django import DjangoAssertNumQueries

from authoring.chat import chat_contents, chat_limits
from authoring.chat.conversation_turns import Turn, said_in
from authoring.chat.conversations import About, run_all, save
from authoring.chat.replaying import Talk, replay
from authoring.models import Conversation
from authoring.roles import ADMINISTRATOR, AUTHOR, PUBLISHER, RESEARCHER
from dialogue.draft import touch_draft
from dialogue.engine.content import Content
from dialogue.models import Sentence, Topic
from dialogue.publishing import draft, serve
from tests.authoring.people import logged_in

HEARD = ("I drink green tea", "play Hey Brother")
TALK = Talk("en", "EN", 7)


@pytest.fixture(autouse=True)
def _fresh_worker() -> Iterator[None]:
    chat_contents.forget()
    chat_limits.limit.left.clear()
    serve(None)
    yield
    chat_contents.forget()
    serve(None)


@pytest.fixture
def kept(small_draft: object) -> Conversation:
    """Save a talk of three turns in which every reply must be exactly the same."""
    content = draft()
    turns = [Turn(one.heard, said_in(one)) for one in replay(content, TALK, HEARD)]
    return save(content, TALK, turns, About("Tea and a song"))


def say_otherwise() -> None:
    """Let the robot begin its talks in other words."""
    Sentence.objects.filter(frame__key="start.1", language="en").update(text="Hello anew.")
    touch_draft()


def save_message(content: Content, **changes: object) -> dict[str, object]:
    said = [(one.heard, said_in(one)) for one in replay(content, TALK, HEARD)]
    return {
        "talk": {"content": "draft", "language": "en", "culture": "EN", "seed": 7},
        "title": "Tea",
        "turns": [
            {"heard": heard, "reply": one.text("en"), "plan": one.plan} for heard, one in said
        ],
        **changes,
    }


def post_json(client: Client, message: object) -> Any:
    return client.post(
        reverse("admin:chat_save"), json.dumps(message), content_type="application/json"
    )


@pytest.mark.usefixtures("small_draft")
def test_an_author_saves_a_talk_of_the_chat() -> None:
    client = logged_in(AUTHOR)
    answer = post_json(client, save_message(draft()))
    row = Conversation.objects.get()
    assert answer.json()["url"] == reverse("admin:conversation", args=[row.pk])
    assert (row.title, row.created_by.username, row.passed) == ("Tea", AUTHOR, True)
    assert run_all(draft())[0].passed


@pytest.mark.usefixtures("small_draft")
def test_what_one_did_not_see_is_not_saved() -> None:
    client, message = logged_in(AUTHOR), save_message(draft())
    say_otherwise()
    answer = post_json(client, message)
    assert (answer.status_code, answer.json()["error"]["code"]) == (409, "changed")
    assert not Conversation.objects.exists()


@pytest.mark.usefixtures("small_draft")
@pytest.mark.parametrize("title", ["", "   ", "x" * 121, "bell\x07"])
def test_a_bad_title_is_told(title: str) -> None:
    answer = post_json(logged_in(AUTHOR), save_message(draft(), title=title))
    assert answer.status_code == 400
    assert answer.json()["error"]["message"]
    assert not Conversation.objects.exists()


@pytest.mark.parametrize("role", [AUTHOR, PUBLISHER, RESEARCHER, ADMINISTRATOR])
def test_researchers_look_and_the_others_decide(role: str, kept: Conversation) -> None:
    say_otherwise()
    client, address = logged_in(role), reverse("admin:conversation", args=[kept.pk])
    page = client.get(address)
    allowed = role != RESEARCHER
    assert page.status_code == 200
    assert b"<ins>" in page.content
    assert (b"This is all right now" in page.content) is allowed
    seen = page.context["result"].digest
    data = {"content": "draft", "seen": seen, "right": "all"}
    assert client.post(address, data).status_code == (302 if allowed else 403)
    assert run_all(draft())[0].passed is allowed
    assert client.post(reverse("admin:conversations"), {"content": "draft"}).status_code == (
        302 if allowed else 403
    )


def test_nobody_else_sees_them(kept: Conversation) -> None:
    for client in (Client(), logged_in("")):
        for address in ("conversations", "conversation"):
            args = [kept.pk] if address == "conversation" else []
            assert client.get(reverse(f"admin:{address}", args=args)).status_code in (302, 403)


def test_all_are_run_from_the_list_and_the_result_is_told(kept: Conversation) -> None:
    say_otherwise()
    client = logged_in(AUTHOR)
    page = client.post(reverse("admin:conversations"), {"content": "draft"}, follow=True)
    assert b"1 conversation does not hold any more: Tea and a song" in page.content
    kept.refresh_from_db()
    assert kept.passed is False


def test_keeping_what_was_said_before_changes_nothing_but_the_result(kept: Conversation) -> None:
    say_otherwise()
    address = reverse("admin:conversation", args=[kept.pk])
    logged_in(AUTHOR).post(address, {"content": "draft", "seen": "x"})
    again = Conversation.objects.get()
    assert (again.turns, again.passed) == (kept.turns, False)


def test_a_page_that_is_old_accepts_nothing(kept: Conversation) -> None:
    say_otherwise()
    address = reverse("admin:conversation", args=[kept.pk])
    data = {"content": "draft", "seen": "of another time", "right": "all"}
    page = logged_in(AUTHOR).post(address, data, follow=True)
    assert b"look at them again" in page.content
    assert Conversation.objects.get().turns == kept.turns


def test_a_draft_with_errors_is_told_on_the_pages(kept: Conversation) -> None:
    Topic.objects.get(key="GreenTea").names.all().delete()
    Sentence.objects.filter(frame__key="Drink.q1", language="en").update(text="$nothingKnown?")
    touch_draft()
    client = logged_in(AUTHOR)
    page = client.get(reverse("admin:conversation", args=[kept.pk]))
    assert b"these errors must be mended first" in page.content
    assert client.post(reverse("admin:conversations"), {"content": "draft"}).status_code == 409


@pytest.mark.parametrize("content", ["draft", "published", "99999", "'; --"])
def test_any_content_can_be_asked_for(kept: Conversation, content: str) -> None:
    address = reverse("admin:conversation", args=[kept.pk])
    assert logged_in(AUTHOR).get(address, {"content": content}).status_code == 200


def test_the_list_asks_little_of_the_database(
    kept: Conversation, django_assert_max_num_queries: DjangoAssertNumQueries
) -> None:
    Conversation.objects.bulk_create(
        Conversation(title=f"Talk {n}", language="en", culture="EN", seed=n, turns=kept.turns)
        for n in range(1, 100)
    )
    client = logged_in(AUTHOR)
    with django_assert_max_num_queries(12):
        client.get(reverse("admin:conversations"))


def test_the_title_can_be_changed_and_the_row_deleted(kept: Conversation) -> None:
    client = logged_in(AUTHOR)
    address = reverse("admin:authoring_conversation_change", args=[kept.pk])
    client.post(address, {"title": "Better", "note": ""})
    assert Conversation.objects.get().title == "Better"
    assert Conversation.objects.get().turns == kept.turns
    client.post(reverse("admin:authoring_conversation_delete", args=[kept.pk]), {"post": "yes"})
    assert not Conversation.objects.exists()


def test_a_saved_talk_opens_in_the_chat(kept: Conversation) -> None:
    page = logged_in(AUTHOR).get(reverse("admin:chat"), {"conversation": kept.pk})
    assert [one["heard"] for one in page.context["opened"]] == ["", *HEARD]
    assert page.context["seed"] == 7
