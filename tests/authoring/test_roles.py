"""The roles and what they may do."""

import pytest
from django.contrib.auth.models import Group, Permission

from authoring.roles import ADMINISTRATOR, AUTHOR, PUBLISHER, RESEARCHER, write_roles


def may(role: str) -> set[str]:
    return set(Group.objects.get(name=role).permissions.values_list("codename", flat=True))


@pytest.mark.django_db
def test_the_roles_are_there_after_migrating() -> None:
    names = set(Group.objects.values_list("name", flat=True))
    assert names == {AUTHOR, PUBLISHER, RESEARCHER, ADMINISTRATOR}


@pytest.mark.django_db
def test_authors_write_and_publishers_publish() -> None:
    assert {"change_sentence", "add_topic", "delete_trigger"} <= may(AUTHOR)
    assert "publish_draft" not in may(AUTHOR)
    assert "publish_draft" in may(PUBLISHER)


@pytest.mark.django_db
def test_researchers_read_and_take_out() -> None:
    assert {one.partition("_")[0] for one in may(RESEARCHER)} == {"view", "export"}


@pytest.mark.django_db
def test_only_administrators_manage_users() -> None:
    assert [role for role in (AUTHOR, PUBLISHER, RESEARCHER) if "change_user" in may(role)] == []
    assert "change_user" in may(ADMINISTRATOR)


@pytest.mark.django_db
def test_nobody_changes_what_was_published() -> None:
    assert "change_publication" not in may(AUTHOR) | may(PUBLISHER)


@pytest.mark.django_db
def test_a_permission_taken_away_by_hand_comes_back() -> None:
    Group.objects.get(name=AUTHOR).permissions.remove(Permission.objects.get(codename="add_topic"))
    write_roles()
    assert "add_topic" in may(AUTHOR)
