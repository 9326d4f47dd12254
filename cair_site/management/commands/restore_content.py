"""restore_content: the content of a backup, into an empty database or instead of another."""

from argparse import ArgumentParser
from pathlib import Path

from django.core.management.base import BaseCommand, CommandError
from django.db import DatabaseError

from cair_site.backup.file import LARGEST, MEGABYTE, BackupError
from cair_site.backup.restoring import restore


class Command(BaseCommand):
    help = (
        "Bring a file of backup_content into the database, SQLite or PostgreSQL: all of it or "
        "nothing. Accounts, passwords, sessions and keys here stay as they are; who wrote what "
        "is linked again where an account has the same name. Running nodes serve it within "
        "seconds."
    )

    def add_arguments(self, parser: ArgumentParser) -> None:
        parser.add_argument("file", type=Path)
        parser.add_argument("--replace", action="store_true", help="instead of the content here")
        parser.add_argument(
            "--largest",
            type=int,
            default=LARGEST // MEGABYTE,
            metavar="MIB",
            help="what the file may hold without compression (default: %(default)s)",
        )

    def handle(self, *args: object, file: Path, **options: object) -> None:
        largest = int(str(options["largest"])) * MEGABYTE
        try:
            with file.open("rb") as opened:
                counts = restore(opened, replace=bool(options["replace"]), largest=largest)
        except OSError as error:
            raise CommandError(f"{file} cannot be read: {error.strerror}.") from error
        except BackupError as error:
            raise CommandError(f"Nothing was restored: {error}") from error
        except DatabaseError as error:
            raise CommandError(f"Nothing was restored; the database refused it: {error}") from error
        self.stdout.write(f"Restored {sum(counts.values())} rows.")
