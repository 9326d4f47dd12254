"""plan_guide: write docs/plans.md, the page on plans for developers of clients."""

from argparse import ArgumentParser
from pathlib import Path

from django.conf import settings
from django.core.management.base import BaseCommand, CommandError

from dialogue.models import Publication
from dialogue.snapshot import unpack
from ontology_io.files.folder import read_folder
from ontology_io.files.nodes import ContentError
from plans.engine.intents import Library
from plans.engine.plans_page import plans_page


class Command(BaseCommand):
    help = "Write the page on plans from what is published, or from a content folder."

    def add_arguments(self, parser: ArgumentParser) -> None:
        parser.add_argument("--output", default=str(settings.BASE_DIR / "docs" / "plans.md"))
        parser.add_argument("--path", default="", help="A content folder: no publication is read.")

    def handle(self, *args: object, **options: object) -> None:
        folder, output = str(options["path"]), Path(str(options["output"]))
        library = _of_folder(Path(folder)) if folder else _published()
        output.write_text(plans_page(library), "utf-8")
        self.stdout.write(f"{output}: {len(library.intents)} intents.")


def _published() -> Library:
    row = Publication.objects.first()
    if row is None:
        raise CommandError("Nothing is published yet: run manage.py publish.")
    return unpack(bytes(row.data), row.checksum).library


def _of_folder(path: Path) -> Library:
    try:
        return read_folder(path).base.library
    except ContentError as error:
        raise CommandError(str(error)) from error
