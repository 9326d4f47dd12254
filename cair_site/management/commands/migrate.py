"""migrate: Django's, one process at a time, so that several nodes may start at once."""

from typing import Any

from django.core.management.commands import migrate
from django.db import connections

from cair_site.one_at_a_time import one_at_a_time


class Command(migrate.Command):
    help = f"{migrate.Command.help} Whoever comes second waits and finds nothing to do."

    def handle(self, *args: Any, **options: Any) -> None:
        used = connections[options["database"]]
        with one_at_a_time("migrate", used):
            # Without a pool of ours a pooler may be there: what is set would be set for others.
            if used.vendor != "postgresql" or "pool" not in used.settings_dict["OPTIONS"]:
                super().handle(*args, **options)
                return
            self._without_limit(*args, **options)

    def _without_limit(self, *args: Any, **options: Any) -> None:
        """Migrate however long a statement takes, e.g. the index of a large table."""
        used = connections[options["database"]]
        with used.cursor() as cursor:
            cursor.execute("SET statement_timeout = 0")
        try:
            super().handle(*args, **options)
        finally:
            with used.cursor() as cursor:
                cursor.execute("RESET statement_timeout")
