"""Imports run in a process of their own, so that no robot waits for them."""

import logging
import subprocess
import sys
import threading

from django.conf import settings
from django.db import connection
from django.utils import timezone

from ontology_io.import_runs import FAILED, LOST
from ontology_io.models import ImportRun

logger = logging.getLogger(__name__)


def start(number: int, *options: str) -> None:
    """Start `manage.py run_import` for a run and come back at once; the run tells how it goes on.

    The process has the environment of this worker and outlives it.
    """
    command = [sys.executable, "manage.py", "run_import", str(number), *options]
    try:
        process = subprocess.Popen(  # noqa: S603 - our own command, with a number
            command,
            cwd=settings.BASE_DIR,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            start_new_session=True,
        )
    except OSError:
        logger.exception("No process can be started for import %s.", number)
        end(number, FAILED)
        return
    threading.Thread(target=_watch, args=(process, number), name="import", daemon=True).start()


def _watch(process: "subprocess.Popen[bytes]", number: int) -> None:
    try:
        wait(process, number)
    finally:
        connection.close()


def wait(process: "subprocess.Popen[bytes]", number: int) -> None:
    """Wait for the end, so that no dead process stays behind; a killed one blocks nobody."""
    if process.wait():
        logger.warning("The process of import %s ended with %s.", number, process.returncode)
        end(number, LOST)


def end(number: int, step: str) -> None:
    """End a run whose process is gone; one that has ended by itself stays as it is."""
    going_on = ImportRun.objects.filter(pk=number, running=True)
    going_on.update(running=None, step=step, data=b"", ended=timezone.now())
