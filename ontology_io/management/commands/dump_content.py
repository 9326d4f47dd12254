"""dump_content: write the draft to the files of a folder."""

from argparse import ArgumentParser
from pathlib import Path

from django.core.management.base import BaseCommand, CommandError

from ontology_io.files.folder import write_folder
from ontology_io.numbering import last_numbers
from ontology_io.store import read_base


class Command(BaseCommand):
    help = "Write the draft as content files; the same draft gives the same bytes."

    def add_arguments(self, parser: ArgumentParser) -> None:
        parser.add_argument("folder", nargs="?", default="content", type=Path)

    def handle(self, *args: object, **options: object) -> None:
        base = read_base()
        if not base.knowledge.topics:
            raise CommandError("The draft is empty: nothing was written. Run load_content first.")
        changed = write_folder(Path(str(options["folder"])), base, last_numbers())
        self.stdout.write(f"Changed: {', '.join(changed)}" if changed else "Nothing changed.")
