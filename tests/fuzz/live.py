"""Schemathesis against a gunicorn of its own on loopback: `python -m tests.fuzz.live`."""

import argparse
import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TOOL = ROOT / ".venv" / "fuzz" / "bin" / "schemathesis"
CONFIG = Path(__file__).with_name("schemathesis.toml")
LISTENS = re.compile(r"Listening at: (http://127\.0\.0\.1:\d+)")
NEW_KEY = """
from authoring.keys import make_key
print(make_key("fuzz", None, None, "write")[1])
"""


def environment(var: Path) -> dict[str, str]:
    """Return the environment of a server whose data is in this folder, with nothing else set."""
    ours = ("CAIR_", "DATABASE_", "DJANGO_")
    return {k: v for k, v in os.environ.items() if not k.startswith(ours)} | {"CAIR_VAR": str(var)}


def manage(var: Path, *arguments: str) -> str:
    """Run manage.py and return what it printed."""
    command = [sys.executable, "manage.py", *arguments]
    done = subprocess.run(
        command, cwd=ROOT, env=environment(var), check=True, stdout=subprocess.PIPE, text=True
    )
    return done.stdout


def start(var: Path, log: Path) -> tuple[subprocess.Popen[bytes], str]:
    """Start gunicorn on a free port; return its process and address once it answers."""
    command = [sys.executable, "-m", "gunicorn", "--config", "cair_site/gunicorn_conf.py"]
    command += ["--bind", "127.0.0.1:0", "--workers", "2"]
    with log.open("wb") as file:
        process = subprocess.Popen(command, cwd=ROOT, env=environment(var), stderr=file)
    for _ in range(600):
        if found := LISTENS.search(log.read_text(errors="replace")):
            return process, found[1]
        time.sleep(0.05)
    process.terminate()
    raise SystemExit(log.read_text(errors="replace"))


def fuzz(address: str, key: str, asked: argparse.Namespace, tool: Path) -> int:
    """Run Schemathesis; return its exit code."""
    command = [tool, "--config-file", CONFIG, "run", f"{address}/api/schema/"]
    command += ["--checks", "all", "--continue-on-failure", "--header", f"X-Api-Key: {key}"]
    command += ["--max-examples", str(asked.examples), "--seed", str(asked.seed)]
    command += ["--workers", "2", "--request-timeout", "20", *asked.more]
    if asked.seconds:
        command += ["--max-time", str(asked.seconds)]
    return subprocess.run(command, cwd=asked.folder, check=False).returncode


def main() -> int:
    """Prepare, serve, fuzz; say where a fault of ours was logged."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--examples", type=int, default=20, help="of a call")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--seconds", type=int, default=0, help="go on until they are spent")
    parser.add_argument("--var", type=Path, help="a CAIR_VAR to keep and to use again")
    parser.add_argument("--tool", type=Path, default=TOOL)
    parser.add_argument("more", nargs="*", help="for Schemathesis itself, after --")
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        asked.folder = folder
        var, log = asked.var or Path(folder, "var"), Path(folder, "log")
        manage(var, "prepare", "--content", str(ROOT / "content"))
        key = manage(var, "shell", "--verbosity", "0", "-c", NEW_KEY).split()[-1]
        process, address = start(var, log)
        try:
            code = fuzz(address, key, asked, asked.tool)
        finally:
            process.terminate()
            process.wait(20)
        faults = log.read_text(errors="replace").count("A turn failed")
    print(f"Faults in the server's log: {faults}")  # noqa: T201
    return code or bool(faults)


if __name__ == "__main__":
    sys.exit(main())
