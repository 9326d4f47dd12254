"""What docs/client-guide.md shows works as it stands there."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.server.conftest import ROOT, Server

GUIDE = (ROOT / "docs" / "client-guide.md").read_text(encoding="utf-8")
ADDRESS = "http://127.0.0.1:8000"
SONG = "Play the song Hey Brother"
CHATS = re.findall(r"^    chat/bin/cair-chat (.+)$", GUIDE, re.MULTILINE)


def blocks(language: str) -> list[str]:
    """Return the examples in a language."""
    return re.findall(rf"^```{language}\n(.*?)^```$", GUIDE, re.MULTILINE | re.DOTALL)


def run(
    command: list[str], typed: str, folder: Path, **variables: str
) -> subprocess.CompletedProcess[str]:
    """Run a program in a folder of its own and type these lines."""
    path = {"PYTHONPATH": str(ROOT / "clients" / "python"), "PYTHONIOENCODING": "utf-8"}
    return subprocess.run(
        command,
        input=typed,
        cwd=folder,
        env=os.environ | path | variables,
        capture_output=True,
        text=True,
        encoding="utf-8",
        timeout=60,
    )


def here(code: str, server: Server) -> str:
    """Return an example with this server's address."""
    assert ADDRESS in code
    return code.replace(ADDRESS, f"http://127.0.0.1:{server.port}")


def test_the_client_of_the_standard_library_talks(server: Server, tmp_path: Path) -> None:
    code = here(blocks("python")[0], server)
    assert len([line for line in code.splitlines() if line]) <= 20
    done = run([sys.executable, "-c", code], f"I love music\n{SONG}\nbye\n", tmp_path)
    assert done.returncode == 0, done.stderr
    assert "does: playsong {'title': 'Hey Brother'}" in done.stdout
    assert done.stdout.count("robot:") >= 4
    assert "$" not in done.stdout


def test_the_client_with_the_module_talks_and_keeps_its_state(
    server: Server, tmp_path: Path
) -> None:
    code = here(blocks("python")[1], server)
    done = run([sys.executable, "-c", code], f"I love music\n{SONG}\n", tmp_path)
    assert "plays Hey Brother" in done.stdout, done.stderr
    assert "Sorry" not in done.stdout
    assert done.stderr.rstrip().endswith("EOFError: EOF when reading a line")
    assert (tmp_path / "anna.json").exists()


@pytest.mark.skipif(
    not (shutil.which("curl") and shutil.which("jq")), reason="curl or jq is not installed"
)
def test_every_shell_example_works(server: Server, tmp_path: Path) -> None:
    talk, compressed = (here(block, server) for block in blocks("sh"))
    bash = ["bash", "-euo", "pipefail", "-c"]
    said = run([*bash, talk], f'I love "music"\n{SONG}\n', tmp_path)
    assert said.returncode == 0, said.stderr
    assert 'does: playsong {"title":"Hey Brother"}' in said.stdout
    done = run([*bash, compressed], "", tmp_path)
    assert done.returncode == 0, done.stderr
    assert '"dialogue_sentence"' in done.stdout


@pytest.mark.parametrize("options", CHATS)
def test_each_chat_begins_and_answers(server: Server, tmp_path: Path, options: str) -> None:
    command = [sys.executable, "-m", "cair_chat", *options.split(), "--plain"]
    address = f"http://127.0.0.1:{server.port}"
    done = run(command, "hello\n", tmp_path, CAIR_SERVER=address)
    assert done.returncode == 0, done.stderr
    assert len(done.stdout.splitlines()) >= 3
    assert "$" not in done.stdout


def test_there_is_a_chat_in_each_language() -> None:
    assert [re.findall(r"--language (\w+)", options) for options in CHATS] == [
        ["en"],
        ["it"],
        ["ja"],
    ]


@pytest.mark.parametrize("page", ["client-guide.md", "migrating.md"])
def test_every_link_leads_somewhere(page: str) -> None:
    docs = ROOT / "docs"
    links = re.findall(r"\]\(([^)#:]+)\)", (docs / page).read_text(encoding="utf-8"))
    assert links
    assert not [link for link in links if not (docs / link).exists()]
