"""Publishing one at a time, saved conversations first, and who may."""

from datetime import timedelta

import pytest
from django.contrib.auth.models import User
from django.test import Client
from django.urls import reverse
from django.utils import timezone

from authoring.models import PublishRun
from authoring.pages import publish as page_module
from authoring.releases import publish_run
from authoring.releases.publish_run import BusyError, begin, carry_out
from authoring.releases.regressions import Failing
from dialogue import publishing
from dialogue.draft import draft_version
from dialogue.models import Publication
from ontology_io.files.folder import Folder
from tests.authoring.people import logged_in
from tests.authoring.publishing_pages import JSON, followed, page, run_now, send, warm_milk

pytestmark = pytest.mark.usefixtures("small_draft")


def test_the_second_is_told_who_is_publishing(admin_client: Client) -> None:
    maria = User.objects.create_user("maria", first_name="Maria", last_name="Rossi")
    begin(maria.pk, "", draft_version())
    response = send(admin_client)
    assert response.status_code == 409
    assert "Maria Rossi is publishing right now." in response.content.decode()
    data = {"draft": str(draft_version())}
    response = admin_client.post(reverse("admin:publish"), data, headers=JSON)
    assert response.json()["trouble"].startswith("Maria Rossi is publishing")
    assert "maria is publishing, since" in page(admin_client)


def test_after_one_has_ended_the_next_may_begin() -> None:
    run_now()
    warm_milk()
    assert run_now().step == "done"
    assert PublishRun.objects.filter(running=None).count() == 2


def test_a_run_whose_worker_is_gone_does_not_block_for_ever(admin_client: Client) -> None:
    lost = begin(None, "", draft_version())
    with pytest.raises(BusyError):
        begin(None, "", draft_version())
    PublishRun.objects.update(beat=timezone.now() - timedelta(minutes=10))
    status = reverse("admin:publish_status", args=[lost.pk])
    assert admin_client.get(status).json()["running"] is False
    assert run_now().step == "done"
    lost.refresh_from_db()
    assert (lost.step, lost.running) == ("lost", None)


def test_a_run_that_was_given_up_does_not_publish_any_more() -> None:
    lost = begin(None, "", draft_version())
    PublishRun.objects.update(beat=timezone.now() - timedelta(minutes=10))
    other = begin(None, "", draft_version())
    carry_out(lost)
    assert not Publication.objects.exists()
    other.refresh_from_db()
    assert other.running is True


def failing(*numbers: int) -> list[Failing]:
    return [Failing(number, f"Talk {number}", "another topic") for number in numbers]


def test_conversations_that_go_another_way_must_be_seen_first(
    admin_client: Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(publish_run, "failing_conversations", lambda _content: failing(3, 4))
    text = followed(admin_client, note="Tea")
    assert "Not published yet: saved conversations go another way now." in text
    assert "Talk 3" in text
    assert 'name="conversation" value="4"' in text
    assert not Publication.objects.exists()
    assert "Not published yet" in followed(admin_client, conversation="3", seen="1")
    both = {"conversation": ["3", "4"], "draft": str(draft_version())}
    response = admin_client.post(reverse("admin:publish"), both, follow=True)
    assert "Not published yet" in response.content.decode()
    response = admin_client.post(reverse("admin:publish"), {**both, "seen": "1"}, follow=True)
    assert "is served to robots now" in response.content.decode()


def test_conversations_that_hold_need_no_tick(admin_client: Client) -> None:
    assert 'name="seen"' not in page(admin_client)


@pytest.mark.parametrize("role", ["author", "researcher"])
def test_authors_and_researchers_look_only(role: str, small_draft: Folder) -> None:
    client = logged_in(role)
    text = page(client)
    assert "Publishing is for publishers" in text
    assert "publish-form" not in text
    assert send(client).status_code == 403
    assert not Publication.objects.exists()


@pytest.mark.parametrize("role", ["publisher", "administrator"])
def test_publishers_publish(role: str, small_draft: Folder) -> None:
    assert "is served to robots now" in followed(logged_in(role))


def test_nobody_else_sees_anything(small_draft: Folder) -> None:
    run = run_now()
    for address in (
        reverse("admin:publish"),
        reverse("admin:publish_status", args=[run.pk]),
        reverse("admin:publish_result", args=[run.pk]),
    ):
        assert logged_in("", address).get(address).status_code == 403
        assert Client().get(address).status_code == 302


def test_the_form_needs_its_token(small_draft: Folder) -> None:
    client = Client(enforce_csrf_checks=True)
    client.force_login(User.objects.create_superuser("root"))
    assert send(client).status_code == 403


def test_an_unknown_run_is_not_found(admin_client: Client) -> None:
    for name in ("publish_status", "publish_result"):
        assert admin_client.get(reverse(f"admin:{name}", args=[77])).status_code == 404


def test_all_ends_are_worded() -> None:
    assert set(page_module.END_WORDS) == set(publish_run.ENDS)
    assert set(page_module.STEP_WORDS) == set(publishing.STEPS)
