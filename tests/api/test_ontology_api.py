"""The ontology over REST: always with a key, out in pieces, in by an import that runs apart."""

import gzip

import pytest
import yaml
from django.test import Client
from pytest_django.fixtures import Settings

from authoring.ontology import process
from authoring.roles import ADMINISTRATOR
from dialogue.models import Sentence, Topic
from dialogue.publishing import publish
from ontology_io.models import ImportRun
from tests.api.ontology_calls import ADDRESS, OWL, alone, draft, reader, send, writer
from tests.api.test_errors import code_of
from tests.authoring.conftest import empty_draft, small_draft, small_folder
from tests.authoring.ontology_pages import OFFERED, SERVED, at_once, body, edited, without_flowers
from tests.authoring.people import logged_in

__all__ = ["alone", "at_once", "empty_draft", "reader", "small_draft", "small_folder", "writer"]
pytestmark = pytest.mark.usefixtures("small_draft")


def ended(client: Client, key: dict[str, str], data: bytes, query: str = "") -> dict[str, object]:
    """Return what is told of an import that has ended."""
    answer = send(client, key, data, query)
    assert answer.status_code == 202, answer.content
    assert answer.headers["Location"] == answer.json()["address"]
    told = client.get(answer.json()["address"], headers=key)
    assert told.status_code == 200
    assert told.json()["ended"] is True
    return dict(told.json())


# Out.


def test_the_draft_comes_as_rdf(client: Client, reader: dict[str, str]) -> None:
    answer = client.get(ADDRESS, headers=reader)
    assert answer.headers["Content-Type"] == OWL
    assert SERVED.encode() in body(answer)
    assert draft(client, reader) == draft(client, reader)


def test_it_comes_as_a_gzip_file_where_asked(client: Client, reader: dict[str, str]) -> None:
    answer = client.get(f"{ADDRESS}?gzip=1", headers=reader)
    assert answer.headers["Content-Type"] == "application/gzip"
    assert gzip.decompress(body(answer)) == draft(client, reader)


def test_a_release_comes_as_it_was_published(client: Client, reader: dict[str, str]) -> None:
    row = publish()
    Sentence.objects.filter(text=SERVED).update(text=OFFERED)
    answer = client.get(f"{ADDRESS}?release={row.pk}", headers=reader)
    assert SERVED.encode() in body(answer)
    assert OFFERED.encode() in draft(client, reader)


@pytest.mark.parametrize("release", ["99", "0", "x", "-1", "9" * 30, "²", "1;drop"])
def test_an_unknown_release_is_told(release: str, client: Client, reader: dict[str, str]) -> None:
    answer = client.get(ADDRESS, {"release": release}, headers=reader)
    assert code_of(answer) == "release.unknown"


def test_a_damaged_release_is_told(client: Client, reader: dict[str, str]) -> None:
    row = publish()
    row.data = b"CAIR"
    row.save()
    answer = client.get(ADDRESS, {"release": row.pk}, headers=reader)
    assert code_of(answer) == "release.damaged"


# In.


def test_the_own_export_changes_nothing(
    client: Client, writer: dict[str, str], at_once: list[int]
) -> None:
    told = ended(client, writer, draft(client, writer))
    assert (told["step"], told["applied"], told["differences"]) == ("ready", False, {})


def test_an_edit_is_told_and_not_written(
    client: Client, writer: dict[str, str], at_once: list[int]
) -> None:
    told = ended(client, writer, edited(draft(client, writer), SERVED, OFFERED))
    assert told["step"] == "ready"
    assert told["differences"] == {"sentences": {"changed": 1}}
    assert (told["problems"], told["changes_total"]) == ([], 1)
    assert told["changes"] == [
        {
            "kind": "sentences",
            "what": "changed",
            "key": "GreenTea.c1",
            "details": [f"texts en: {SERVED} → {OFFERED}"],
        }
    ]
    assert Sentence.objects.filter(text=SERVED).exists()


def test_an_edit_is_written_where_asked(
    client: Client, writer: dict[str, str], at_once: list[int]
) -> None:
    told = ended(client, writer, edited(draft(client, writer), SERVED, OFFERED), "?apply=true")
    assert (told["step"], told["applied"]) == ("done", True)
    assert Sentence.objects.filter(text=OFFERED).exists()
    again = ended(client, writer, draft(client, writer))
    assert again["differences"] == {}


def test_a_gzipped_file_is_taken(
    client: Client, writer: dict[str, str], at_once: list[int]
) -> None:
    data = gzip.compress(edited(draft(client, writer), SERVED, OFFERED))
    told = ended(client, writer, data)
    assert told["differences"] == {"sentences": {"changed": 1}}


def test_what_the_file_lacks_goes_unless_it_is_kept(
    client: Client, writer: dict[str, str], at_once: list[int]
) -> None:
    data = without_flowers(draft(client, writer))
    assert ended(client, writer, data, "?keep=true&apply=1")["differences"] == {}
    assert Topic.objects.filter(key="Flower").exists()
    told = ended(client, writer, data, "?apply=1")
    assert told["differences"] == {"topics": {"removed": 1}}
    assert not Topic.objects.filter(key="Flower").exists()


def test_a_wrong_file_is_refused_with_its_problems(
    client: Client, writer: dict[str, str], at_once: list[int]
) -> None:
    data = edited(draft(client, writer), 'decimal">0.4<', 'decimal">1.7<')
    told = ended(client, writer, data, "?apply=true")
    assert (told["step"], told["applied"]) == ("refused", False)
    problems = told["problems"]
    assert isinstance(problems, list)
    assert set(problems[0]) == {"error", "where", "text", "hint"}
    assert problems[0]["error"] is True
    assert "EN_GREENTEA" in problems[0]["where"]


@pytest.mark.parametrize("data", [b"no", b"\x00" * 100, b"<a/>"])
def test_a_hostile_body_ends_refused(
    data: bytes, client: Client, writer: dict[str, str], at_once: list[int]
) -> None:
    assert ended(client, writer, data, "?apply=1")["step"] == "refused"


@pytest.mark.parametrize("data", [b"\x1f\x8b\x08 cut", gzip.compress(b" " * 2_000_000)])
def test_a_damaged_or_too_large_gzip_file_is_refused(
    data: bytes, client: Client, writer: dict[str, str], settings: Settings
) -> None:
    settings.CAIR_LONGEST_ONTOLOGY = 1_000_000
    assert code_of(send(client, writer, data)) == "ontology.damaged"


def test_an_empty_body_is_refused(client: Client, writer: dict[str, str]) -> None:
    assert code_of(send(client, writer, b"")) == "ontology.no_file"


@pytest.mark.parametrize(
    "kind", ["application/x-www-form-urlencoded", "multipart/form-data; boundary=x"]
)
def test_a_form_is_refused_for_curl_spoils_files_in_it(
    kind: str, client: Client, writer: dict[str, str]
) -> None:
    assert code_of(send(client, writer, b"<rdf/>", kind=kind)) == "ontology.no_file"


def test_a_body_over_the_limit_is_refused(
    client: Client, writer: dict[str, str], settings: Settings
) -> None:
    settings.CAIR_LONGEST_ONTOLOGY = 1000
    assert code_of(send(client, writer, b"x" * 1001)) == "body.too_large"
    answer = client.generic("POST", ADDRESS, b"x", OWL, CONTENT_LENGTH="9" * 30, headers=writer)
    assert code_of(answer) == "body.too_large"
    assert not ImportRun.objects.exists()


def test_a_body_longer_than_a_turns_is_taken(
    client: Client,
    writer: dict[str, str],
    settings: Settings,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(process, "start", lambda *_more: None)
    settings.CAIR_LONGEST_BODY = 1000
    settings.DATA_UPLOAD_MAX_MEMORY_SIZE = 1000
    assert send(client, writer, b"x" * 5000).status_code == 202


def test_a_second_import_waits(
    client: Client, writer: dict[str, str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(process, "start", lambda *_more: None)
    answer = send(client, writer, b"<rdf/>")
    told = client.get(answer.json()["address"], headers=writer).json()
    assert (told["step"], told["ended"]) == ("waiting", False)
    assert code_of(send(client, writer, b"<rdf/>")) == "ontology.busy"


@pytest.mark.parametrize("number", ["1", "0", "999999999"])
def test_an_unknown_import_is_told(number: str, client: Client, reader: dict[str, str]) -> None:
    answer = client.get(f"{ADDRESS}imports/{number}/", headers=reader)
    assert code_of(answer) == "ontology.unknown_import"


@pytest.mark.parametrize("number", ["x", "-1", "9" * 30])
def test_nonsense_for_an_import_is_no_address(
    number: str, client: Client, reader: dict[str, str]
) -> None:
    assert code_of(client.get(f"{ADDRESS}imports/{number}/", headers=reader)) == "not_found"


def test_it_can_be_seen_who_brought_it(
    client: Client, writer: dict[str, str], at_once: list[int]
) -> None:
    ended(client, writer, edited(draft(client, writer), SERVED, OFFERED), "?apply=1")
    admin = logged_in(ADMINISTRATOR)
    assert "notebook of Rita" in admin.get("/admin/ontology/").content.decode()
    assert "notebook of Rita" in admin.get("/admin/audit/").content.decode()


def test_the_schema_names_the_calls(client: Client) -> None:
    paths = yaml.safe_load(client.get("/api/schema/").content)["paths"]
    assert set(paths[ADDRESS]) == {"get", "post"}
    assert set(paths[f"{ADDRESS}imports/{{number}}/"]) == {"get"}
    assert OWL in paths[ADDRESS]["post"]["requestBody"]["content"]
