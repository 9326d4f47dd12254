"""python -m benchmarks.growth.size TOPICS SENTENCES INTENTS: a fresh process, figures as JSON.

Publishing and loading without the database: what is computed, in CPU seconds. Memory is what the
process holds when it has loaded a publication and no more than that.
"""

import gc
import json
import os
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

from benchmarks.growth.contents import knowledge_of
from benchmarks.growth.rows import LOAD, MEMORY, PUBLISH
from dialogue.engine.checks import check_knowledge
from dialogue.engine.content import Content, build_content
from dialogue.engine.library_checks import check_library
from dialogue.garbage import collected_later
from dialogue.snapshot import Snapshot, checksum, pack, unpack
from plans.engine.intents import Library

ROOT = Path(__file__).resolve().parent.parent.parent
Result = TypeVar("Result")


def snapshot_of(topics: int, sentences: int, intents: int) -> Snapshot:
    """Return invented topics with invented intents."""
    return Snapshot(knowledge=knowledge_of(topics, sentences), library=library_of(intents))


def library_of(intents: int) -> Library:
    """Return so many invented intents of twenty triggers in each language."""
    if not intents:
        return Library()
    from benchmarks.matching.synthetic import World

    return World(intents).library


@collected_later()
def published(snapshot: Snapshot) -> bytes:
    """Check, build and pack, as publishing does."""
    check_knowledge(snapshot.knowledge)
    check_library(snapshot.knowledge, snapshot.library)
    build_content(snapshot.knowledge, snapshot.library)
    return pack(snapshot)


@collected_later()
def loaded(data: bytes) -> Content:
    """Read and build, as a worker does when it starts."""
    snapshot = unpack(data, checksum(data))
    return build_content(snapshot.knowledge, snapshot.library)


def timed(work: Callable[[], Result]) -> tuple[float, Result]:
    """Return the seconds of CPU time of the work, and what it gave."""
    begin = time.process_time()
    result = work()
    return time.process_time() - begin, result


def _resident() -> float:
    pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 1024**2


def _publishing(file: Path, sizes: list[int]) -> dict[str, float]:
    snapshot = snapshot_of(*sizes)
    seconds, data = timed(lambda: published(snapshot))
    file.write_bytes(data)
    return {PUBLISH: seconds}


def _loading(file: Path) -> dict[str, float]:
    data = file.read_bytes()
    before = _resident()
    seconds, content = timed(lambda: loaded(data))
    gc.collect()
    assert content.tree.nodes
    return {LOAD: seconds, MEMORY: _resident() - before}


def figures_of(file: Path, topics: int, sentences: int = 2, intents: int = 0) -> dict[str, float]:
    """Return the seconds of publishing and loading and the megabytes held, by fresh processes."""
    found: dict[str, float] = {}
    for sizes in ([str(topics), str(sentences), str(intents)], []):
        command = [sys.executable, "-m", __name__, str(file), *sizes]
        done = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True)
        found |= json.loads(done.stdout)
    return found


if __name__ == "__main__":
    where, *asked = sys.argv[1:]
    print(
        json.dumps(
            _publishing(Path(where), list(map(int, asked))) if asked else _loading(Path(where))
        )
    )
