"""check_intents: run the tests of the intents and look for conflicts, in the content files."""

from argparse import ArgumentParser
from pathlib import Path

import msgspec
from django.core.management.base import BaseCommand, CommandError

from languages.known import LANGUAGES
from ontology_io.files.folder import read_folder
from ontology_io.files.nodes import ContentError
from ontology_io.intent_report import Places, failures, table, totals
from plans.engine.catalogue import LibraryError, compile_catalogue
from plans.engine.intents import Library
from plans.engine.library_lint import lint
from plans.engine.stored_tests import run_stored_tests


class Command(BaseCommand):
    help = "Run the stored tests of the intents and find conflicts; the database is not touched."
    requires_system_checks: list[str] = []

    def add_arguments(self, parser: ArgumentParser) -> None:
        parser.add_argument("--path", default="content", help="The content folder.")
        parser.add_argument("--intent", action="append", default=[], help="Only this; repeatable.")
        parser.add_argument("--language", action="append", default=[], choices=list(LANGUAGES))
        parser.add_argument("--warnings", action="store_true", help="Show warnings too.")

    def handle(self, *args: object, **options: object) -> None:
        path = Path(str(options["path"]))
        intents = msgspec.convert(options["intent"], tuple[str, ...])
        languages = msgspec.convert(options["language"], tuple[str, ...])
        library = _library(path)
        unknown = sorted(set(intents) - {intent.key for intent in library.intents})
        if unknown:
            raise CommandError(f"There is no intent {', '.join(unknown)}.")
        try:
            catalogue = compile_catalogue(library)
        except LibraryError as error:
            raise CommandError(str(error)) from error
        tested = run_stored_tests(library, catalogue, intents=intents, languages=languages)
        remarks = lint(library, catalogue, intents=intents, languages=languages)
        places = Places(path)
        failed = list(failures(tested, places))
        errors = [remark for remark in remarks if remark.error]
        shown = remarks if options["warnings"] else errors
        lines = [f"{places.of(remark.where, remark.near)}{remark}" for remark in shown]
        for line in (*table(tested), *failed, *lines):
            self.stdout.write(line)
        warned = f"{len(errors)} errors, {len(remarks) - len(errors)} warnings"
        self.stdout.write(f"{totals(library, tested)}, {warned}.")
        if failed or errors:
            raise CommandError(f"{len(failed)} tests failed, {len(errors)} errors.")


def _library(path: Path) -> Library:
    """Return the intents of a folder, with passing numbers for those that have none yet."""
    try:
        library = read_folder(path).base.library
    except ContentError as error:
        raise CommandError(str(error)) from error
    replace = msgspec.structs.replace
    intents = tuple(replace(one, number=place) for place, one in enumerate(library.intents, 1))
    return replace(library, intents=intents)
