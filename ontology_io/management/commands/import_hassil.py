"""import_hassil: the sentences of hassil's YAML as intents in the format of the content files."""

from argparse import ArgumentParser
from pathlib import Path

from django.core.management.base import BaseCommand, CommandError

from languages.known import LANGUAGES
from ontology_io.files.hassil_files import LARGEST_FILE, read_hassil, together
from ontology_io.files.intents_files import write_library
from ontology_io.files.nodes import ContentError, Problem, Problems
from plans.engine.hassil.convert import convert
from plans.engine.hassil.data import HassilFile


class Command(BaseCommand):
    help = (
        "Print the intents of hassil's YAML files in the format of content/intents.yaml, for an "
        "author to edit; nothing is written to the database."
    )
    requires_system_checks: list[str] = []

    def add_arguments(self, parser: ArgumentParser) -> None:
        parser.add_argument("files", nargs="+", type=Path, metavar="FILE")
        parser.add_argument("--language", required=True, choices=sorted(LANGUAGES))

    def handle(self, *args: object, files: list[Path], language: str, **options: object) -> None:
        try:
            whole = together(_read(path, language) for path in files)
        except ContentError as error:
            raise CommandError(str(error)) from error
        if not whole.intents:
            raise CommandError(f"No intents stand in {', '.join(map(str, files))}.")
        conversion = convert(whole, LANGUAGES[language])
        for problem in conversion.problems:
            self.stderr.write(str(problem))
        self.stdout.write(write_library(conversion.library), ending="")
        left_out = len({problem.template for problem in conversion.problems})
        if left_out:
            self.stderr.write(f"Left out: {left_out} templates (see above).")


def _read(path: Path, language: str) -> HassilFile:
    """Return one file. Raises ContentError with every problem found in it."""
    problems = Problems(path.name)
    try:
        if path.stat().st_size > 4 * LARGEST_FILE:
            raise ContentError([Problem(path.name, 1, "This file is too large.")])
        text = path.read_text("utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise ContentError([Problem(path.name, 1, f"It cannot be read: {error}.")]) from error
    file = read_hassil(text, problems, language)
    if problems.found:
        raise ContentError(problems.found)
    return file
