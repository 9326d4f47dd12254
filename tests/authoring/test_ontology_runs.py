"""An import of an ontology: one at a time, watched, decided once, by those who may."""

import subprocess
import sys
from datetime import timedelta

import pytest
from django.contrib.auth.models import Permission, User
from django.db import connection
from django.test import Client
from django.test.utils import CaptureQueriesContext
from django.utils import timezone

from authoring.ontology import process
from authoring.roles import ADMINISTRATOR, AUTHOR, PUBLISHER, RESEARCHER
from dialogue.draft import draft_version
from dialogue.models import Sentence, TopicInstance
from ontology_io import import_runs
from ontology_io.models import ImportRun
from tests.authoring.ontology_pages import (
    FILE,
    PAGE,
    SERVED,
    UPLOAD,
    at_once,
    brought,
    pressed,
    runs,
    said,
    tea,
)
from tests.authoring.people import logged_in

__all__ = ["at_once"]
pytestmark = pytest.mark.usefixtures("small_draft")


@pytest.fixture
def publisher() -> Client:
    return logged_in(PUBLISHER)


# How it goes on.


def test_while_it_goes_on_the_page_shows_the_steps(
    publisher: Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(process, "start", lambda *_more: None)
    shown = brought(publisher, tea())
    number = shown.context["run"].number
    assert "Waiting for its turn" in said(shown)
    status = publisher.get(f"{UPLOAD}{number}/status/").json()
    assert status == {
        "running": True,
        "step": "waiting",
        "place": 0,
        "words": "Waiting for its turn",
    }
    ImportRun.objects.update(step="comparing")
    assert publisher.get(f"{UPLOAD}{number}/status/").json()["place"] == 3
    assert "Look again" in said(publisher.get(f"{UPLOAD}{number}/"))


def test_while_it_is_written_the_page_shows_that(
    publisher: Client, monkeypatch: pytest.MonkeyPatch, at_once: list[int]
) -> None:
    shown = brought(publisher, tea())
    monkeypatch.setattr(process, "start", lambda *_more: None)
    page = pressed(publisher, shown, "apply")
    assert "Waiting for its turn" in said(page)
    assert "It is being written" in said(page)
    address = f"{UPLOAD}{page.context['run'].number}/"
    ImportRun.objects.update(step="writing")
    assert publisher.get(f"{address}status/").json()["place"] == 1
    assert "Stop it" not in said(publisher.get(address))
    refused = pressed(publisher, shown, "discard")
    assert "Writing it into the draft" in said(refused)


def test_a_second_import_is_told_who_is_at_it(
    publisher: Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(process, "start", lambda *_more: None)
    brought(publisher, tea())
    other = logged_in(ADMINISTRATOR)
    answer = brought(other, b"<rdf/>")
    assert answer.status_code == 409
    assert "publisher is bringing in an ontology, since" in said(answer)
    assert "publisher is bringing in an ontology, since" in said(other.get(PAGE))


def test_an_import_whose_process_is_gone_is_told_and_blocks_nobody(
    publisher: Client, monkeypatch: pytest.MonkeyPatch, at_once: list[int]
) -> None:
    data = tea()
    with monkeypatch.context() as patch:
        patch.setattr(process, "start", lambda *_more: None)
        lost = brought(publisher, data).context["run"].number
    ImportRun.objects.update(beat=timezone.now() - timedelta(hours=1))
    assert "the server stopped in between" in said(publisher.get(f"{UPLOAD}{lost}/"))
    assert publisher.get(f"{UPLOAD}{lost}/status/").json()["running"] is False
    assert "1 sentence changed" in said(brought(publisher, data))


def test_a_process_that_is_killed_frees_the_way_at_once(publisher: Client) -> None:
    killed = subprocess.Popen([sys.executable, "-c", "import os; os.kill(os.getpid(), 9)"])
    number = import_runs.begin(None, "tea.owl", tea()).pk
    process.wait(killed, number)
    assert runs() == ["lost"]
    assert "the server stopped in between" in said(publisher.get(f"{UPLOAD}{number}/"))


def test_a_process_that_only_tells_of_errors_leaves_the_run_as_it_ended() -> None:
    number = import_runs.begin(None, "tea.owl", b"no").pk
    import_runs.carry_out(ImportRun.objects.get())
    process.wait(subprocess.Popen([sys.executable, "-c", "raise SystemExit(1)"]), number)
    assert runs() == ["refused"]


def test_where_no_process_can_be_started_it_is_told(
    publisher: Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    def none(*_more: object, **_options: object) -> None:
        raise OSError

    monkeypatch.setattr(subprocess, "Popen", none)
    assert "something unforeseen went wrong" in said(brought(publisher, tea()))
    assert runs() == ["failed"]


def test_one_that_waits_to_be_looked_at_blocks_nobody(
    publisher: Client, at_once: list[int]
) -> None:
    brought(publisher, tea())
    assert "1 sentence changed" in said(brought(logged_in(ADMINISTRATOR), tea()))


def test_after_the_draft_has_changed_nothing_is_written(
    publisher: Client, at_once: list[int]
) -> None:
    shown = brought(publisher, tea())
    row = TopicInstance.objects.get(topic__key="Tea", culture__code="EN")
    row.likeliness = "0.9"
    row.save()
    after = pressed(publisher, shown, "apply")
    assert "the draft has changed since the comparison" in said(after)
    assert Sentence.objects.filter(text=SERVED).exists()


def test_discarding_writes_nothing_and_is_final(publisher: Client, at_once: list[int]) -> None:
    shown = brought(publisher, tea())
    assert "Discarded: nothing was written." in said(pressed(publisher, shown, "discard"))
    assert "Discarded" in said(pressed(publisher, shown, "apply"))
    assert Sentence.objects.filter(text=SERVED).exists()
    assert ImportRun.objects.get().data == b""


def test_brought_in_twice_is_brought_in_once(publisher: Client, at_once: list[int]) -> None:
    shown = brought(publisher, tea())
    pressed(publisher, shown, "apply")
    version = draft_version()
    assert "It is in the draft." in said(pressed(publisher, shown, "apply"))
    assert draft_version() == version


def test_the_last_imports_are_listed(publisher: Client, at_once: list[int]) -> None:
    pressed(publisher, brought(publisher, tea(), "first.owl"), "apply")
    brought(publisher, b"no", "second.owl")
    text = said(logged_in(RESEARCHER).get(PAGE))
    assert text.index("second.owl") < text.index("has errors") < text.index("first.owl")
    assert "in the draft" in text


def test_the_page_of_an_import_asks_the_database_little(
    publisher: Client, at_once: list[int]
) -> None:
    shown = brought(publisher, tea())
    with CaptureQueriesContext(
        connection,
    ) as queries:
        publisher.get(f"{UPLOAD}{shown.context['run'].number}/")
    assert len(queries) <= 25


# Who may.


@pytest.mark.parametrize("role", [AUTHOR, RESEARCHER])
def test_authors_and_researchers_look_but_bring_nothing_in(
    role: str, publisher: Client, at_once: list[int]
) -> None:
    shown = brought(publisher, tea())
    client = logged_in(role)
    assert client.get(PAGE).status_code == 200
    assert "Show what changes" not in said(client.get(PAGE))
    page = client.get(f"{UPLOAD}{shown.context['run'].number}/")
    assert page.status_code == 200
    assert "Bring this into the draft" not in said(page)
    assert brought(client, b"x").status_code == 403
    for button in ("apply", "discard"):
        assert pressed(client, shown, button).status_code == 403
    assert Sentence.objects.filter(text=SERVED).exists()


@pytest.mark.parametrize("role", [PUBLISHER, ADMINISTRATOR])
def test_publishers_and_administrators_bring_it_in(role: str, at_once: list[int]) -> None:
    client = logged_in(role, "somebody")
    shown = brought(client, tea())
    assert "It is in the draft." in said(pressed(client, shown, "apply"))


def test_who_may_publish_but_not_write_brings_nothing_in() -> None:
    user = User.objects.create_user("only", is_staff=True)
    for name in ("publish_draft", "export_content"):
        user.user_permissions.add(Permission.objects.get(codename=name))
    client = Client()
    client.force_login(user)
    assert "Show what changes" not in said(client.get(PAGE))
    assert brought(client, b"x").status_code == 403


def test_nobody_gets_anything_without_logging_in(client: Client) -> None:
    for address in (PAGE, FILE, UPLOAD, f"{UPLOAD}1/", f"{UPLOAD}1/status/"):
        assert client.get(address).status_code == 302
    assert brought(client, b"x", follow=False).status_code == 302


@pytest.mark.parametrize("number", ["99", "0", "999999999999999999999"])
def test_there_is_nothing_at_an_import_that_is_not_there(publisher: Client, number: str) -> None:
    for tail in ("", "status/"):
        assert publisher.get(f"{UPLOAD}{number}/{tail}").status_code == 404
    assert publisher.post(f"{UPLOAD}{number}/apply/").status_code == 404
