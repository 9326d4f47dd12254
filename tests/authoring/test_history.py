"""The history: who changed what, in plain words; back again; all of it on one page."""

from types import SimpleNamespace

import pytest
from django.http import HttpResponse
from django.test import Client
from django.urls import reverse
from pytest_django import DjangoAssertNumQueries

from authoring.history.history import (
    Change,
    Wanted,
    changes,
    count,
    history_of,
    models_with_history,
)
from authoring.roles import AUTHOR, PUBLISHER, RESEARCHER
from dialogue import models
from dialogue.bulk import note_about_draft
from dialogue.content import read_knowledge
from dialogue.draft import draft_version
from plans.models import Intent, Trigger
from plans.recording import in_bulk, recorded_for
from tests.admin.pages import send
from tests.authoring.people import logged_in, person

DRAFT = "dialogue.draftversion"
pytestmark = pytest.mark.usefixtures("small_draft")


@pytest.fixture
def maria() -> Client:
    """Return the browser of an author."""
    return logged_in(AUTHOR, "Maria")


def form(row: object, kind: str = "change") -> str:
    meta = type(row)._meta  # type: ignore[attr-defined]
    return reverse(f"admin:{meta.app_label}_{meta.model_name}_{kind}", args=(row.pk,))  # type: ignore[attr-defined]


def topic(key: str) -> models.Topic:
    return models.Topic.objects.get(key=key)


def frame(key: str) -> models.Frame:
    return models.Frame.objects.get(key=key)


def text(key: str, language: str) -> str:
    return models.Sentence.objects.get(frame__key=key, language=language).text


def change_sentence(client: Client, words: str, key: str = "Drink.q1") -> None:
    place = list(frame(key).sentences.order_by("pk").values_list("language", flat=True)).index("it")
    changed = send(client, form(frame(key)), **{f"sentences__{place}__text": words})
    assert changed.status_code == 302


def found() -> list[Change]:
    """Return what persons changed, the latest first; lines about the whole draft are left out."""
    return [one for one in changes(Wanted()) if one.model != DRAFT]


def go_back(client: Client, place: int = 0) -> HttpResponse:
    """Take back one of the last changes."""
    one = found()[place]
    return client.post(reverse("admin:audit_back", args=(one.model, one.record)))


def test_loading_the_content_records_no_row() -> None:
    assert found() == []


def test_every_model_of_the_draft_has_a_history() -> None:
    names = {label.partition(".")[2] for label in models_with_history()}
    assert names >= {"topic", "topicname", "keywordset", "variable", "topicinstance", "topiclink"}
    assert names >= {"frame", "sentence", "culture", "intent", "slot", "trigger", "plansentence"}
    assert names >= {"planaction", "kbplanaction", "intenttest", "phrase", "valuelist"}
    assert "publication" not in names


def test_a_change_says_who_what_and_both_texts(maria: Client) -> None:
    before = text("Drink.q1", "it")
    change_sentence(maria, "Ti piace $hasName?")
    (one,) = found()
    assert one.words == "Maria changed the Italian sentence of Drink.q1"
    assert [(each.old, each.new) for each in one.fields] == [(before, "Ti piace $hasName?")]


def test_saving_without_a_change_leaves_no_trace(maria: Client) -> None:
    assert send(maria, form(topic("Tea"))).status_code == 302
    assert found() == []


def test_the_topic_shows_what_was_changed_in_its_sentences_and_names(maria: Client) -> None:
    change_sentence(maria, "Ti piace?")
    send(maria, form(topic("Drink")), note="checked", names__0__name="beverage")
    send(maria, form(topic("Milk")), note="another topic")
    page = maria.get(form(topic("Drink"), "history")).content.decode()
    assert "the Italian sentence of Drink.q1" in page
    assert "the English name of Drink" in page
    assert "the topic Drink" in page
    assert "another topic" not in page


def test_the_intent_shows_what_was_changed_in_its_triggers(maria: Client) -> None:
    trigger = Trigger.objects.earliest("pk")
    send(maria, form(trigger.intent), triggers__0__text="do something else")
    page = maria.get(form(trigger.intent, "history")).content.decode()
    assert f"of the intent {trigger.intent.key}" in page
    assert "do something else" in page


def test_a_sentence_page_shows_its_texts_only(maria: Client) -> None:
    change_sentence(maria, "Ti piace?")
    assert count(history_of(frame("Drink.q1"))) == 1
    assert count(history_of(frame("GreenTea.c1"))) == 0


def test_a_parent_is_told_by_its_name(maria: Client) -> None:
    send(maria, form(topic("Milk")), parent=str(topic("Tea").pk))
    (one,) = found()
    assert [(each.old, each.new) for each in one.fields] == [("Drink", "Tea")]


def test_what_a_topic_lends_is_told_and_taken_back(maria: Client) -> None:
    milk, tea = topic("Milk"), topic("Tea")
    before = set(milk.also.all())
    send(maria, form(milk), also=[str(tea.pk)])  # type: ignore[arg-type]
    (one,) = found()
    assert one.fields[0].new == "Tea"
    assert go_back(maria).status_code == 302
    assert set(milk.also.all()) == before


def test_a_change_is_taken_back_as_a_new_change(maria: Client) -> None:
    before, version = text("Drink.q1", "it"), draft_version()
    change_sentence(maria, "Ti piace?")
    assert go_back(maria).status_code == 302
    assert text("Drink.q1", "it") == before
    assert draft_version() > version + 1
    assert [one.reason for one in found()] == ["back", ""]


def test_going_back_shows_first_what_it_would_do(maria: Client) -> None:
    before = text("Drink.q1", "it")
    change_sentence(maria, "Ti piace molto?")
    one = found()[0]
    page = maria.get(reverse("admin:audit_back", args=(one.model, one.record))).content.decode()
    assert "Ti piace molto?" in page
    assert before.replace("'", "&#x27;") in page
    assert text("Drink.q1", "it") == "Ti piace molto?"


def test_a_change_that_no_longer_fits_is_refused_in_words(maria: Client) -> None:
    send(maria, form(topic("Milk")), key="Cream")
    models.Topic.objects.create(key="Milk")
    answer = go_back(maria)
    assert answer.status_code == 409
    assert "It no longer fits" in answer.content.decode()
    assert models.Topic.objects.filter(key="Cream").exists()


def test_a_change_of_a_row_that_is_gone_is_refused(maria: Client) -> None:
    change_sentence(maria, "Ti piace?")
    maria.post(form(frame("Drink.q1"), "delete"), {"post": "yes"})
    place = [one.kind for one in found()].index("~")
    assert "has been deleted since" in go_back(maria, place).content.decode()


def test_a_renamed_topic_taken_back_takes_its_sentences_along(maria: Client) -> None:
    send(maria, form(topic("GreenTea")), key="Sencha")
    assert frame("Sencha.c1")
    go_back(maria)
    assert frame("GreenTea.c1")


def test_a_deleted_topic_comes_back_with_all_its_parts(maria: Client) -> None:
    before = read_knowledge()
    maria.post(form(topic("GreenTea"), "delete"), {"post": "yes"})
    assert read_knowledge() != before
    place = [one.words for one in found()].index("Maria deleted the topic GreenTea")
    assert go_back(maria, place).status_code == 302
    assert read_knowledge() == before


def test_a_deleted_intent_comes_back_with_all_its_parts(maria: Client) -> None:
    from plans.content import read_library

    before, intent = read_library(), Intent.objects.earliest("pk")
    maria.post(form(intent, "delete"), {"post": "yes"})
    place = [one.model for one in found()].index("plans.intent")
    assert go_back(maria, place).status_code == 302
    assert read_library() == before


def test_a_sentence_whose_topic_is_gone_stays_away(maria: Client) -> None:
    maria.post(form(frame("GreenTea.c1"), "delete"), {"post": "yes"})
    maria.post(form(topic("GreenTea"), "delete"), {"post": "yes"})
    rows = found()
    place = next(i for i, one in enumerate(rows) if one.model == "dialogue.frame")
    answer = go_back(maria, place)
    assert answer.status_code == 409
    assert "is no longer there. Bring that back first." in answer.content.decode()


def test_what_is_there_again_is_not_brought_back_twice(maria: Client) -> None:
    maria.post(form(frame("GreenTea.c1"), "delete"), {"post": "yes"})
    place = [one.model for one in found()].index("dialogue.frame")
    deleted = found()[place]
    address = reverse("admin:audit_back", args=(deleted.model, deleted.record))
    assert maria.post(address).status_code == 302
    assert maria.post(address).status_code == 409


def test_a_researcher_takes_nothing_back(maria: Client) -> None:
    change_sentence(maria, "Ti piace?")
    assert go_back(logged_in(RESEARCHER)).status_code == 403
    page = logged_in(RESEARCHER, "Rie").get(form(topic("Drink"), "history")).content.decode()
    assert "Ti piace?" in page
    assert "Take this change back" not in page


@pytest.mark.parametrize("model", ["dialogue.publication", "auth.user", "x", "dialogue.topic"])
def test_records_that_are_none_are_not_found(model: str, maria: Client) -> None:
    assert maria.get(f"/admin/audit/{model}/999/").status_code == 404


def test_bulk_writing_leaves_one_line() -> None:
    request = SimpleNamespace(user=person(AUTHOR))
    with recorded_for(request):
        with in_bulk():
            Trigger.objects.earliest("pk").delete()
        note_about_draft("content loaded from files")
    one = changes(Wanted())[0]
    assert (one.model, one.reason) == (DRAFT, "content loaded from files")
    assert found() == []


def test_publishers_find_changes_by_person_day_kind_and_topic(maria: Client) -> None:
    change_sentence(maria, "Ti piace?")
    send(logged_in(AUTHOR, "Ken"), form(topic("Milk")), note="checked")
    reader = logged_in(PUBLISHER)
    ken, day = found()[0], found()[0].when.date().isoformat()
    number = models.Topic.history.get(history_id=ken.record).history_user_id
    for query, told, untold in (
        ({"person": number}, "topic Milk", "Drink.q1"),
        ({"model": "dialogue.sentence"}, "Drink.q1", "topic Milk"),
        ({"topic": "Drink"}, "Drink.q1", "topic Milk"),
        ({"day": day}, "Drink.q1", "2001"),
    ):
        page = reader.get("/admin/audit/", query).content.decode()
        assert told in page
        assert untold not in page
    assert "Drink.q1" not in reader.get("/admin/audit/", {"day": "2001-01-01"}).content.decode()


@pytest.mark.parametrize(
    "query",
    [
        {"day": "yesterday"},
        {"day": "9999-12-31"},
        {"person": "x"},
        {"p": "0"},
        {"p": "9" * 30},
        {"model": "auth.user"},
        {"topic": "a\0b" * 99},
        {"person": "9" * 50},
    ],
)
def test_nonsense_is_no_fault(query: dict[str, str]) -> None:
    assert logged_in(PUBLISHER).get("/admin/audit/", query).status_code == 200


def test_the_page_asks_few_queries_whatever_was_changed(
    maria: Client, django_assert_max_num_queries: DjangoAssertNumQueries
) -> None:
    maria.post(form(topic("GreenTea"), "delete"), {"post": "yes"})
    for intent in Intent.objects.all():
        maria.post(form(intent, "delete"), {"post": "yes"})
    for each in range(30):
        change_sentence(maria, f"Ti piace {each}?")
    reader = logged_in(PUBLISHER)
    with django_assert_max_num_queries(12):
        page = reader.get("/admin/audit/")
    assert len(page.context["changes"]) == 50
    assert reader.get("/admin/audit/", {"p": "2"}).context["changes"]
