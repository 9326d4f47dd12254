"""publish: check the draft and make it what robots use."""

from argparse import ArgumentParser

from django.core.management.base import BaseCommand, CommandError

from dialogue.publishing import NothingPublishedError, NotPublishableError, publish, roll_back
from dialogue.snapshot import SnapshotError


class Command(BaseCommand):
    help = "Publish the draft (rebuild the Dialogue Tree), or --roll-back to an older publication."

    def add_arguments(self, parser: ArgumentParser) -> None:
        parser.add_argument("--note", default="", help="What is new.")
        parser.add_argument("--roll-back", type=int, metavar="NUMBER")

    def handle(self, *args: object, **options: object) -> None:
        number = options["roll_back"]
        try:
            if isinstance(number, int):
                row = roll_back(number)
            else:
                row = publish(note=str(options["note"]))
        except (NotPublishableError, NothingPublishedError, SnapshotError) as error:
            raise CommandError(f"Nothing was published.\n{error}") from error
        counted = ", ".join(f"{count} {name}" for name, count in row.counts.items())
        self.stdout.write(f"Publication {row.pk}: {counted}.")
