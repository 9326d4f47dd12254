"""The version of the draft grows with every change of what experts write."""

import pytest

from dialogue.draft import draft_version
from dialogue.models import Publication, Topic
from plans.models import Intent

pytestmark = pytest.mark.django_db


def test_a_saved_row_and_a_deleted_one_are_changes() -> None:
    before = draft_version()
    topic = Topic.objects.create(key="Tea")
    saved = draft_version()
    topic.delete()
    assert before < saved < draft_version()


def test_what_is_lent_is_a_change() -> None:
    tea, milk = Topic.objects.create(key="Tea"), Topic.objects.create(key="Milk")
    before = draft_version()
    tea.also.add(milk)
    assert draft_version() > before


def test_an_intent_is_part_of_the_draft() -> None:
    before = draft_version()
    Intent.objects.create(key="wave")
    assert draft_version() > before


def test_publishing_is_no_change() -> None:
    before = draft_version()
    Publication.objects.create(checksum="0", data=b"")
    assert draft_version() == before
