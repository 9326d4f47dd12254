"""backup_content: the content of the database in one file."""

from argparse import ArgumentParser
from pathlib import Path

from django.core.management.base import BaseCommand, CommandError

from cair_site.backup.backing_up import back_up
from cair_site.backup.file import LARGEST, MEGABYTE, BackupError


class Command(BaseCommand):
    help = (
        "Write the content to one file: the draft with its history, intents, releases, "
        "conversations. It is read back by restore_content into SQLite or PostgreSQL. Not in it: "
        "accounts, passwords, sessions, API keys, the keys of states. Of people it holds the "
        "names of the accounts that wrote something."
    )

    def add_arguments(self, parser: ArgumentParser) -> None:
        parser.add_argument("file", type=Path, help="e.g. cair.backup.gz; replaced when complete")

    def handle(self, *args: object, file: Path, **options: object) -> None:
        try:
            told, size = back_up(file)
        except OSError as error:
            raise CommandError(f"{file} cannot be written: {error.strerror}.") from error
        except BackupError as error:
            raise CommandError(f"Nothing was written to {file}: {error}") from error
        self.stdout.write(f"{file}: {told.rows} rows, {file.stat().st_size} bytes.")
        if size > LARGEST:
            self.stdout.write(f"To restore it, give --largest {size // MEGABYTE + 1}.")
