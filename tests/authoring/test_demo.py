"""Users to look around with: one a role, passwords shown once, never where people are served."""

from io import StringIO

import pytest
from django.contrib.auth.models import User
from django.core.management import CommandError, call_command
from django.test import Client
from pytest_django.fixtures import Settings

from authoring.roles import ADMINISTRATOR, AUTHOR, PUBLISHER, RESEARCHER
from tests.authoring.people import PASSWORD, logged_in, person

pytestmark = pytest.mark.django_db
ROLES = (AUTHOR, PUBLISHER, RESEARCHER, ADMINISTRATOR)


def demo() -> str:
    out = StringIO()
    call_command("demo", stdout=out)
    return out.getvalue()


def passwords(told: str) -> dict[str, str]:
    lines = [line.split() for line in told.splitlines() if "password" in line]
    return {words[0].rstrip(":"): words[2] for words in lines}


def test_each_role_gets_a_user_who_can_log_in() -> None:
    given = passwords(demo())
    assert set(given) == set(ROLES)
    for role, password in given.items():
        client = Client()
        assert client.login(username=role, password=password)
        assert client.get("/admin/").status_code == 200
        assert [group.name for group in User.objects.get(username=role).groups.all()] == [role]


def test_passwords_are_never_the_same() -> None:
    first = passwords(demo())
    User.objects.all().delete()
    second = passwords(demo())
    assert len({*first.values(), *second.values()}) == 2 * len(ROLES)


def test_a_second_time_changes_nothing_and_shows_no_password() -> None:
    demo()
    before = list(User.objects.values())
    told = demo()
    assert passwords(told) == {}
    assert list(User.objects.values()) == before


def test_somebody_who_is_called_like_a_role_is_left_alone() -> None:
    User.objects.create_user("author", password=PASSWORD)
    demo()
    author = User.objects.get(username="author")
    assert author.check_password(PASSWORD)
    assert not author.is_staff


@pytest.mark.parametrize(
    ("name", "value"),
    [("CAIR_HTTPS", True), ("ALLOWED_HOSTS", ["cair.example"]), ("ALLOWED_HOSTS", ["*"])],
)
def test_a_server_for_people_gets_no_demo_users(
    name: str, value: object, settings: Settings
) -> None:
    setattr(settings, name, value)
    with pytest.raises(CommandError, match="serves people"):
        demo()
    assert not User.objects.exists()


def test_the_form_of_a_user_explains_the_roles() -> None:
    user = person(AUTHOR, "Maria")
    page = logged_in(ADMINISTRATOR).get(f"/admin/auth/user/{user.pk}/change/").content.decode()
    for words in ("writes topics, sentences and intents", "reads everything", "goes back to a"):
        assert words in page


def test_an_administrator_makes_nobody_mightier_than_any_role() -> None:
    user = person(AUTHOR, "Maria")
    client = logged_in(ADMINISTRATOR)
    data = {"username": "Maria", "is_superuser": "on", "is_active": "on", "first_name": "M"}
    assert client.post(f"/admin/auth/user/{user.pk}/change/", data).status_code == 302
    user.refresh_from_db()
    assert (user.first_name, user.is_superuser) == ("M", False)


def test_an_administrator_touches_no_superuser() -> None:
    root = User.objects.create_superuser("root", password=PASSWORD)
    client = logged_in(ADMINISTRATOR)
    for kind in ("change", "delete", "password"):
        answer = client.post(f"/admin/auth/user/{root.pk}/{kind}/", {"post": "yes"})
        assert answer.status_code == 403
    assert User.objects.filter(username="root").exists()
