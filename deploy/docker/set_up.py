"""What the database needs before servers start: `python deploy/docker/set_up.py [--wait]`.

Migrates; where nothing was ever published, loads the shipped content and publishes it. Several may
do so at once. With --wait nothing is changed: it ends when the database is as this version needs.
"""

import os
import sys
import time
from argparse import ArgumentParser

import django
from django.core.management import call_command
from django.db import DatabaseError, connection
from django.db.migrations.executor import MigrationExecutor

EVERY = 2.0
LONGEST = 600.0


def main() -> int:
    """Set up, or wait for it; return 0 where all is there."""
    parser = ArgumentParser(description=__doc__)
    parser.add_argument("--wait", action="store_true", help="until somebody else has set up")
    parser.add_argument("--seconds", type=float, default=LONGEST, help="how long to wait")
    options = parser.parse_args()
    os.environ.setdefault("DJANGO_SETTINGS_MODULE", "cair_site.settings")
    django.setup()
    if options.wait:
        return 0 if wait(options.seconds) else 1
    set_up()
    return 0


def set_up() -> None:
    """Migrate, and publish the shipped content once; what experts changed since is left alone."""
    from cair_site.one_at_a_time import one_at_a_time

    call_command("migrate", interactive=False)
    with one_at_a_time("first-content"):
        if not _published():
            call_command("load_content", "content", stdout=sys.stderr)
            call_command("publish", note="The shipped content")


def wait(seconds: float) -> bool:
    """Return whether the database was ready within this time."""
    until = time.monotonic() + seconds
    while not (ready := is_ready()):
        sys.stderr.write("Waiting for the database to be set up.\n")
        left = until - time.monotonic()
        if left <= 0:
            break
        time.sleep(min(EVERY, left))
    return ready


def is_ready() -> bool:
    """Return whether all migrations of this version are there, and a publication."""
    try:
        executor = MigrationExecutor(connection)
        lacking = executor.migration_plan(executor.loader.graph.leaf_nodes())
        return not lacking and _published()
    except DatabaseError:
        return False
    finally:
        connection.close()


def _published() -> bool:
    from dialogue.models import Publication

    return Publication.objects.exists()


if __name__ == "__main__":
    sys.exit(main())
