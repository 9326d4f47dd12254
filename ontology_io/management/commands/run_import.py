"""run_import: carry out an import that a page or a program has begun; started in the background."""

import os
from argparse import ArgumentParser
from contextlib import suppress

from django.conf import settings
from django.core.management.base import BaseCommand, CommandError

from ontology_io import import_runs
from ontology_io.models import ImportRun
from ontology_io.owl.limits import Limits

#: Robots come first: an import takes what they leave.
NICE = 10


class Command(BaseCommand):
    help = "Carry out a begun import by its number (started by the admin and the API)."

    def add_arguments(self, parser: ArgumentParser) -> None:
        parser.add_argument("run", type=int)
        parser.add_argument("--apply", action="store_true", help="write it into the draft too")

    def handle(self, *args: object, **options: object) -> None:
        with suppress(OSError, AttributeError):
            os.nice(NICE)
        run = ImportRun.objects.filter(pk=int(str(options["run"])), running=True).first()
        if run is None:
            raise CommandError(f"No import {options['run']} is going on.")
        limits = Limits(size=getattr(settings, "CAIR_LONGEST_ONTOLOGY", Limits().size))
        run = import_runs.carry_out(run, apply=bool(options["apply"]), limits=limits)
        self.stdout.write(f"{run.step}\n")
