"""The page of an intent: what is saved, refused and told."""

import pytest
from django.contrib.auth import get_user_model
from django.contrib.auth.models import Group
from django.test import Client
from django.urls import reverse
from pytest_django import DjangoAssertNumQueries

from authoring.intent_page.draft_library import draft_library
from authoring.roles import ADMINISTRATOR, AUTHOR, PUBLISHER, RESEARCHER
from dialogue.publishing import publish
from plans import models
from tests.admin.pages import errors, form_of, send
from tests.authoring.intent_forms import (
    ADD,
    ANSWER,
    FAILING,
    LIST,
    TESTS,
    TRY,
    answer,
    check,
    plants,
    song,
    told,
)

pytestmark = pytest.mark.usefixtures("small_draft", "nothing_kept")


def test_water_the_plants_is_made_without_an_action(admin_client: Client) -> None:
    response = admin_client.post(reverse(ADD), plants())
    assert response.status_code == 302, errors(response)
    intent = models.Intent.objects.get(key="water_the_plants")
    assert intent.abilities == {"en": "water the plants", "it": "annaffiare le piante"}
    rows = intent.triggers.values_list("language", "text", "position")
    assert [row for row in rows if row[0] == "en"] == [
        ("en", "water (the|my) plants", 0),
        ("en", "give the plants some water", 1),
    ]
    assert not intent.plan_actions.exists()
    assert list(intent.tests.order_by("pk").values_list("parameters", flat=True)) == [
        {},
        None,
        {},
        {},
    ]
    assert publish().counts["intents"] == 2


def test_an_emptied_line_is_deleted(admin_client: Client) -> None:
    response = send(admin_client, song(), plan_sentences__3__text="")
    assert response.status_code == 302, errors(response)
    texts = models.PlanSentence.objects.filter(intent__key="playsong", language="en")
    assert [one.text for one in texts] == ["Let us listen to {title}."]


def test_lines_can_change_places(admin_client: Client) -> None:
    send(admin_client, song(), tests__0__position="1", tests__1__position="0")
    rows = models.IntentTest.objects.filter(intent__key="playsong", language="en")
    assert [one.sentence for one in rows] == ["I like tea", "Play Hey Brother"]


@pytest.mark.parametrize(
    ("field", "value", "message", "marked_sign"),
    [
        ("triggers__0__text", "play {title", "Open '{' without '}'", "{"),
        ("triggers__0__text", "play {song}", "Slot 'song' is not declared", "{"),
        ("triggers__0__text", "{title}", "without any word of its own", None),
        ("triggers__0__text", "play <loudly> {title}", "There is no phrase 'loudly'", "&lt;"),
        ("plan_sentences__0__text", "Here is {song}.", "There is no parameter {song}.", "{"),
        ("plan_actions__0__action", "sing", "There is no action sing.", None),
        ("plan_actions__0__parameters", '[["title", "{song}"]]', "no parameter {song}", None),
        ("plan_actions__0__parameters", '[["name", "x"]]', "playsong takes no name.", None),
    ],
)
def test_a_fault_is_refused_and_marked_at_its_place(
    field: str, value: str, message: str, marked_sign: str | None, admin_client: Client
) -> None:
    response = send(admin_client, song(), **{field: value})
    assert message in errors(response)
    if marked_sign:
        assert f"<mark>{marked_sign}</mark>" in response.content.decode()


def test_values_of_an_action_chosen_before_are_dropped(admin_client: Client) -> None:
    response = send(admin_client, song(), plan_actions__0__action="hug")
    assert response.status_code == 302, errors(response)
    row = models.PlanAction.objects.get(intent__key="playsong")
    assert (row.action, row.parameters) == ("hug", [])


def test_a_failing_test_and_remarks_are_told_after_saving_and_do_not_block(
    admin_client: Client,
) -> None:
    data = form_of(admin_client, song())
    data["tests-0-sentence"] = "Sing Hey Brother"
    response = admin_client.post(song(), data, follow=True)
    assert "1 stored test fails: “Sing Hey Brother”" in told(response)
    assert "more, shown below the stored tests." in told(response)


def test_the_check_marks_each_test_of_an_unsaved_form(admin_client: Client) -> None:
    found = check(admin_client, plants(), tests="1")
    assert [mark["reason"] for mark in found["marks"]] == [""] * len(TESTS)
    data = plants() | {"tests-0-sentence": "Feed the cat"}
    found = check(admin_client, data, tests="1")
    assert found["marks"][0]["reason"].startswith("nothing matched")
    assert "1 test fails" in found["html"]


def test_a_line_that_cannot_be_read_does_not_stop_the_other_tests(admin_client: Client) -> None:
    found = check(admin_client, plants() | {"triggers-2-text": "give (the"}, tests="1")
    assert [(one["name"], one["position"]) for one in found["faults"]] == [("triggers-2-text", 5)]
    assert [mark["reason"] for mark in found["marks"]] == [""] * len(TESTS)


def test_a_sentence_of_another_intent_or_of_this_one_is_told_at_its_line(
    admin_client: Client,
) -> None:
    twice = {"triggers-1-text": "Water (the|my)  plants", "triggers-3-text": "metti la canzone"}
    models.Trigger.objects.filter(language="it").update(text="metti la canzone")
    found = {one["name"]: one["message"] for one in check(admin_client, plants() | twice)["faults"]}
    assert found["triggers-1-text"] == "This sentence is here twice. Remove one."
    assert found["triggers-3-text"].startswith("playsong has the same sentence.")


@pytest.mark.parametrize("role", [AUTHOR, PUBLISHER, RESEARCHER, ADMINISTRATOR, ""])
def test_who_may_read_may_try_and_who_may_write_may_save(role: str, client: Client) -> None:
    user = get_user_model().objects.create_user("someone", is_staff=True)
    if role:
        user.groups.add(Group.objects.get(name=role))
    client.force_login(user)
    seen = [client.get(reverse(name)).status_code for name in (TRY, LIST, FAILING)]
    tried = client.post(reverse(ANSWER), {"sentence": "Play Volare"}).status_code
    assert [*seen, tried] == [200 if role else 403] * 4
    assert client.get(song()).status_code == (200 if role else 403)
    made = client.post(reverse(ADD), plants()).status_code
    assert made == (302 if role in (AUTHOR, PUBLISHER, ADMINISTRATOR) else 403)


def test_a_reader_sees_the_sentences_without_inputs(client: Client) -> None:
    user = get_user_model().objects.create_user("reader", is_staff=True)
    user.groups.add(Group.objects.get(name=RESEARCHER))
    client.force_login(user)
    page = client.get(song()).content.decode()
    assert "(play|put on) [the song] {title}" in page
    assert 'name="triggers-0-text"' not in page


def test_the_page_and_the_list_need_few_queries(
    admin_client: Client, django_assert_max_num_queries: DjangoAssertNumQueries
) -> None:
    for place in range(30):
        intent = models.Intent.objects.create(key=f"tea{place}", position=place + 5)
        models.Trigger.objects.create(intent=intent, language="en", text=f"tea number{place}")
    with django_assert_max_num_queries(25):
        assert admin_client.get(song()).status_code == 200
    with django_assert_max_num_queries(12):
        page = admin_client.get(reverse(LIST))
    assert "en 1 · it 1 · ja 1" in page.content.decode()
    draft_library()
    with django_assert_max_num_queries(10):
        answer(admin_client, "Play Volare")


def test_the_page_itself_sends_every_row_with_its_number_and_box(admin_client: Client) -> None:
    page = admin_client.get(song()).content.decode()
    row = models.Intent.objects.get(key="playsong").triggers.earliest("position", "pk")
    assert f'<input type="hidden" name="triggers-0-id" value="{row.pk}" id="id_triggers-0-id">' in (
        page
    )
    assert f'name="triggers-0-language" value="{row.language}"' in page
    assert '<input type="checkbox" name="triggers-0-DELETE" id="id_triggers-0-DELETE">' in page
    assert "&lt;input" not in page
    assert "\0" not in page
