"""gunicorn: content is loaded once, shared by all workers; each keeps counts of its own."""

import atexit
import fcntl
import os
import shutil
import sys
import tempfile
import time
from pathlib import Path

_COUNTS = "PROMETHEUS_MULTIPROC_DIR"
_PREFIX = "cair-counts-"
_OURS = f"{_PREFIX}{os.getpid()}-"
_OLD_SECONDS = 60

wsgi_app = "cair_site.wsgi"
preload_app = True
worker_class = "gthread"
# A stalled client holds a thread, not a worker.
threads = 16
timeout = 30
graceful_timeout = 20
keepalive = 15
backlog = 2048
limit_request_line = 4094
max_requests = 0
accesslog = None
errorlog = "-"
control_socket_disable = True
logger_class = "cair_site.server_log.ServerLog"


def _folder_of_counts() -> None:
    """Name the folder before the counters are imported; a new one for each server."""
    given = os.path.basename(os.environ.get(_COUNTS, ""))
    if given and (given.startswith(_OURS) or not given.startswith(_PREFIX)):
        return
    _sweep()
    folder = os.environ[_COUNTS] = tempfile.mkdtemp(prefix=_OURS)
    # Held until the last worker has ended, however it ends.
    fcntl.flock(os.open(f"{folder}/lock", os.O_CREAT | os.O_RDWR), fcntl.LOCK_EX)
    atexit.register(_leave_nothing, folder, os.getpid())


def _sweep() -> None:
    """Remove the folders of servers that were killed: nobody holds their lock."""
    for lock in Path(tempfile.gettempdir()).glob(f"{_PREFIX}*/lock"):
        try:
            if time.time() - lock.stat().st_mtime < _OLD_SECONDS:
                continue
            with lock.open("rb") as file:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
                shutil.rmtree(lock.parent, ignore_errors=True)
        except OSError:
            continue


def _leave_nothing(folder: str, master: int) -> None:
    """Remove the counts when the server ends; workers inherit this call and leave them."""
    if os.getpid() == master:
        shutil.rmtree(folder, ignore_errors=True)


_folder_of_counts()


def on_starting(server: object) -> None:
    """Refuse to serve with keys that can be guessed, or debug pages to others."""
    from cair_site.checks import refuse_to_serve

    if reason := refuse_to_serve(server.cfg.bind):  # type: ignore[attr-defined]
        sys.exit(f"CAIR does not start. {reason}")


def pre_fork(server: object, worker: object) -> None:
    """Leave no connection of the loading to the workers: they would read each other's answers."""
    from cair_site.databases import close_before_fork  # The path is set when the site is loaded.

    close_before_fork()
