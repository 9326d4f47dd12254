"""cair_client under every Python that is installed: the same talk, letter by letter."""

import json
import os
import shutil
import subprocess
from pathlib import Path

import pytest

VERSIONS = ("2.7", "3.6", "3.7", "3.8", "3.9", "3.10", "3.11", "3.12", "3.13", "3.14")
SCRIPT = Path(__file__).with_name("every_python.py")
PYENV = Path(os.environ.get("PYENV_ROOT", Path.home() / ".pyenv")) / "versions"

pytestmark = pytest.mark.server


def answers(python, version):
    """Say whether this is a Python of that version: a shim may be none."""
    show = "import sys; print('%d.%d' % sys.version_info[:2])"
    done = subprocess.run(
        [python, "-c", show], capture_output=True, text=True, check=False, timeout=20
    )
    return done.stdout.strip() == version


def interpreter(version):
    """Return the Python of a version: named in CAIR_PYTHONS, on the PATH, or of pyenv; or None."""
    named = os.environ.get("CAIR_PYTHONS", "").split(os.pathsep)
    on_path = shutil.which(f"python{version}")
    of_pyenv = [str(path) for path in sorted(PYENV.glob(f"{version}.*/bin/python"))]
    tried = [python for python in (*named, on_path, *of_pyenv) if python]
    return next((python for python in tried if answers(python, version)), None)


def talk(python, server, folder):
    """Return the report of every_python.py."""
    folder.mkdir()
    address = f"http://127.0.0.1:{server.port}"
    done = subprocess.run(
        [python, "-W", "error", "-B", str(SCRIPT), address, str(folder / "talk.json")],
        capture_output=True,
        check=False,
        timeout=60,
        env=os.environ | {"PYTHONIOENCODING": "utf-8"},
    )
    assert done.returncode == 0, done.stderr.decode()[-3000:]
    return json.loads(done.stdout)


@pytest.mark.parametrize("version", VERSIONS)
def test_a_talk_is_the_same_under_this_python(version, server, tmp_path):
    python = interpreter(version)
    if python is None:
        pytest.skip(f"No Python {version} on the PATH, in pyenv or in CAIR_PYTHONS.")
    report = talk(python, server, tmp_path / "talk")
    log = report["log"]
    assert "Zoë" in log[0]
    assert "Ecco Perché no" in log
    assert log[-1][1].endswith("？")
    assert log[-1][-1] is True  # restarted
    assert report["all unicode"] is True
    assert report["kept"] == ["talk.json", "talk.json.aside"]
    assert report["errors"] == ["unreachable client.unreachable", "language.unknown"]
    assert report["no tls"] == "client.tls"
