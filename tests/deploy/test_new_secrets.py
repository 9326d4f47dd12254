"""new_secrets.py makes secrets that nobody can guess, once, and turns keys."""

import stat
import subprocess
import sys
from pathlib import Path

import pytest

from tests.deploy.files import DEPLOY, documents

PROGRAM = DEPLOY / "docker" / "new_secrets.py"


def _make(folder: Path, *arguments: str) -> None:
    command = [sys.executable, "-I", str(PROGRAM), str(folder), *arguments]
    subprocess.run(command, check=True, capture_output=True, timeout=30)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return a folder of new secrets."""
    _make(tmp_path / "secrets")
    return tmp_path / "secrets"


def _values(folder: Path) -> dict[str, str]:
    return {file.name: file.read_text().strip() for file in folder.iterdir()}


def test_it_makes_what_compose_asks_for_but_the_certificate(folder: Path) -> None:
    (compose,) = documents(DEPLOY / "compose" / "compose.yaml")
    assert set(_values(folder)) == set(compose["secrets"]) - {"tls.crt", "tls.key"}


def test_secrets_are_long_and_all_different(folder: Path, tmp_path: Path) -> None:
    _make(tmp_path / "other")
    values = [*_values(folder).values(), *_values(tmp_path / "other").values()]
    assert len(set(values)) == len(values)
    assert all(len(value) >= 32 for value in values)


def test_the_folder_is_open_to_its_owner_alone(folder: Path) -> None:
    assert stat.S_IMODE(folder.stat().st_mode) == 0o700


def test_the_address_of_the_database_holds_its_password(folder: Path) -> None:
    values = _values(folder)
    password = values["postgres_password"]
    assert values["database_url"] == f"postgresql://cair:{password}@db:5432/cair"


def test_a_database_elsewhere_needs_no_password_of_ours(tmp_path: Path) -> None:
    _make(tmp_path, "--database-url", "postgresql://a:b@c/d")
    assert _values(tmp_path)["database_url"] == "postgresql://a:b@c/d"
    assert "postgres_password" not in _values(tmp_path)


def test_secrets_that_exist_stay(folder: Path) -> None:
    before = _values(folder)
    _make(folder)
    assert _values(folder) == before


@pytest.mark.parametrize("name", ["state_keys", "secret_keys"])
def test_a_new_key_reads_first_and_signs_later(folder: Path, name: str) -> None:
    before = _values(folder)
    _make(folder, "--add-key", name)
    old, new = _values(folder)[name].split(",")
    assert old == before[name]
    assert new != old
    assert len(new) >= 32
    _make(folder, "--use-key", name)
    assert _values(folder) == {**before, name: f"{new},{old}"}
