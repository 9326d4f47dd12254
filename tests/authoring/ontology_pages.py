"""What the tests of the ontology's pages and API share."""

import gzip
from collections.abc import Iterator

import pytest
from django.core.files.uploadedfile import SimpleUploadedFile
from django.http import HttpResponse
from django.test import Client

from authoring.ontology import process
from ontology_io import import_runs
from ontology_io.exporting import export_draft
from ontology_io.models import ImportRun

PAGE = "/admin/ontology/"
FILE = "/admin/ontology/file/"
UPLOAD = "/admin/ontology/import/"
SERVED = "In Japan, visitors are often served green tea."
OFFERED = "In Japan, visitors are often offered green tea."


@pytest.fixture
def at_once(monkeypatch: pytest.MonkeyPatch) -> Iterator[list[int]]:
    """Run imports in the request instead of a process; return the numbers that were started."""
    started: list[int] = []

    def now(number: int, *options: str) -> None:
        started.append(number)
        run = ImportRun.objects.get(pk=number)
        import_runs.carry_out(run, apply="--apply" in options)

    monkeypatch.setattr(process, "start", now)
    return started


def body(answer: HttpResponse) -> bytes:
    """Return the bytes of a file that was sent in pieces."""
    assert answer.status_code == 200, answer.status_code
    data = b"".join(answer.streaming_content)  # type: ignore[attr-defined]
    return gzip.decompress(data) if answer.headers.get("Content-Encoding") == "gzip" else data


def exported(client: Client) -> bytes:
    """Return the draft as a file."""
    return body(client.get(FILE))


def edited(data: bytes, old: str, new: str) -> bytes:
    """Return a file with one text in the place of another one that is there."""
    assert old.encode() in data, old
    return data.replace(old.encode(), new.encode())


def runs() -> list[str]:
    """Return the steps at which the imports are, the newest first."""
    return list(ImportRun.objects.values_list("step", flat=True))


def tea() -> bytes:
    """Return the draft as a file with one sentence changed."""
    return edited(b"".join(export_draft()), SERVED, OFFERED)


def without_flowers(data: bytes) -> bytes:
    """Return the file of the small draft without the topic Flower and its individuals."""
    start = data.index(b'<owl:Class rdf:about="urn:cair:kb#Flower">')
    return data[:start] + data[data.index(b"<!-- Pools -->") :]


def brought(
    client: Client, data: bytes, name: str = "tea.owl", follow: bool = True, **more: str
) -> HttpResponse:
    """Upload a file as the form does; return the page that is shown then."""
    file = SimpleUploadedFile(name, data, "application/rdf+xml")
    return client.post(UPLOAD, {"file": file, **more}, follow=follow)


def said(answer: HttpResponse) -> str:
    """Return a page as text with its blanks made one."""
    return " ".join(answer.content.decode().split())


def pressed(client: Client, shown: HttpResponse, button: str, **data: str) -> HttpResponse:
    """Press a button of the page of an import: apply or discard."""
    return client.post(f"{UPLOAD}{shown.context['run'].number}/{button}/", data, follow=True)
