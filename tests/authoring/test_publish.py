"""The page to publish: what would change, the steps, and how it ended."""

import threading

import pytest
from django.contrib.auth.models import User
from django.test import Client
from django.urls import reverse
from pytest_django import DjangoAssertNumQueries

from authoring.models import PublishRun
from authoring.releases import publish_run, releases
from authoring.releases.publish_run import begin, carry_out
from dialogue import publishing
from dialogue.draft import draft_version
from dialogue.models import Frame, Publication, Topic, TopicInstance, TopicName
from dialogue.publishing import DraftChangedError, publish
from tests.authoring.publishing_pages import JSON, followed, page, send, warm_milk

pytestmark = pytest.mark.usefixtures("small_draft")


def test_the_first_release_is_announced(admin_client: Client) -> None:
    text = page(admin_client)
    assert "What the first release holds" in text
    assert "5 topics added: " in text


def test_what_would_change_is_told_before_publishing(admin_client: Client) -> None:
    first = publish()
    warm_milk()
    TopicInstance.objects.filter(topic__key="Milk", culture__code="JP").update(likeliness="0.8")
    Topic.objects.get(key="Milk").save()
    text = page(admin_client)
    assert f"What changes from release {first.pk}" in text
    assert "Milk: likeliness for Japanese people 0.5 → 0.8." in text
    assert "<ins>warm </ins>milk" in text
    assert "2 changes in all." in text


def test_a_large_draft_is_compared_after_the_page_is_there(
    admin_client: Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    publish()
    warm_milk()
    monkeypatch.setattr(releases, "LARGE", 0)
    first = page(admin_client, kind="names")
    assert "Comparing the draft with the last release" in first
    assert "Milk: its name" not in first
    assert 'data-from="?kind=names&amp;whole=1"' in first
    assert 'id="publish-form"' in first
    assert "Milk: its name" in page(admin_client, kind="names", whole="1")
    assert "Milk: its name" in page(admin_client)


def test_one_kind_of_change_can_be_looked_at(admin_client: Client) -> None:
    publish()
    warm_milk()
    assert "Names of topics" in page(admin_client, kind="names")
    assert "Milk: its name" not in page(admin_client, kind="intents")
    assert "Milk: its name" in page(admin_client, kind="<script>")


def test_a_draft_that_is_served_already_says_so(admin_client: Client) -> None:
    row = publish()
    assert "Nothing: the draft says exactly what the last release says." in page(admin_client)
    assert f"release {row.pk} says exactly this already" in followed(admin_client)
    assert Publication.objects.count() == 1


def test_a_damaged_last_release_does_not_hinder_the_next(admin_client: Client) -> None:
    Publication.objects.create(checksum="0", data=b"CAIR")
    assert "A release is damaged" in page(admin_client)
    assert "is served to robots now" in followed(admin_client)


def test_the_page_takes_few_queries_once_it_was_shown(
    admin_client: Client, django_assert_max_num_queries: DjangoAssertNumQueries
) -> None:
    publish()
    warm_milk()
    page(admin_client)
    with django_assert_max_num_queries(12):
        page(admin_client)


def test_without_script_the_form_publishes_and_shows_the_release(admin_client: Client) -> None:
    text = followed(admin_client, note="  The first\n drinks ")
    row = Publication.objects.get()
    assert (row.note, row.author) == ("The first drinks", User.objects.get())
    assert f"Published: release {row.pk} is served to robots now." in text
    assert f"<h1>Release {row.pk}</h1>" in text


def test_with_script_the_steps_are_told(
    admin_client: Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    seen: list[object] = []
    address = ""

    class Watch(publish_run._Watch):
        def step(self, name: str) -> None:
            super().step(name)
            seen.append(admin_client.get(address).json())

    started: list[PublishRun] = []
    monkeypatch.setattr(publish_run, "_Watch", Watch)
    monkeypatch.setattr(publish_run, "start", lambda run, _seen: started.append(run))
    response = admin_client.post(
        reverse("admin:publish"), {"draft": str(draft_version())}, headers=JSON
    )
    assert response.status_code == 202
    address = response.json()["status"]
    carry_out(started[0])
    assert [(one["step"], one["place"], one["running"]) for one in seen] == [  # type: ignore[index]
        (name, place, True) for place, name in enumerate(publishing.STEPS)
    ]
    ended = admin_client.get(address).json()
    assert (ended["running"], ended["step"]) == (False, "done")
    assert "is served to robots now" in admin_client.get(ended["url"], follow=True).content.decode()


@pytest.mark.django_db(transaction=True)
def test_a_thread_of_its_own_publishes() -> None:
    before = set(threading.enumerate())
    run = begin(None, "in a thread", draft_version())
    publish_run.start(run)
    for thread in set(threading.enumerate()) - before:
        thread.join(60)
    run.refresh_from_db()
    assert (run.step, run.running) == ("done", None)
    assert run.publication is not None
    assert run.publication.note == "in a thread"


def test_errors_stop_it_and_are_shown_with_their_rows(admin_client: Client) -> None:
    TopicName.objects.get(topic__key="Milk", language="it").delete()
    text = followed(admin_client, note="Milk")
    assert "Not published: the draft has errors." in text
    assert "It has no name in Italian." in text
    assert 'value="Milk"' in text
    assert not Publication.objects.exists()
    assert set(Frame.objects.exclude(topic=None).values_list("slot", flat=True)) == {-1}


def test_once_the_draft_is_mended_the_last_attempt_is_forgotten(admin_client: Client) -> None:
    name = TopicName.objects.get(topic__key="Milk", language="it")
    name.delete()
    followed(admin_client)
    name.save()
    assert "The last attempt" not in page(admin_client)
    assert "is served to robots now" in followed(admin_client)


def test_a_draft_that_changed_since_the_page_was_shown_is_not_published(
    admin_client: Client,
) -> None:
    shown = str(draft_version())
    warm_milk()
    response = send(admin_client, draft=shown)
    assert response.status_code == 409
    assert "the draft has changed meanwhile" in response.content.decode()
    assert not PublishRun.objects.exists()


def test_a_draft_that_changes_between_is_not_published() -> None:
    run = begin(None, "", draft_version())
    warm_milk()
    assert carry_out(run).step == "changed"
    assert not Publication.objects.exists()


def test_new_sentences_whose_slots_somebody_else_gave_stop_it() -> None:
    class Other(publishing.Watch):
        def step(self, name: str) -> None:
            if name == "storing":
                Frame.objects.filter(key="GreenTea.c1").update(slot=9)

    with pytest.raises(DraftChangedError):
        publish(watch=Other())
    assert not Publication.objects.exists()


@pytest.mark.parametrize("draft", ["", "x", "-1", "9" * 40, "\0"])
def test_a_strange_version_is_refused(draft: str, admin_client: Client) -> None:
    assert send(admin_client, draft=draft).status_code == 409


def test_a_note_that_is_too_long_is_refused_in_words(admin_client: Client) -> None:
    response = send(admin_client, note="tea " * 100)
    assert response.status_code == 400
    assert "write at most 300 letters" in response.content.decode()
    assert not Publication.objects.exists()


def test_a_note_with_tags_is_shown_as_text(admin_client: Client) -> None:
    text = followed(admin_client, note="<script>alert(1)</script>")
    assert "&lt;script&gt;alert(1)" in text
    assert "<script>alert" not in text


def test_what_goes_wrong_unforeseen_is_told_and_changes_nothing(
    admin_client: Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    def broken(*_arguments: object, **_more: object) -> None:
        raise MemoryError

    monkeypatch.setattr(publishing, "pack", broken)
    assert "something unforeseen went wrong" in followed(admin_client)
    assert publish_run.running() is None
    assert not Publication.objects.exists()
