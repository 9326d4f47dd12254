"""python -m benchmarks.paper.prepare FOLDER: what the experiments need, made once and kept.

The folder gets `var/` (a database with the padded content published), `states.json` (the dialogue
states of real talks) and `baseline.json` (the lists of the baseline).
"""

import hashlib
import json
import os
import sys
from pathlib import Path

from benchmarks.paper.content import ROOT, padded
from dialogue.engine.content import Content, build_content
from dialogue.snapshot import Snapshot, checksum, pack

#: The server must be able to read the states, so both have this key.
STATE_KEY = "a-key-of-the-benchmarks-of-32-bytes"
VARIABLES = {"CAIR_STATE_KEYS": STATE_KEY, "DJANGO_SETTINGS_MODULE": "cair_site.settings"}
SOURCES = ("benchmarks", "content", "dialogue", "plans", "languages")
Json = dict[str, object]


def fingerprint() -> str:
    """Return what changes as soon as content or code that makes the states changes."""
    digest = hashlib.sha256()
    for folder in SOURCES:
        for file in sorted((ROOT / folder).rglob("*")):
            if file.suffix in {".py", ".yaml", ".txt", ".csv", ".json"}:
                digest.update(str(file.relative_to(ROOT)).encode() + file.read_bytes())
    return digest.hexdigest()[:16]


def marks(topics: int) -> list[int]:
    """Return the numbers of covered topics of the paper: none, a third, two thirds, all."""
    return [0, topics // 3, 2 * topics // 3, topics]


def prepare(folder: Path) -> None:
    """Fill the folder."""
    folder.mkdir(parents=True, exist_ok=True, mode=0o700)
    os.environ |= VARIABLES | {"CAIR_VAR": str(folder / "var")}
    os.environ.pop("DATABASE_URL", None)
    import django

    django.setup()
    snapshot = padded()
    content = build_content(snapshot.knowledge, snapshot.library, 1)
    _publish(snapshot, content)
    _write_states(folder, content)


def _publish(snapshot: Snapshot, content: Content) -> None:
    from django.core.management import call_command

    from dialogue.models import Publication
    from dialogue.publishing import counts

    call_command("migrate", verbosity=0, interactive=False)
    data = pack(snapshot)
    Publication.objects.create(
        note="The content of the experiments",
        checksum=checksum(data),
        counts=counts(snapshot, content.tree),
        data=data,
    )


def _write_states(folder: Path, content: Content) -> None:
    from benchmarks.baseline.data import compiled
    from benchmarks.baseline.export import lists
    from benchmarks.paper import talks
    from dialogue.turns import write_state

    made, wanted = lists(content), marks(len(content.tree.nodes))
    ours = [
        one._asdict() | {"state": write_state(one.state)} for one in talks.ours(content, wanted)
    ]
    theirs = [one._asdict() for one in talks.baseline(compiled(made), wanted)]
    (folder / "baseline.json").write_text(json.dumps(made), encoding="utf-8")
    states = {
        "topics": len(content.tree.nodes),
        "sentences": sum(len(topic["sentences"]) for topic in made["topics"]),
        "cair": ours,
        "baseline": theirs,
    }
    (folder / "states.json").write_text(json.dumps(states), encoding="utf-8")


if __name__ == "__main__":
    prepare(Path(sys.argv[1]))
