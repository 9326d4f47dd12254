"""cair-client installs from a wheel of its own: the module, its types, the chat, its command."""

import os
import re
import shutil
import subprocess
import sys
import zipfile

import pytest

from tests.clients.conftest import PYTHON_CLIENT

pytestmark = pytest.mark.server


def run(*command, cwd=None):
    return subprocess.run(
        [str(part) for part in command],
        capture_output=True,
        text=True,
        check=False,
        timeout=180,
        cwd=cwd,
        env={name: value for name, value in os.environ.items() if name != "PYTHONPATH"},
    )


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    """Return (a Python of a new virtual environment, the wheel); nothing is left in the tree."""
    folder = tmp_path_factory.mktemp("package")
    source = shutil.copytree(
        PYTHON_CLIENT, folder / "source", ignore=shutil.ignore_patterns("__pycache__", "build")
    )
    assert run(sys.executable, "-m", "venv", folder / "venv").returncode == 0
    python = folder / "venv" / "bin" / "python"
    pip = (python, "-m", "pip", "--disable-pip-version-check")
    wheel = (*pip, "wheel", "--no-deps", "--wheel-dir", folder / "wheels", source)
    here = run(python, "-c", "import setuptools, wheel").returncode == 0
    done = run(*wheel, *(["--no-build-isolation"] if here else []))
    if done.returncode and not here:
        pytest.skip(f"No `wheel` here, and none to be had: {done.stderr.strip()[-200:]}")
    assert done.returncode == 0, done.stderr
    return python, next((folder / "wheels").glob("cair_client-*.whl"))


def test_the_wheel_holds_what_is_needed_and_no_more(built):
    with zipfile.ZipFile(built[1]) as wheel:
        names = {name for name in wheel.namelist() if ".dist-info/" not in name}
        licence = [name for name in wheel.namelist() if name.endswith("LICENSE")]
    chat = {f"cair_chat/{name}.py" for name in ("__init__", "__main__", "chat", "screens")}
    assert names == {"cair_client.py", "cair_client-stubs/__init__.pyi"} | chat
    assert licence


def test_the_wheel_is_for_every_python(built):
    with zipfile.ZipFile(built[1]) as wheel:
        name = next(name for name in wheel.namelist() if name.endswith("METADATA"))
        metadata = wheel.read(name).decode()
    assert re.search(r"Requires-Python: .*>=2\.7", metadata)
    assert "Provides-Extra: cli" in metadata
    assert "-py2.py3-none-any" in built[1].name


def test_the_command_is_there_after_an_installation(built, tmp_path):
    python, wheel = built
    installed = run(python, "-m", "pip", "install", "--no-index", "--no-deps", wheel)
    assert installed.returncode == 0, installed.stderr
    told = run(python.parent / "cair-chat", "--help", cwd=tmp_path)
    assert told.returncode == 0, told.stderr
    assert "--language" in told.stdout
    unreachable = run(python.parent / "cair-chat", "--server", "robot", cwd=tmp_path)
    assert unreachable.returncode == 1
    assert "Traceback" not in unreachable.stderr


def test_the_types_are_those_of_the_module():
    pytest.importorskip("mypy")
    command = (sys.executable, "-m", "mypy.stubtest", "cair_client", "--mypy-config-file")
    done = subprocess.run(
        [*command, os.devnull],
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
        cwd=PYTHON_CLIENT,
        env=os.environ | {"MYPYPATH": ".", "MYPY_CACHE_DIR": os.devnull},
    )
    assert done.returncode == 0, done.stdout
