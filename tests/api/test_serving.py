"""Serving: the last good publication goes on being served, whatever happens to the database."""

from collections.abc import Iterator

import pytest
from django.db import DatabaseError
from pytest_django.fixtures import Settings

from dialogue import publishing
from dialogue.engine.content import Content
from dialogue.models import Publication
from dialogue.publishing import NothingPublishedError
from dialogue.snapshot import SnapshotError, checksum


@pytest.fixture
def alone() -> Iterator[None]:
    """Begin without content and without the watching thread, as a new worker does."""
    watcher, publishing._served.watcher = publishing._served.watcher, None
    publishing.serve(None)
    yield
    publishing.serve(None)
    publishing._served.watcher = watcher


@pytest.mark.django_db
@pytest.mark.parametrize(
    "trouble", [DatabaseError("gone"), SnapshotError("damaged"), KeyError("x"), LookupError("x")]
)
def test_the_watch_outlives_every_trouble(
    monkeypatch: pytest.MonkeyPatch, settings: Settings, trouble: Exception
) -> None:
    looks: list[int] = []

    def refresh() -> None:
        looks.append(1)
        if len(looks) == 3:
            raise SystemExit
        raise trouble

    monkeypatch.setattr(publishing, "refresh", refresh)
    settings.CAIR_POLL_SECONDS = 0.01
    with pytest.raises(SystemExit):
        publishing._watch()
    assert len(looks) == 3


@pytest.mark.usefixtures("alone")
@pytest.mark.parametrize("trouble", [DatabaseError("no such table"), SnapshotError("damaged")])
def test_a_database_that_cannot_be_read_is_nothing_published(
    monkeypatch: pytest.MonkeyPatch, trouble: Exception
) -> None:
    def load() -> None:
        raise trouble

    monkeypatch.setattr(publishing, "load", load)
    with pytest.raises(NothingPublishedError):
        publishing.current()


@pytest.mark.django_db
def test_a_damaged_publication_is_not_taken_over(published: Content) -> None:
    Publication.objects.create(pk=2, checksum="0" * 64, counts={}, data=b"CAIR\x01damaged")
    with pytest.raises(SnapshotError):
        publishing.refresh()
    assert publishing.current() is published


@pytest.mark.django_db
def test_a_publication_of_another_format_is_not_taken_over(published: Content) -> None:
    data = b"CAIR\x63" + bytes(20)
    Publication.objects.create(pk=2, checksum=checksum(data), counts={}, data=data)
    with pytest.raises(SnapshotError, match="format"):
        publishing.refresh()
    assert publishing.current() is published


@pytest.mark.django_db
def test_an_empty_database_takes_nothing_away(published: Content) -> None:
    assert not publishing.refresh()
    assert publishing.current() is published
