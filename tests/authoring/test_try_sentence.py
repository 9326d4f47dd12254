"""A sentence is tried with the intents of the draft and with an unsaved form."""

import pytest
from django.test import Client
from django.urls import reverse

from plans import models
from tests.admin.pages import form_of
from tests.authoring.intent_forms import ANSWER, CHECK, TRY, answer, check, plants, song

pytestmark = pytest.mark.usefixtures("small_draft", "nothing_kept")


def test_a_sentence_is_tried_with_the_saved_draft(admin_client: Client) -> None:
    found = answer(admin_client, "Could we play Volare")
    assert found["tried"]["winner"] is None
    found = answer(admin_client, "Play Volare")
    assert found["tried"]["pieces"] == [
        {"text": "Play ", "name": ""},
        {"text": "Volare", "name": "title"},
    ]
    assert found["tried"]["plan"] == "#action=playsong title=Volare"
    assert '<mark class="captured">Volare' in found["html"]


def test_a_sentence_is_tried_with_the_unsaved_form(admin_client: Client) -> None:
    assert answer(admin_client, "Water my plants")["tried"]["winner"] is None
    found = answer(admin_client, "Water my plants", intent="0", **plants())
    assert found["tried"]["winner"]["trigger"] == "water (the|my) plants"
    assert "this intent" in found["html"]
    assert not models.Intent.objects.filter(key="water_the_plants").exists()


def test_an_unsaved_form_stands_in_for_the_saved_intent(admin_client: Client) -> None:
    number = str(models.Intent.objects.get(key="playsong").pk)
    data = form_of(admin_client, song()) | {"triggers-0-text": "sing {title}", "intent": number}
    assert answer(admin_client, "Play Volare", **data)["tried"]["winner"] is None
    assert answer(admin_client, "Sing Volare", **data)["tried"]["number"] == int(number)


def test_near_misses_say_what_is_missing(admin_client: Client) -> None:
    found = answer(admin_client, "metti canzone Volare", "it")
    assert found["tried"]["near"]
    assert "It almost fits" in found["html"]


@pytest.mark.parametrize(
    ("sentence", "refusal"),
    [("", "Write a sentence first."), ("a" * 301, "The sentence has 301 characters.")],
)
def test_what_cannot_be_tried_is_told(sentence: str, refusal: str, admin_client: Client) -> None:
    found = answer(admin_client, sentence)
    assert found["tried"] is None
    assert refusal in found["html"]


def test_hostile_words_are_shown_as_text(admin_client: Client) -> None:
    assert "<script>" not in answer(admin_client, "play <script>alert(1)</script>")["html"]
    page = admin_client.get(reverse(TRY), {"sentence": '"><script>', "language": "xx"})
    assert "<script>alert" not in page.content.decode()
    assert '"><script>' not in page.content.decode()


def test_the_page_answers_without_a_script(admin_client: Client) -> None:
    page = admin_client.get(reverse(TRY), {"sentence": "Play Volare", "language": "en"})
    assert "Understood" in page.content.decode()


def test_only_posts_are_tried(admin_client: Client) -> None:
    assert [admin_client.get(reverse(name)).status_code for name in (ANSWER, CHECK)] == [405, 405]


@pytest.mark.parametrize("number", ["x", "99999999999999", "-1", ""])
def test_a_nonsense_form_is_answered(number: str, admin_client: Client) -> None:
    data = {"triggers-TOTAL_FORMS": "9" * 30, "slots-TOTAL_FORMS": "x", "priority": "abc"}
    assert check(admin_client, data, number, tests="1")["marks"] == []
    assert answer(admin_client, "Play Volare", intent=number, **data)["tried"]["winner"]
