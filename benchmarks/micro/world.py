"""What the benchmarks work on: the shipped content, the same padded to the paper's size, talks."""

from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING
from wsgiref.types import WSGIApplication

from benchmarks.micro import site
from benchmarks.paper.content import ROOT, padded
from dialogue.engine.content import Content, build_content
from dialogue.engine.state import DialogueState
from dialogue.snapshot import Snapshot
from ontology_io.files.folder import read_folder
from ontology_io.records import KnowledgeBase
from tests.engine.plans.chat import CHAT

if TYPE_CHECKING:
    from benchmarks.paper.talks import Stage

COVERED = (0, 50, 926, 1_853, 2_780)
KEYS = (site.STATE_KEY.encode(),)
#: The paper experiments' five, then ordinary talk. Few, so that a round is over before others
#: get the processor.
SENTENCES = ("yes", "no", "I do not know", "my sister liked it", "I love dogs", *CHAT["en"][:5])


class World:
    """Everything is made when it is first asked for; `var` is a folder of its own."""

    def __init__(self, var: Path) -> None:
        self.var = var
        self._published = False

    @cached_property
    def shipped(self) -> KnowledgeBase:
        """The content as it is shipped."""
        return read_folder(ROOT / "content").base

    @cached_property
    def snapshot(self) -> Snapshot:
        """The shipped content, padded with invented topics."""
        return padded()

    @cached_property
    def content(self) -> Content:
        """The padded content, ready to talk with."""
        site.set_up(self.var)
        return build_content(self.snapshot.knowledge, self.snapshot.library, 1)

    def publish(self) -> Path:
        """Return the folder with a database in which the padded content is published."""
        if not self._published:
            site.publish(self.snapshot, len(self.content.tree.nodes))
            self._published = True
        return self.var

    @cached_property
    def application(self) -> WSGIApplication:
        """The site as gunicorn sees it, serving the padded content."""
        self.publish()
        return site.with_echo()

    @cached_property
    def states(self) -> dict[int, DialogueState]:
        """The states of one talk when it has covered so many topics."""
        stages = self._talk()
        return {mark: stage.state for mark, stage in zip(COVERED, stages, strict=True)}  # type: ignore[misc]

    def _talk(self) -> "list[Stage]":
        content = self.content
        from benchmarks.paper import talks

        return list(talks.ours(content, list(COVERED)))
