"""OWLAPI, the library below Protégé, which comes with owlready2; it needs a Java compiler."""

import shutil
import subprocess
from pathlib import Path

import owlready2
import pytest

JARS = Path(owlready2.__file__).parent / "pellet"
PROGRAM = Path(__file__).with_name("DlProfile.java")
SECONDS = 120

needs_java = pytest.mark.skipif(
    not shutil.which("java") or not shutil.which("javac"),
    reason="needs a Java development kit: apt-get install default-jdk-headless",
)


def owlapi(*files: Path) -> list[str]:
    """Return what OWLAPI tells of the first file, a line each; with a second one, save it there."""
    jars = ":".join(map(str, JARS.glob("*.jar")))
    command = ["java", "-Xmx500M", "-cp", jars, str(PROGRAM), *map(str, files)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()
