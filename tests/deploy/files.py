"""What the tests of deploy/ read: the Dockerfile, YAML, the settings that exist."""

import re
from functools import lru_cache
from pathlib import Path
from typing import Any

import yaml

ROOT = Path(__file__).resolve().parent.parent.parent
DEPLOY = ROOT / "deploy"
DOCKERFILE = DEPLOY / "docker" / "Dockerfile"
Document = dict[str, Any]
Step = tuple[str, str]
USER = 10001


def steps(path: Path = DOCKERFILE) -> list[Step]:
    """Return the instructions of a Dockerfile with what follows them, lines joined."""
    lines = [line for line in path.read_text().splitlines() if not line.startswith("#")]
    joined = re.sub(r"\\\n\s*", "", "\n".join(lines))
    return [
        (name, rest.strip())
        for name, _blank, rest in (line.partition(" ") for line in joined.splitlines() if line)
    ]


def stages() -> list[list[Step]]:
    """Return the steps of each stage, without what comes before the first."""
    found: list[list[Step]] = []
    for step in steps():
        if step[0] == "FROM":
            found.append([])
        if found:
            found[-1].append(step)
    return found


def documents(path: Path) -> list[Document]:
    """Return the documents of a YAML file."""
    return [document for document in yaml.safe_load_all(path.read_text()) if document]


@lru_cache(1)
def known_settings() -> frozenset[str]:
    """Return the environment variables that docs/settings.md lists."""
    text = (ROOT / "docs" / "settings.md").read_text()
    return frozenset(re.findall(r"^\| `([A-Z_]+)` \|", text, re.MULTILINE))


def is_known(variable: str) -> bool:
    """Return whether a variable is a setting, or names the file of one."""
    return variable in known_settings() or variable.removesuffix("_FILE") in known_settings()
