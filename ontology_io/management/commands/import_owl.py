"""import_owl: show what an OWL file would change in the draft, and with --apply write it."""

from argparse import ArgumentParser
from pathlib import Path

from django.conf import settings
from django.contrib.auth import get_user_model
from django.core.management.base import BaseCommand, CommandError

from ontology_io import import_runs
from ontology_io.bounded_file import read_bounded
from ontology_io.import_runs import BusyError
from ontology_io.import_words import lines
from ontology_io.importing import preview
from ontology_io.models import ImportRun
from ontology_io.owl.limits import Limits, OwlError


class Command(BaseCommand):
    help = "Show what an OWL file (.owl, .owl.gz) would change in the draft; --apply writes it."

    def add_arguments(self, parser: ArgumentParser) -> None:
        parser.add_argument("file", type=Path)
        parser.add_argument("--apply", action="store_true", help="write it into the draft")
        parser.add_argument("--keep", action="store_true", help="keep what the file does not hold")
        parser.add_argument("--author", default="", help="the user's name for the history")

    def handle(self, *args: object, **options: object) -> None:
        path, keep = Path(str(options["file"])), bool(options["keep"])
        author = self._author(str(options["author"]))
        limits = self._limits()
        try:
            data = read_bounded(path, limits.size)
            if options["apply"]:
                self._apply(path, data, author, limits, keep=keep)
            else:
                self._show(data, limits, keep=keep)
        except (OwlError, BusyError) as error:
            raise CommandError(f"Nothing was written.\n{error}") from error

    def _limits(self) -> Limits:
        return Limits(size=getattr(settings, "CAIR_LONGEST_ONTOLOGY", Limits().size))

    def _author(self, name: str) -> int | None:
        if not name:
            return None
        user = get_user_model().objects.filter(username=name).first()
        if user is None:
            raise CommandError(f"There is no user {name!r}.")
        return int(user.pk)

    def _show(self, data: bytes, limits: Limits, *, keep: bool) -> None:
        found = preview(data, keep=keep, limits=limits)
        for line in lines(import_runs.result_of(found)):
            self.stdout.write(line)
        if found.errors:
            raise CommandError("Nothing was written: the file has errors.")
        self.stdout.write("Nothing was written (dry run); add --apply.")

    def _apply(
        self, path: Path, data: bytes, author: int | None, limits: Limits, *, keep: bool
    ) -> None:
        run = import_runs.begin(author, path.name, data, keep=keep)
        run = import_runs.carry_out(run, apply=True, limits=limits)
        for line in lines(run.result):
            self.stdout.write(line)
        self._end(run)

    def _end(self, run: ImportRun) -> None:
        if run.applied:
            self.stdout.write("Imported into the draft.")
            return
        reasons = {
            import_runs.REFUSED: "the file has errors.",
            import_runs.CHANGED: "the draft has changed meanwhile. Import again.",
            import_runs.FAILED: "something unforeseen happened; the log says what.",
        }
        reason = reasons.get(run.step, "somebody has given the import up.")
        raise CommandError(f"Nothing was written: {reason}")
