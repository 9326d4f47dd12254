"""Publishing at the full size: each step, the page before it, and what a release changed.

python benchmarks/publish.py [--topics 3000] [--sentences-per-leaf 2]

It works in a database of its own that is thrown away.
"""

import argparse
import os
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from random import Random
from typing import TYPE_CHECKING, TypeVar

if TYPE_CHECKING:
    from ontology_io.records import KnowledgeBase

Result = TypeVar("Result")
ROOT = Path(__file__).resolve().parent.parent


def timed(what: str, target: str, work: Callable[[], Result]) -> Result:
    """Print how long a step took, and return what it gave."""
    before = time.perf_counter()
    result = work()
    print(f"| {what} | {time.perf_counter() - before:.2f} s | {target} |")
    return result


def main() -> None:
    """Print a table."""
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--topics", type=int, default=3000)
    arguments.add_argument("--sentences-per-leaf", type=int, default=2)
    chosen = arguments.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        os.environ |= {"CAIR_VAR": folder, "DJANGO_SETTINGS_MODULE": "cair_site.settings"}
        os.environ.pop("DATABASE_URL", None)
        sys.path.insert(0, str(ROOT))
        import django

        django.setup()
        from django.core.management import call_command

        call_command("migrate", verbosity=0)
        measure(chosen.topics, chosen.sentences_per_leaf)


def measure(topics: int, sentences_per_leaf: int) -> None:
    """Load a draft of this size, publish it, change some rows, publish again."""
    from authoring.checks.findings import check_now
    from dialogue.models import Publication
    from ontology_io.store import read_base, write_base

    base = world(topics, sentences_per_leaf)
    frames = sum(len(topic.frames) for topic in base.knowledge.topics)
    print("| what | time | target |\n| --- | --- | --- |")
    size = f"{len(base.knowledge.topics)} topics, {frames} sentences a language"
    timed(f"load {size}", "", lambda: write_base(base))
    timed("read the draft", "", read_base)
    publish("publish for the first time")
    print(f"| {Publication.objects.defer('data').get().counts} | | |")
    change_some_rows()
    timed("check the draft, tests and conflicts too", "", check_now)
    timed("check it again", "", check_now)
    compare()


def publish(what: str) -> None:
    """Publish as the page does."""
    from authoring.releases import publish_run
    from dialogue.draft import draft_version

    run = publish_run.begin(None, what, draft_version())
    timed(what, "<= 20 s", lambda: publish_run.carry_out(run))
    assert run.step == publish_run.DONE, (run.step, run.problems)


def change_some_rows() -> None:
    """Change 200 sentences and some likeliness."""
    from dialogue.models import Sentence, TopicInstance

    for row in Random(3).sample(list(Sentence.objects.filter(language="it")[:5000]), 200):
        row.text = f"{row.text} Davvero."
        row.save()
    TopicInstance.objects.filter(pk__in=range(1, 50)).update(likeliness="0.7")


def compare() -> None:
    """Tell changes before and after publishing, and go back."""
    from authoring.releases import releases
    from dialogue.draft import draft_version

    first = releases.newest()
    assert first is not None
    found = timed("what would change, first look", "", lambda: releases.changes_of_draft(first))
    print(f"| changes: {dict(found.notes.counts)} | | |")
    timed("what would change, next look", "", lambda: releases.changes_of_draft(first))
    publish("publish again")
    second = releases.newest()
    assert second is not None
    timed("what a release changed", "", lambda: releases.changes_of_release(second))
    timed("content files of a release", "", lambda: releases.content_files(second))
    timed("make the draft say what it said", "", lambda: releases.take_back(first, draft_version()))


def world(topics: int, sentences_per_leaf: int) -> "KnowledgeBase":
    """Return a made-up knowledge base with the shipped intents."""
    from msgspec.structs import replace

    from benchmarks.tree import World
    from dialogue.engine.concepts import Culture
    from ontology_io.files.folder import read_folder
    from ontology_io.records import KnowledgeBase

    class Talkative(World):
        def _leaf(self, parent: str) -> None:
            self._topic(parent, f"Leaf{len(self.topics)}", "cwqpnwcqpn"[:sentences_per_leaf])

    made = Talkative(topics, 8).knowledge()
    names = {one.code: {"en": one.code} for one in made.cultures}
    knowledge = replace(
        made,
        cultures=tuple(
            Culture(code=one.code, names=names[one.code], language="en") for one in made.cultures
        ),
        topics=tuple(
            replace(one, frames=tuple(replace(frame, slot=-1, number=0) for frame in one.frames))
            for one in made.topics
        ),
        pools={
            name: tuple(
                replace(frame, key=f"{name}.{place}", type=name, number=0, slot=-1)
                for place, frame in enumerate(frames)
            )
            for name, frames in made.pools.items()
        },
    )
    library = read_folder(ROOT / "content").base.library
    return KnowledgeBase(knowledge=knowledge, library=library)


if __name__ == "__main__":
    main()
