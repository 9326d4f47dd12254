"""The image by hand: its tree, and a container's walls from bubblewrap."""

import fnmatch
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from tests.deploy.files import ROOT, USER, stages

SYSTEM = ("/usr", "/bin", "/lib", "/lib64", "/sbin", "/etc")
PYTHON = Path(os.environ.get("CAIR_TEST_IMAGE_PYTHON", sys.executable))


def missing() -> str:
    """Return why this machine cannot be a container; empty where it can."""
    programs = [name for name in ("bwrap", "setpriv") if shutil.which(name) is None]
    if programs:
        return f"needs {', '.join(programs)}"
    return "" if os.geteuid() == 0 else "needs root, to become another user"


def context() -> list[Path]:
    """Return the files that .dockerignore lets into the image; the last line that matches wins."""
    rules = [
        line
        for line in (ROOT / ".dockerignore").read_text().splitlines()
        if line and not line.startswith("#")
    ]
    tops = {rule.removeprefix("!").split("/")[0] for rule in rules if rule.startswith("!")}
    files = [
        file for top in tops for file in [ROOT / top, *(ROOT / top).rglob("*")] if file.is_file()
    ]
    return [file for file in files if not _ignored(file.relative_to(ROOT), rules)]


def _ignored(path: Path, rules: list[str]) -> bool:
    ignored = False
    names = [str(path), *map(str, path.parents)]
    for rule in rules:
        pattern = rule.removeprefix("!")
        if any(_matches(name, pattern) for name in names):
            ignored = not rule.startswith("!")
    return ignored


def _matches(name: str, pattern: str) -> bool:
    if pattern.startswith("**/"):
        return any(fnmatch.fnmatch(part, pattern[3:]) for part in name.split("/"))
    same_depth = name.count("/") == pattern.count("/")
    return same_depth and fnmatch.fnmatch(name, pattern)


def build(tree: Path) -> None:
    """Make /srv/cair as the first stage does, with the packages of this Python."""
    for file in context():
        copy = tree / file.relative_to(ROOT)
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(file, copy)
    step = next(text for name, text in stages()[0] if name == "RUN" and "collectstatic" in text)
    step = step.replace("/opt/cair/bin/python", str(PYTHON)).replace("/tmp/var", f"{tree}.var")  # noqa: S108
    step = step.replace("/srv/cair /opt/cair", str(tree))
    clean = {"PATH": os.environ["PATH"], "HOME": "/nonexistent"}
    subprocess.run(["/bin/sh", "-ec", step], cwd=tree, env=clean, check=True, timeout=120)


def settings(**more: str) -> dict[str, str]:
    """Return the environment that the last stage sets, with more."""
    text = next(text for name, text in stages()[-1] if name == "ENV")
    given = dict(pair.split("=", 1) for pair in text.split())
    given["PATH"] = f"{PYTHON.parent}:/usr/bin:/bin"
    return given | more


def _walls(tree: Path, var: Path, environment: dict[str, str]) -> list[str]:
    """Return the beginning of a command that runs the rest as a container would."""
    walls = ["bwrap", "--die-with-parent", "--unshare-pid", "--unshare-ipc", "--clearenv"]
    walls += ["--perms", "1777", "--tmpfs", "/tmp", "--proc", "/proc", "--dev", "/dev"]  # noqa: S108
    readable = [*SYSTEM, sys.base_prefix, str(PYTHON.parent.parent)]
    readable = list(dict.fromkeys(path for path in readable if Path(path).exists()))
    for folder in _above([*readable, "/srv/cair", "/var/lib/cair"]):
        walls += ["--perms", "0755", "--dir", folder]
    for path in readable:
        walls += ["--ro-bind", path, path]
    walls += ["--ro-bind", str(tree), "/srv/cair", "--bind", str(var), "/var/lib/cair"]
    for name, value in environment.items():
        walls += ["--setenv", name, value]
    walls += ["--remount-ro", "/", "--chdir", "/srv/cair"]
    walls += ["setpriv", f"--reuid={USER}", f"--regid={USER}", "--clear-groups"]
    return [*walls, "--bounding-set=-all", "--inh-caps=-all", "--no-new-privs"]


@contextmanager
def container(
    tree: Path, var: Path, command: list[str], environment: dict[str, str]
) -> Iterator["subprocess.Popen[str]"]:
    """Run a command as the user of the image: /srv/cair read-only, no rights, writable CAIR_VAR."""
    os.chown(var, USER, USER)
    whole = [*_walls(tree, var, environment), *command]
    process = subprocess.Popen(whole, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    try:
        yield process
    finally:
        process.terminate()
        try:
            process.wait(10)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait(5)
        if process.stdout:
            process.stdout.close()


def _above(paths: list[str]) -> list[str]:
    """Return the folders that hold these, outermost first, without the root."""
    folders = {str(folder) for path in paths for folder in Path(path).parents}
    return sorted(folders - {"/", "/tmp", *SYSTEM}, key=len)  # noqa: S108


def run(tree: Path, var: Path, command: list[str], environment: dict[str, str]) -> tuple[int, str]:
    """Run a command to its end; return its code and what it said."""
    with container(tree, var, command, environment) as process:
        said, _nothing = process.communicate(timeout=120)
        return process.returncode, said
