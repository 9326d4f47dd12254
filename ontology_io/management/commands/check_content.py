"""check_content: what the checks find in the content files, with file and line."""

from argparse import ArgumentParser
from collections.abc import Mapping
from pathlib import Path

from django.core.management.base import BaseCommand, CommandError

from ontology_io.check import check_base
from ontology_io.files.folder import NUMBERS, folder_texts, read_folder, without_number
from ontology_io.files.nodes import ContentError


class Command(BaseCommand):
    help = "Check the content files; the database is not touched."
    requires_system_checks: list[str] = []

    def add_arguments(self, parser: ArgumentParser) -> None:
        parser.add_argument("folder", nargs="?", default="content", type=Path)

    def handle(self, *args: object, **options: object) -> None:
        path = Path(str(options["folder"]))
        try:
            folder = read_folder(path)
        except ContentError as error:
            raise CommandError(str(error)) from error
        found = check_base(folder.base)
        errors = [finding for finding in found if finding.error]
        for finding in found:
            self.stdout.write(finding.with_place(folder.places))
        missing = without_number(folder.base)
        if missing:
            raise CommandError(
                f"{path.name}/{NUMBERS} lacks {len(missing)} numbers, first of {missing[0]}: "
                "run `make content` and commit what it changes."
            )
        for name in sorted(_not_canonical(path, folder_texts(folder.base, folder.last))):
            raise CommandError(
                f"{path.name}/{name} is not in the canonical form: "
                "run `make content` and commit what it changes."
            )
        topics = folder.base.knowledge.topics
        self.stdout.write(f"{len(topics)} topics, {len(errors)} errors, {len(found)} findings.")
        if errors:
            raise CommandError(f"{len(errors)} errors.")


def _not_canonical(path: Path, texts: Mapping[str, str]) -> set[str]:
    """Return the names of the files that would be written otherwise, or not at all."""
    files = {file.name: file.read_bytes() for file in path.glob("*.yaml")}
    numbers = path / NUMBERS
    files |= {NUMBERS: numbers.read_bytes()} if numbers.exists() else {}
    wanted = {name: text.encode() for name, text in texts.items()}
    return {name for name in files.keys() | wanted.keys() if files.get(name) != wanted.get(name)}
