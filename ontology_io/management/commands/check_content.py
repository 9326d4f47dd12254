"""check_content: what the checks find in the content files, with file and line."""

from argparse import ArgumentParser
from collections import Counter
from collections.abc import Collection, Mapping
from pathlib import Path

from django.core.management.base import BaseCommand, CommandError

from dialogue.engine.findings import Finding
from dialogue.engine.lints.bars import bars, markdown
from dialogue.engine.lints.lint import findings_of, lint_content
from dialogue.garbage import collected_later
from ontology_io.check import build_base, check_files
from ontology_io.files.folder import (
    NUMBERS,
    Folder,
    folder_texts,
    read_folder,
    without_number,
)
from ontology_io.files.nodes import ContentError


class Command(BaseCommand):
    help = "Check the content files; the database is not touched."
    requires_system_checks: list[str] = []

    def add_arguments(self, parser: ArgumentParser) -> None:
        parser.add_argument("folder", nargs="?", default="content", type=Path)
        how = parser.add_mutually_exclusive_group()
        how.add_argument("--errors-only", action="store_true", help="Leave the warnings out.")
        how.add_argument("--strict", action="store_true", help="Fail on warnings too.")
        how.add_argument(
            "--bars", action="store_true", help="Print the table of the quality bars instead."
        )

    def handle(self, *args: object, **options: object) -> None:
        path = Path(str(options["folder"]))
        try:
            folder = read_folder(path)
        except ContentError as error:
            raise CommandError(str(error)) from error
        with collected_later():
            found = check_files(folder.base)
            if options["bars"]:
                self._print_bars(folder, found)
                return
            found = _with_lints(folder, found, lints=not options["errors_only"])
        self._report(folder, found)
        _refuse_unwritten(path, folder)
        errors = sum(finding.error for finding in found)
        if errors:
            raise CommandError(f"{errors} errors.")
        if found and options["strict"]:
            raise CommandError(f"{len(found)} warnings.")

    def _print_bars(self, folder: Folder, found: Collection[Finding]) -> None:
        errors = [finding for finding in found if finding.error]
        if errors:
            raise CommandError(f"{len(errors)} errors, first of all {errors[0]}")
        self.stdout.write(markdown(bars(build_base(folder.base))), ending="")

    def _report(self, folder: Folder, found: Collection[Finding]) -> None:
        """Write the errors, then the warnings, then how many there are of each code."""
        warnings = [finding for finding in found if not finding.error]
        for finding in found:
            if finding.error:
                self.stdout.write(finding.with_place(folder.places))
        if warnings:
            self.stdout.write("Warnings:")
        for finding in warnings:
            self.stdout.write(finding.with_place(folder.places))
        counted = sorted(Counter(finding.code for finding in found).items())
        if counted:
            self.stdout.write(", ".join(f"{code} {count}" for code, count in counted))
        errors = sum(finding.error for finding in found)
        topics = len(folder.base.knowledge.topics)
        self.stdout.write(f"{topics} topics, {errors} errors, {len(found)} findings.")


def _with_lints(folder: Folder, found: list[Finding], *, lints: bool) -> list[Finding]:
    """Return the findings, with those of the lints where nothing is wrong that stops them."""
    if not lints:
        return [finding for finding in found if finding.error]
    if any(finding.error for finding in found):
        return found
    return [*found, *findings_of(lint_content(build_base(folder.base)))]


def _refuse_unwritten(path: Path, folder: Folder) -> None:
    """Raise CommandError where `make content` would write something else."""
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


def _not_canonical(path: Path, texts: Mapping[str, str]) -> set[str]:
    """Return the names of the files that would be written otherwise, or not at all."""
    files = {file.name: file.read_bytes() for file in path.glob("*.yaml")}
    numbers = path / NUMBERS
    files |= {NUMBERS: numbers.read_bytes()} if numbers.exists() else {}
    wanted = {name: text.encode() for name, text in texts.items()}
    return {name for name in files.keys() | wanted.keys() if files.get(name) != wanted.get(name)}
