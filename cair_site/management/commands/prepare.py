"""prepare: whatever is missing between a fresh clone and a server that talks."""

import hashlib
import os
import secrets
from argparse import ArgumentParser
from collections.abc import Callable
from pathlib import Path

from django.conf import settings
from django.contrib.auth import get_user_model
from django.core.management import call_command
from django.core.management.base import BaseCommand
from tqdm import tqdm

from cair_site.one_at_a_time import one_at_a_time
from dialogue.models import Publication

Job = tuple[str, Callable[[], object]]


class Command(BaseCommand):
    help = "Migrate, load the shipped content, publish it, make an administrator: only what lacks."

    def add_arguments(self, parser: ArgumentParser) -> None:
        parser.add_argument("--content", default=str(settings.BASE_DIR / "content"))

    def handle(self, *args: object, **options: object) -> None:
        Path(settings.VAR).mkdir(parents=True, exist_ok=True, mode=0o700)
        with one_at_a_time("prepare"):
            self._prepare(Path(str(options["content"])))

    def _prepare(self, folder: Path) -> None:
        """Do all that lacks, one after another; several nodes may start at once."""
        jobs: list[Job] = [("database", self._migrate)]
        if self._stale_static():
            jobs.append(("static files", self._collect_static))
        jobs.append(("content", lambda: self._load(folder)))
        jobs.append(("administrator", self._administrator))
        with tqdm(
            jobs, bar_format="{l_bar}{bar:30}| {n}/{total} [{elapsed}]", leave=False, disable=None
        ) as bar:
            for name, job in bar:
                bar.set_description(name)
                job()

    def _migrate(self) -> None:
        call_command("migrate", verbosity=0, interactive=False)

    def _static_mark(self) -> Path:
        return Path(settings.VAR) / "static.sha256"

    def _stale_static(self) -> bool:
        mark = self._static_mark()
        fresh = mark.exists() and mark.read_text() == _fingerprint(
            Path(settings.BASE_DIR) / "static"
        )
        return not fresh or not Path(settings.STATIC_ROOT).exists()

    def _collect_static(self) -> None:
        call_command("collectstatic", verbosity=0, interactive=False)
        self._static_mark().write_text(_fingerprint(Path(settings.BASE_DIR) / "static"))

    def _load(self, folder: Path) -> None:
        """Load and publish the shipped content once; what experts changed since is left alone."""
        if Publication.objects.exists():
            return
        call_command("load_content", str(folder), stdout=open(os.devnull, "w"))  # noqa: SIM115
        call_command("publish", note="The shipped content", stdout=open(os.devnull, "w"))  # noqa: SIM115

    def _administrator(self) -> None:
        """Make an administrator with a password that is shown once, where there is none."""
        users = get_user_model()._default_manager
        if users.filter(is_superuser=True).exists():
            return
        password = secrets.token_urlsafe(12)
        users.create_superuser("admin", password=password)
        tqdm.write(f"Administrator for /admin/: admin, password {password} (shown only now).")


def _fingerprint(folder: Path) -> str:
    digest = hashlib.sha256()
    for file in sorted(folder.rglob("*")):
        if file.is_file():
            digest.update(str(file.relative_to(folder)).encode() + b"\0" + file.read_bytes())
    return digest.hexdigest()
