"""The Pepper walk, against a real server, on a real qi session: clients/naoqi/WALK.md is its log.

CAIR_WRITE_WALK=1 writes the log anew.
"""

import json
import os
import subprocess
from pathlib import Path

import pytest

from tests.clients.naoqi import walk
from tests.clients.naoqi.conftest import CLIENT
from tests.clients.test_python_client_interpreters import VERSIONS, interpreter

WALK = CLIENT / "WALK.md"
LANGUAGES = {"en": "English", "it": "Italian", "ja": "Japanese"}
ABOUT = """# The walk

What a Pepper does that is asked for the usual things, as its services see it: the log of a robot
that only writes down what it would do, in a talk with a real server. A test compares it
(`tests/clients/naoqi/test_naoqi_walk.py`); `CAIR_WRITE_WALK=1` writes it anew. What it says comes
from the server but for its name, so the test compares where it speaks, not the words.
"""


def written(logs):
    parts = [ABOUT]
    parts += [
        f"## {LANGUAGES[language]}\n\n```text\n" + "\n".join(log) + "\n```\n"
        for language, log in logs.items()
    ]
    return "\n".join(parts)


def kept():
    """Return the logs of WALK.md by language."""
    blocks = WALK.read_text(encoding="utf-8").split("```text\n")[1:]
    logs = [block.split("\n```")[0].split("\n") for block in blocks]
    return dict(zip(LANGUAGES, logs, strict=True))


def walked(pepper, address, let_talk, language, folder):
    let_talk(pepper, address, language=language, **walk.prepared(str(folder)))
    return walk.walk(pepper, language)


@pytest.mark.parametrize("language", list(LANGUAGES))
def test_the_walk_is_as_written(pepper, address, let_talk, language, tmp_path):
    log = walked(pepper, address, let_talk, language, tmp_path / "cair")
    if os.environ.get("CAIR_WRITE_WALK"):
        logs = {**(kept() if WALK.exists() else {each: [] for each in LANGUAGES}), language: log}
        WALK.write_text(written(logs), encoding="utf-8")
    assert walk.masked(log) == walk.masked(kept()[language])


def test_nothing_that_only_programs_read_is_said():
    said = [line for log in kept().values() for line in log if line.startswith("says: ")]
    assert len(said) > 30
    assert not [line for line in said if "#" in line or "$" in line or "action" in line]


@pytest.mark.parametrize("version", [one for one in VERSIONS if one in ("2.7", "3.6", "3.13")])
def test_the_walk_is_the_same_under_this_python(version, address, tmp_path):
    python = interpreter(version)
    if python is None:
        pytest.skip(f"No Python {version} on the PATH, in pyenv or in CAIR_PYTHONS.")
    script = str(Path(walk.__file__))
    done = subprocess.run(
        [python, "-W", "error", "-B", script, address, str(tmp_path / "cair"), "ja"],
        capture_output=True,
        check=False,
        timeout=90,
        env=os.environ | {"PYTHONIOENCODING": "utf-8"},
    )
    assert done.returncode == 0, done.stderr.decode()[-3000:]
    assert walk.masked(json.loads(done.stdout)) == walk.masked(kept()["ja"])
