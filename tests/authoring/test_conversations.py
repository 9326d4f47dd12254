"""Regression conversations: saved, run again, accepted anew."""

from collections.abc import Iterator
from io import StringIO
from typing import Any

import pytest
from django.core.exceptions import ValidationError
from django.core.management import CommandError, call_command
from pytest_django import DjangoAssertNumQueries

from authoring.chat import chat_contents, chat_limits, conversations
from authoring.chat.conversation_turns import (
    ANY,
    EXACT,
    PLAN,
    TOPIC,
    WORDS,
    Said,
    Turn,
    holds,
    said_in,
)
from authoring.chat.conversations import About, accept, run_all, save
from authoring.chat.replaying import MOST_TURNS, Talk, replay
from authoring.models import Conversation
from dialogue.draft import draft_version, touch_draft
from dialogue.engine.content import Content
from dialogue.models import Sentence, Topic
from dialogue.publishing import draft, load, publish, serve

HEARD = ("I drink green tea", "play Hey Brother")
TALK = Talk("en", "EN", 7)
REPLY = Said(plan_sentence="Here it comes.", plan="#action=volume level=up", sentence="Well, now.")


@pytest.fixture(autouse=True)
def _fresh_worker() -> Iterator[None]:
    chat_contents.forget()
    chat_limits.limit.left.clear()
    serve(None)
    yield
    chat_contents.forget()
    serve(None)


def turns(content: Content, **kinds: str) -> list[Turn]:
    """Return the turns of the talk; `turn1=TOPIC` for something looser."""
    found = [Turn(one.heard, said_in(one)) for one in replay(content, TALK, HEARD)]
    for name, kind in kinds.items():
        place = int(name[-1])
        values = {TOPIC: found[place].said.topic, PLAN: found[place].said.plan, WORDS: "Well"}
        found[place] = Turn(found[place].heard, found[place].said, kind, values.get(kind, ""))
    return found


@pytest.fixture
def kept(small_draft: object) -> Conversation:
    """Save a talk of three turns in which every reply must be exactly the same."""
    content = draft()
    return save(content, TALK, turns(content), About("Tea and a song"))


def say_otherwise() -> None:
    """Let the robot begin its talks in other words."""
    Sentence.objects.filter(frame__key="start.1", language="en").update(text="Hello anew.")
    touch_draft()


def test_a_saved_talk_holds_as_long_as_nothing_changes(kept: Conversation) -> None:
    [result] = run_all(draft())
    assert (result.passed, result.title, result.id) == (True, "Tea and a song", kept.pk)
    assert [one.heard for one in result.turns] == ["", *HEARD]


@pytest.mark.usefixtures("kept")
def test_another_reply_is_told_with_before_and_now() -> None:
    say_otherwise()
    [result] = run_all(draft())
    assert not result.passed
    assert result.reason == "The robot says something else."
    assert (result.turns[0].before.sentence, result.turns[0].now.sentence) == (
        "Well.",
        "Hello anew.",
    )
    assert [one.passed for one in result.turns] == [False, True, True]


def test_running_asks_once_and_writes_nothing(
    kept: Conversation, django_assert_num_queries: DjangoAssertNumQueries
) -> None:
    say_otherwise()
    content = draft()
    with django_assert_num_queries(1):
        run_all(content)
    kept.refresh_from_db()
    assert kept.passed


def test_the_result_is_noted_where_it_is_asked_for(kept: Conversation) -> None:
    publish()
    say_otherwise()
    run_all(draft(), write=True)
    kept.refresh_from_db()
    assert (kept.passed, kept.ran_on) == (False, 0)


def test_accepting_makes_the_new_reply_the_right_one(kept: Conversation) -> None:
    say_otherwise()
    content = draft()
    [result] = run_all(content)
    assert accept(content, kept.pk, result.digest).passed
    [again] = run_all(content)
    assert again.passed
    assert again.turns[0].before.sentence == "Hello anew."


def test_accepting_one_turn_leaves_the_others(kept: Conversation) -> None:
    Sentence.objects.filter(language="en").update(text="All is new.")
    touch_draft()
    content = draft()
    [result] = run_all(content)
    failed = [place for place, one in enumerate(result.turns) if not one.passed]
    assert len(failed) >= 2
    again = accept(content, kept.pk, result.digest, failed[0])
    assert [place for place, one in enumerate(again.turns) if not one.passed] == failed[1:]


def test_what_was_not_looked_at_is_not_accepted(kept: Conversation) -> None:
    [result] = run_all(draft())
    say_otherwise()
    with pytest.raises(conversations.ChangedMeanwhileError):
        accept(draft(), kept.pk, result.digest)
    assert Conversation.objects.get().turns == kept.turns


@pytest.mark.parametrize(
    ("kind", "value", "keeps"),
    [
        (EXACT, "", True),
        (TOPIC, "", True),
        (TOPIC, "Tea", False),
        (PLAN, "#action=volume  level=up", True),
        (PLAN, "", False),
        (WORDS, "well, HERE it", True),
        (WORDS, "we", False),
        (WORDS, "now well", False),
        (ANY, "", True),
    ],
)
def test_what_must_hold_can_be_looser(kind: Any, value: str, keeps: bool) -> None:
    assert holds(Turn("", REPLY, kind, value), REPLY, "en") is keeps


def test_words_are_found_in_japanese_too() -> None:
    reply = Said(sentence="緑茶はお好きですか？")
    assert holds(Turn("", reply, WORDS, "緑茶、好き"), reply, "ja")
    assert not holds(Turn("", reply, WORDS, "紅茶"), reply, "ja")


def test_exactly_the_same_means_words_and_plan_not_the_name_of_the_topic() -> None:
    renamed = Said(
        **{name: getattr(REPLY, name) for name in REPLY.__struct_fields__[:3]}, topic="X"
    )
    assert holds(Turn("", REPLY), renamed, "en")


def test_a_topic_that_is_gone_is_told(kept: Conversation) -> None:
    Conversation.objects.update(topic="Nonsense")
    [result] = run_all(draft())
    assert (result.passed, result.turns) == (False, ())
    assert "Nonsense" in result.reason


def test_a_culture_that_is_gone_and_damaged_turns_are_told(kept: Conversation) -> None:
    Conversation.objects.update(culture="XX")
    assert "XX" in run_all(draft())[0].reason
    Conversation.objects.update(culture="EN", turns=[{"said": 3}])
    assert "cannot be read" in run_all(draft())[0].reason


@pytest.mark.usefixtures("kept")
def test_there_are_limits(monkeypatch: pytest.MonkeyPatch) -> None:
    content = draft()
    some = turns(content)
    with pytest.raises(ValidationError, match="at most 100 turns"):
        save(content, TALK, some * MOST_TURNS, About("Long"))
    with pytest.raises(ValidationError):
        save(content, TALK, some, About("  "))
    monkeypatch.setattr(conversations, "MOST_CONVERSATIONS", 1)
    with pytest.raises(ValidationError, match="1 conversations already"):
        save(content, TALK, some, About("One more"))


def test_a_talk_saved_on_new_sentences_holds_once_they_are_published(small_draft: object) -> None:
    publish()
    topic = Topic.objects.get(key="Tea")
    for number in (1, 2, 3):
        frame = topic.frames.create(key=f"Tea.w{number}", type="w")
        for code in ("en", "it", "ja"):
            frame.sentences.create(language=code, text=f"{number}?")
    touch_draft()
    content = draft()
    heard = ["tea", "I see", "cows give milk", "so there is tea", "milk"] * 4
    for seed in range(1, 6):
        talk = Talk("en", "EN", seed)
        found = [Turn(one.heard, said_in(one)) for one in replay(content, talk, heard)]
        save(content, talk, found, About(f"Talk {seed}"))
    publish()
    assert [one.passed for one in run_all(load())] == [True] * 5


def test_saving_leaves_the_draft_as_it_is(small_draft: object) -> None:
    before = draft_version()
    save(draft(), TALK, turns(draft()), About("Tea"))
    assert draft_version() == before


@pytest.mark.usefixtures("kept")
def test_the_command_tells_what_does_not_hold() -> None:
    publish()
    out = StringIO()
    call_command("check_conversations", stdout=out)
    assert "All 1 conversations hold." in out.getvalue()
    say_otherwise()
    call_command("check_conversations", "--published", stdout=out)
    with pytest.raises(CommandError, match="1 of 1 conversations do not hold"):
        call_command("check_conversations", stdout=out)
    assert "now: Hello anew." in out.getvalue()
