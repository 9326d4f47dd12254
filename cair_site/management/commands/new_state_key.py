"""`manage.py new_state_key`: change the key of dialogue states without losing a talk.

Three steps, each of them on all servers before the next:

1. `new_state_key` adds a key that is read, but does not sign yet;
2. `new_state_key --sign` lets that key sign; the older ones are still read;
3. `new_state_key --drop`, when talks of the old key may be forgotten.

Each prints the new value of CAIR_STATE_KEYS, or writes it to a file of the owner alone.
"""

import os
import secrets
import tempfile
from argparse import ArgumentParser
from pathlib import Path
from typing import Any

from django.conf import settings
from django.core.management.base import BaseCommand, CommandError


def added(keys: list[str]) -> list[str]:
    """Return the keys with a new one that does not sign yet."""
    return [*keys, secrets.token_hex(32)]


def signing(keys: list[str]) -> list[str]:
    """Return the keys with the last one first. Raises CommandError where there is but one."""
    if len(keys) < 2:
        raise CommandError("There is only one key: add one first (manage.py new_state_key).")
    return [keys[-1], *keys[:-1]]


def dropped(keys: list[str]) -> list[str]:
    """Return the signing key alone."""
    return keys[:1]


class Command(BaseCommand):
    """Print or write the next value of CAIR_STATE_KEYS."""

    help = "Change the key of dialogue states, step by step: add, --sign, --drop."
    requires_system_checks: list[str] = []

    def add_arguments(self, parser: ArgumentParser) -> None:
        """Name the step and the file."""
        step = parser.add_mutually_exclusive_group()
        step.add_argument("--sign", action="store_true", help="The last key signs from now on.")
        step.add_argument("--drop", action="store_true", help="Forget all but the signing key.")
        parser.add_argument("--write", metavar="FILE", help="What CAIR_STATE_KEYS_FILE names.")

    def handle(self, *_args: Any, **options: Any) -> None:
        """Do one step."""
        step = signing if options["sign"] else dropped if options["drop"] else added
        value = ",".join(step(list(settings.CAIR_STATE_KEYS)))
        if not options["write"]:
            self.stdout.write(value)
            return
        _write(Path(options["write"]), value)
        self.stdout.write(f"Written to {options['write']}. Restart each server in turn.")


def _write(path: Path, value: str) -> None:
    """Write a file of its owner alone, whole or not at all."""
    try:
        number, name = tempfile.mkstemp(dir=path.parent)
        with open(number, "w", encoding="ascii") as file:
            file.write(value)
        os.replace(name, path)
    except OSError as error:
        raise CommandError(f"Cannot write {path}: {error}") from error
