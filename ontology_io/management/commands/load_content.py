"""load_content: bring the files of a folder into the draft."""

from argparse import ArgumentParser
from pathlib import Path

from django.core.management.base import BaseCommand, CommandError

from ontology_io.check import check_files
from ontology_io.differences import differences
from ontology_io.files.folder import read_folder
from ontology_io.files.nodes import ContentError
from ontology_io.numbering import numbered
from ontology_io.store import read_base, write_base


class Command(BaseCommand):
    help = "Load the content files into the draft; --dry-run only shows the differences."

    def add_arguments(self, parser: ArgumentParser) -> None:
        parser.add_argument("folder", nargs="?", default="content", type=Path)
        parser.add_argument("--dry-run", action="store_true")

    def handle(self, *args: object, **options: object) -> None:
        path = Path(str(options["folder"]))
        try:
            folder = read_folder(path)
        except ContentError as error:
            raise CommandError(f"Nothing was loaded.\n{error}") from error
        errors = [finding for finding in check_files(folder.base) if finding.error]
        if errors:
            named = "\n".join(finding.with_place(folder.places) for finding in errors[:200])
            raise CommandError(f"Nothing was loaded: {len(errors)} errors.\n{named}")
        if options["dry_run"]:
            old = read_base()
            found = differences(old, numbered(folder.base, old))
        else:
            found = write_base(folder.base, folder.last)
        for line in found.lines():
            self.stdout.write(line)
        self.stdout.write("Nothing to change." if not found else self._end(options))

    def _end(self, options: dict[str, object]) -> str:
        return "Nothing was written (dry run)." if options["dry_run"] else "Loaded."
