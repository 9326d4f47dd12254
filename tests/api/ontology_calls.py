"""How the tests of the ontology's API call it, and with which keys."""

from collections.abc import Iterator

import pytest
from django.http import HttpResponse
from django.test import Client

from authoring import keys
from authoring.keys import make_key
from tests.authoring.ontology_pages import body

ADDRESS = "/api/v1/ontology/"
OWL = "application/rdf+xml"


@pytest.fixture(autouse=True)
def alone() -> Iterator[None]:
    keys.forget()
    yield
    keys.forget()


@pytest.fixture
def reader() -> dict[str, str]:
    return headers("read")


@pytest.fixture
def writer() -> dict[str, str]:
    return headers("write")


def headers(ontology: str) -> dict[str, str]:
    key = make_key("notebook of Rita", None, None, ontology)[1]
    keys.forget()
    return {"X-Api-Key": key}


def draft(client: Client, key: dict[str, str]) -> bytes:
    return body(client.get(ADDRESS, headers=key))


def send(
    client: Client, key: dict[str, str], data: bytes, query: str = "", kind: str = OWL
) -> HttpResponse:
    return client.post(f"{ADDRESS}{query}", data, content_type=kind, headers=key)
