"""The page of the ontology: out as a file, in again with every change seen first."""

import gzip

import pytest
from django.test import Client
from pytest_django import DjangoAssertNumQueries
from pytest_django.fixtures import Settings

from authoring.pages.ontology import plain_name
from authoring.roles import PUBLISHER, RESEARCHER
from dialogue.draft import draft_version
from dialogue.models import Sentence, Topic, TopicInstance
from dialogue.publishing import publish
from tests.authoring.ontology_pages import (
    FILE,
    OFFERED,
    PAGE,
    SERVED,
    UPLOAD,
    at_once,
    body,
    brought,
    edited,
    exported,
    pressed,
    runs,
    said,
    tea,
    without_flowers,
)
from tests.authoring.people import logged_in, person

__all__ = ["at_once"]
pytestmark = pytest.mark.usefixtures("small_draft")


@pytest.fixture
def publisher() -> Client:
    return logged_in(PUBLISHER)


# Out.


def test_a_researcher_takes_the_draft_out() -> None:
    client = logged_in(RESEARCHER)
    assert "Download .owl" in said(client.get(PAGE))
    answer = client.get(FILE)
    assert answer.headers["Content-Type"] == "application/rdf+xml"
    assert answer.headers["Content-Disposition"].startswith('attachment; filename="cair-draft-')
    data = body(answer)
    assert data.startswith(b"<?xml")
    assert SERVED.encode() in data
    assert data == exported(client)


def test_a_plain_file_travels_compressed_where_the_browser_takes_it() -> None:
    client = logged_in(RESEARCHER)
    answer = client.get(FILE, headers={"Accept-Encoding": "gzip, br"})
    assert answer.headers["Content-Encoding"] == "gzip"
    assert answer.headers["Content-Disposition"].endswith('.owl"')
    assert body(answer) == exported(client)


def test_a_compressed_file_is_the_same_file() -> None:
    client = logged_in(RESEARCHER)
    answer = client.get(FILE, {"form": "gz"}, headers={"Accept-Encoding": "gzip"})
    assert answer.headers["Content-Type"] == "application/gzip"
    assert "Content-Encoding" not in answer.headers
    assert answer.headers["Content-Disposition"].endswith('.owl.gz"')
    assert gzip.decompress(body(answer)) == exported(client)


def test_a_release_is_taken_out_as_it_was_published() -> None:
    client = logged_in(RESEARCHER)
    row = publish()
    before = body(client.get(FILE, {"release": str(row.pk)}))
    Sentence.objects.filter(text=SERVED).update(text=OFFERED)
    answer = client.get(FILE, {"release": str(row.pk)})
    assert f"cair-release-{row.pk}.owl" in answer.headers["Content-Disposition"]
    assert body(answer) == before
    assert SERVED.encode() in before
    assert f"Release {row.pk}" in said(client.get(PAGE))


def test_a_damaged_release_is_told() -> None:
    row = publish()
    row.data = bytes(row.data)[:-1] + b"!"
    row.save()
    answer = logged_in(RESEARCHER).get(FILE, {"release": str(row.pk)})
    assert answer.status_code == 400
    assert "This release is damaged" in said(answer)


@pytest.mark.parametrize("release", ["0", "99", "-1", "x", "1.0", "²", "9" * 30, "1 or 1=1"])
def test_there_is_nothing_at_a_release_that_is_not_there(release: str) -> None:
    assert logged_in(RESEARCHER).get(FILE, {"release": release}).status_code == 404


def test_the_page_asks_the_database_little(
    publisher: Client, django_assert_max_num_queries: DjangoAssertNumQueries
) -> None:
    publish()
    publisher.get(PAGE)
    with django_assert_max_num_queries(25):
        publisher.get(PAGE)


# In.


def test_the_own_export_changes_nothing(publisher: Client, at_once: list[int]) -> None:
    shown = brought(publisher, exported(publisher))
    assert len(at_once) == 1
    assert "0 changes" in said(shown)
    assert "Bring this into the draft" not in said(shown)


def test_an_edit_appears_as_exactly_that_edit_and_is_written_only_when_asked(
    publisher: Client, at_once: list[int]
) -> None:
    shown = brought(publisher, tea())
    text = said(shown)
    assert shown.context["total"] == 1
    assert "1 sentence changed" in text
    assert "<del>served</del><ins>offered</ins>" in text
    assert Sentence.objects.filter(text=SERVED).exists()
    after = pressed(publisher, shown, "apply")
    assert "It is in the draft." in said(after)
    assert '<a href="/admin/publish/">' in said(after)
    assert list(Sentence.objects.filter(language="en", text=OFFERED).values_list("pk")) != []
    assert not Sentence.objects.filter(text=SERVED).exists()


def test_what_is_brought_in_is_told_in_the_history(publisher: Client, at_once: list[int]) -> None:
    pressed(publisher, brought(publisher, tea(), "green tea.owl"), "apply")
    text = said(publisher.get("/admin/audit/"))
    assert "green tea.owl" in text
    assert "publisher" in text


def test_a_compressed_file_is_taken_too(publisher: Client, at_once: list[int]) -> None:
    shown = brought(publisher, gzip.compress(tea()), "tea.owl.gz")
    assert "1 sentence changed" in said(shown)


def test_removing_many_topics_wants_a_tick(publisher: Client, at_once: list[int]) -> None:
    shown = brought(publisher, without_flowers(exported(publisher)))
    text = said(shown)
    assert "1 topic of 5 would be removed" in text
    assert "<code>Flower</code>" in text
    refused = pressed(publisher, shown, "apply")
    assert "Tick the box first" in said(refused)
    assert Topic.objects.filter(key="Flower").exists()
    assert "It is in the draft." in said(pressed(publisher, shown, "apply", removing="1"))
    assert not Topic.objects.filter(key="Flower").exists()


def test_with_the_tick_what_the_file_lacks_is_kept(publisher: Client, at_once: list[int]) -> None:
    shown = brought(publisher, without_flowers(exported(publisher)), keep="1")
    assert "0 changes" in said(shown)
    assert "what the file does not hold is kept" in said(shown)


def test_what_is_wrong_with_a_file_is_told_and_nothing_written(
    publisher: Client, at_once: list[int]
) -> None:
    wrong = edited(tea(), 'decimal">0.4<', 'decimal">1.7<')
    shown = brought(publisher, wrong)
    text = said(shown)
    assert "What is wrong with the file" in text
    assert "<code>EN_GREENTEA" in text
    assert "Bring this into the draft" not in text
    pressed(publisher, shown, "apply")
    assert Sentence.objects.filter(text=SERVED).exists()
    assert TopicInstance.objects.get(topic__key="GreenTea", culture__code="EN").likeliness < 1


@pytest.mark.parametrize(
    "data",
    [
        b"not an ontology",
        b"<html></html>",
        b"\x00\xff\xfe" * 50,
        b"@prefix : <urn:x#> .\n:Tea a :Topic .\n",
        b'<!DOCTYPE x [<!ENTITY a SYSTEM "file:///etc/passwd">]><x>&a;</x>',
        b"PK\x03\x04 a spreadsheet",
    ],
)
def test_a_hostile_file_is_refused_in_words(
    data: bytes, publisher: Client, at_once: list[int]
) -> None:
    before = draft_version()
    shown = brought(publisher, data)
    assert shown.status_code == 200
    assert shown.context["errors"], said(shown)[-500:]
    assert "root:" not in said(shown)
    assert (runs(), draft_version()) == (["refused"], before)


@pytest.mark.parametrize("cut", [3, 20, 200])
def test_a_damaged_compressed_file_is_refused_at_once(cut: int, publisher: Client) -> None:
    answer = brought(publisher, gzip.compress(tea())[:cut], "tea.owl.gz")
    assert answer.status_code == 400
    assert "Compress it again." in said(answer)
    assert not runs()


def test_a_gzip_bomb_is_refused(publisher: Client, settings: Settings) -> None:
    settings.CAIR_LONGEST_ONTOLOGY = 1_000_000
    answer = brought(publisher, gzip.compress(b" " * 3_000_000), "bomb.gz")
    assert "larger than 1 MB" in said(answer)
    assert not runs()


@pytest.mark.parametrize(
    ("name", "shown"),
    [
        ("../../etc/passwd", "passwd"),
        ("C:\\tea\\drinks.owl", "drinks.owl"),
        ("<script>alert(1)</script>.owl", "script>.owl"),
        ("te\u0000a\u202e.owl", "tea.owl"),
        ("", "a file"),
        ("x" * 500 + ".owl", "x" * 96 + ".owl"),
    ],
)
def test_of_a_hostile_name_a_plain_one_is_left(name: str, shown: str) -> None:
    assert plain_name(name) == shown


def test_a_name_with_tags_is_shown_as_text(publisher: Client, at_once: list[int]) -> None:
    page = said(brought(publisher, tea(), "<img src=x>.owl"))
    assert "&lt;img src=x&gt;.owl" in page
    assert "<img src=x>" not in page


def test_a_file_that_is_too_large_is_refused_before_it_is_read(
    publisher: Client, settings: Settings, monkeypatch: pytest.MonkeyPatch
) -> None:
    settings.CAIR_LONGEST_ONTOLOGY = 5_000_000

    def read(*_more: object) -> None:
        raise AssertionError

    monkeypatch.setattr("django.http.HttpRequest._load_post_and_files", read)
    answer = publisher.post(UPLOAD, b"x", "application/octet-stream", CONTENT_LENGTH="5020000")
    assert answer.status_code == 413
    assert "The file has more than 5 MB." in said(answer)


def test_a_file_just_over_the_limit_is_refused(publisher: Client, settings: Settings) -> None:
    settings.CAIR_LONGEST_ONTOLOGY = 5_000
    answer = brought(publisher, b"x" * 5_001)
    assert answer.status_code == 413
    assert not runs()


@pytest.mark.parametrize("data", [{}, {"file": "text"}, {"keep": "1"}])
def test_without_a_file_one_is_asked_for(publisher: Client, data: dict[str, str]) -> None:
    answer = publisher.post(UPLOAD, data)
    assert answer.status_code == 400
    assert "Choose a file first." in said(answer)


def test_an_empty_file_is_refused(publisher: Client) -> None:
    assert "The file is empty." in said(brought(publisher, b""))


def test_the_upload_wants_the_token_of_the_form() -> None:
    client = Client(enforce_csrf_checks=True)
    client.force_login(person(PUBLISHER))
    assert brought(client, b"x").status_code == 403
    page = client.get(PAGE)
    token = page.context["csrf_token"]
    assert brought(client, b"", csrfmiddlewaretoken=str(token)).status_code == 400
    for button in ("apply", "discard"):
        assert client.post(f"{UPLOAD}1/{button}/").status_code == 403
