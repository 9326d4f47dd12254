"""The site in this process: set up with a database of its own, called as gunicorn calls it."""

import os
import sys
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple
from wsgiref.types import StartResponse, WSGIApplication

if TYPE_CHECKING:
    from dialogue.snapshot import Snapshot

STATE_KEY = "a-key-of-the-benchmarks-of-32-bytes"
VARIABLES = {
    "CAIR_STATE_KEYS": STATE_KEY,
    "DJANGO_SETTINGS_MODULE": "cair_site.settings",
    "CAIR_POLL_SECONDS": "3600",
    "CAIR_LOG_LEVEL": "ERROR",
}


class Answer(NamedTuple):
    """What came back: `200 OK` and the body."""

    status: str
    body: bytes


def set_up(var: Path) -> None:
    """Set Django up, with database and secrets in `var`; call it before anything of the site."""
    for name in [name for name in os.environ if name.startswith(("CAIR_", "DATABASE_"))]:
        del os.environ[name]
    os.environ |= VARIABLES | {"CAIR_VAR": str(var)}
    import django

    django.setup()


def publish(snapshot: "Snapshot", topics: int) -> None:
    """Make the snapshot the only publication of a new database."""
    from django.core.management import call_command

    from dialogue.models import Publication
    from dialogue.snapshot import checksum, pack

    call_command("migrate", verbosity=0, interactive=False)
    data = pack(snapshot)
    Publication.objects.create(checksum=checksum(data), counts={"topics": topics}, data=data)


def with_echo() -> WSGIApplication:
    """Return the application of the site with the echo view beside its own."""
    from django.conf import settings

    settings.ROOT_URLCONF = "benchmarks.micro.echo"
    from cair_site.wsgi import application

    return application


def call(application: WSGIApplication, path: str, body: bytes) -> Answer:
    """POST a body; return what came back, read to its end."""
    statuses: list[str] = []

    def start(status: str, _headers: object, _error: object = None) -> None:
        statuses.append(status)

    answer = application(_environ(path, body), _typed(start))
    parts = b"".join(answer)
    close = getattr(answer, "close", None)
    if close is not None:
        close()
    return Answer(statuses[0], parts)


def _typed(start: object) -> StartResponse:
    return start  # type: ignore[return-value] # ours never writes by itself


def _environ(path: str, body: bytes) -> dict[str, object]:
    return {
        "REQUEST_METHOD": "POST",
        "PATH_INFO": path,
        "SCRIPT_NAME": "",
        "QUERY_STRING": "",
        "SERVER_NAME": "127.0.0.1",
        "SERVER_PORT": "8000",
        "SERVER_PROTOCOL": "HTTP/1.1",
        "REMOTE_ADDR": "127.0.0.1",
        "HTTP_HOST": "127.0.0.1",
        "CONTENT_TYPE": "application/json",
        "CONTENT_LENGTH": str(len(body)),
        "wsgi.input": BytesIO(body),
        "wsgi.errors": sys.stderr,
        "wsgi.url_scheme": "http",
        "wsgi.version": (1, 0),
        "wsgi.multithread": True,
        "wsgi.multiprocess": True,
        "wsgi.run_once": False,
    }
