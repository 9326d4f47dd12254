"""demo: one user a role, to look around; never where people are served."""

import secrets

from django.conf import settings
from django.contrib.auth import get_user_model
from django.contrib.auth.models import Group
from django.core.management.base import BaseCommand, CommandError
from django.db import transaction

from authoring.roles import ADMINISTRATOR, AUTHOR, PUBLISHER, RESEARCHER

ROLES = (AUTHOR, PUBLISHER, RESEARCHER, ADMINISTRATOR)
#: The names by which a server is called that serves nobody but its own machine.
HERE = frozenset(("localhost", "127.0.0.1", "[::1]", "::1", "testserver"))


def why_not() -> str:
    """Return why there must be no demo users here; empty where there may."""
    if settings.CAIR_HTTPS:
        return "CAIR_HTTPS is on"
    elsewhere = sorted(set(settings.ALLOWED_HOSTS) - HERE)
    return f"CAIR_HOSTS names {', '.join(elsewhere)}" if elsewhere else ""


class Command(BaseCommand):
    help = "Make a user for each role, with passwords that are shown once."

    @transaction.atomic
    def handle(self, *args: object, **options: object) -> None:
        reason = why_not()
        if reason:
            raise CommandError(f"This server serves people ({reason}): no demo users here.")
        for role in ROLES:
            self.stdout.write(self._make(role))

    def _make(self, role: str) -> str:
        users = get_user_model()._default_manager
        if users.filter(username=role).exists():
            return f"{role}: is there already and was left as it is."
        password = secrets.token_urlsafe(12)
        user = users.create_user(role, password=password, is_staff=True)
        user.groups.add(Group.objects.get(name=role))
        return f"{role}: password {password} (shown only now)"
