"""What tests of the site share: the shipped content, loaded and built once."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from pytest_django import DjangoDbBlocker
from pytest_django.fixtures import Settings as SettingsWrapper

from dialogue import publishing
from dialogue.engine.content import Content, build_content
from ontology_io.files.folder import read_folder

CONTENT = Path(__file__).resolve().parent.parent / "content"


@pytest.fixture(autouse=True)
def _settings_of_tests(settings: SettingsWrapper) -> None:
    """Keep the thread that looks for newer publications quiet; need no collected static files."""
    settings.CAIR_POLL_SECONDS = 3600
    plain = {"BACKEND": "django.contrib.staticfiles.storage.StaticFilesStorage"}
    settings.STORAGES = {**settings.STORAGES, "staticfiles": plain}
    settings.STATIC_ROOT = str(CONTENT.parent / "static")


@pytest.fixture(scope="session")
def shipped() -> Content:
    """Return the shipped content as publication 1, built from its files."""
    base = read_folder(CONTENT).base
    return build_content(base.knowledge, base.library, 1)


@pytest.fixture
def published(shipped: Content, settings: SettingsWrapper) -> Iterator[Content]:
    """Serve the shipped content, without a database."""
    settings.CAIR_POLL_SECONDS = 3600
    publishing.serve(shipped)
    yield shipped
    publishing.serve(None)


@pytest.fixture(scope="session")
def loaded_database(django_db_setup: None, django_db_blocker: DjangoDbBlocker) -> None:
    """Load the shipped content into the test database, once for all tests that name it."""
    from ontology_io.store import write_base

    folder = read_folder(CONTENT)
    with django_db_blocker.unblock():
        write_base(folder.base, folder.last)
