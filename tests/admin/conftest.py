"""The draft that the tests of the admin write, and an administrator made quickly."""

import pytest
from pytest_django.fixtures import Settings

from tests.ontology.drafts import empty_draft, small_draft, small_folder

__all__ = ["empty_draft", "small_draft", "small_folder"]


@pytest.fixture(autouse=True)
def _quick_passwords(settings: Settings) -> None:
    """Spare each test the second that a safe password takes."""
    settings.PASSWORD_HASHERS = ["django.contrib.auth.hashers.MD5PasswordHasher"]
