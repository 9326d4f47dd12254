"""The draft that these tests write, users of each role, and passwords made quickly."""

from collections.abc import Iterator

import pytest
from django.utils import translation
from pytest_django.fixtures import Settings

from tests.authoring.intent_forms import nothing_kept
from tests.ontology.drafts import empty_draft, small_draft, small_folder

__all__ = ["empty_draft", "nothing_kept", "small_draft", "small_folder"]


@pytest.fixture(autouse=True)
def _quick_passwords(settings: Settings) -> None:
    """Spare each test the second that a safe password takes."""
    settings.PASSWORD_HASHERS = ["django.contrib.auth.hashers.MD5PasswordHasher"]


@pytest.fixture(autouse=True)
def _own_language_again() -> Iterator[None]:
    """Forget the language of the last page: a request leaves it to whatever runs next."""
    yield
    translation.deactivate()
