"""People of each role, logged in."""

from django.contrib.auth.models import Group, User
from django.test import Client

PASSWORD = "x"


def person(role: str, name: str = "") -> User:
    """Return a member of staff with a role; without one for an empty role."""
    user = User.objects.create_user(name or role or "guest", password=PASSWORD, is_staff=True)
    if role:
        user.groups.add(Group.objects.get(name=role))
    return user


def logged_in(role: str, name: str = "") -> Client:
    """Return the browser of a new person with a role."""
    client = Client()
    client.force_login(person(role, name))
    return client
