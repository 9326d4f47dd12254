"""What the reading process takes from itself before it looks at a file."""

import contextlib
import sys

from ontology_io.owl.limits import Limits

with contextlib.suppress(ImportError):  # without POSIX limits the parent's clock remains
    import resource

#: Audit events (by their beginning) of what a reader of bytes in memory never needs.
_REFUSED = (
    *("open", "os.", "shutil.", "tempfile.", "glob.", "pathlib.", "mmap.", "fcntl.", "pty."),
    *("socket.", "urllib.", "http.", "ftplib.", "smtplib.", "poplib.", "imaplib.", "nntplib."),
    *("subprocess.", "import", "exec", "compile", "code.", "ctypes.", "marshal.", "pickle."),
    *("sqlite3.", "syslog.", "webbrowser.", "winreg.", "_winapi.", "msvcrt.", "resource."),
    *("signal.", "sys.addaudithook", "sys.settrace", "sys.setprofile", "cpython.run_"),
)


class RefusedError(RuntimeError):
    """Something other than reading was tried while a file was read."""


def confine(limits: Limits) -> None:
    """Bound memory and processor time; no files, no processes, no core dump.

    Where the system lacks a limit, it is left out.
    """
    wanted = {
        "RLIMIT_AS": limits.memory,
        "RLIMIT_CPU": limits.cpu,
        "RLIMIT_CORE": 0,
        "RLIMIT_FSIZE": 0,
        "RLIMIT_NPROC": 0,
        "RLIMIT_NOFILE": 32,
    }
    for name, bound in wanted.items():
        with contextlib.suppress(NameError, AttributeError, OSError, ValueError):
            resource.setrlimit(getattr(resource, name), (bound, bound))


def lock() -> None:
    """From here on refuse files, network, processes and new modules, whoever asks."""
    sys.addaudithook(_refuse)


def _refuse(event: str, arguments: tuple[object, ...]) -> None:
    if event.startswith(_REFUSED):
        raise RefusedError(event)
