"""What one can talk with on the pages of the admin: the draft, what is published, a release."""

import threading
from collections import OrderedDict
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

from dialogue.draft import draft_version
from dialogue.engine.concepts import Frame
from dialogue.engine.content import Content
from dialogue.engine.findings import Finding
from dialogue.publishing import NothingPublishedError, NotPublishableError, current, draft, load

DRAFT, PUBLISHED = "draft", "published"
#: So many old releases stay in the memory of a worker.
MOST_RELEASES = 2


class UnknownContentError(LookupError):
    """There is no such content to talk with."""


@dataclass(frozen=True)
class Chosen:
    """Content to talk with.

    `name` is DRAFT or the number of a release; `version` the draft's, else the release's.
    """

    content: Content
    name: str
    version: int

    @cached_property
    def frames(self) -> Mapping[str, Frame]:
        """Return all that can be said by the keys."""
        knowledge = self.content.knowledge
        owners = (*(topic.frames for topic in knowledge.topics), *knowledge.pools.values())
        return {frame.key: frame for frames in owners for frame in frames}

    @property
    def release(self) -> int:
        """Return the number of the release, 0 for the draft."""
        return self.content.number


@dataclass(frozen=True)
class _Draft:
    """The draft at one version: what was built, or the errors that forbid building."""

    version: int
    built: Chosen | None
    errors: tuple[Finding, ...] = ()

    def chosen(self) -> Chosen:
        if self.built is None:
            raise NotPublishableError(list(self.errors))
        return self.built


@dataclass(slots=True)
class _Memory:
    """What this worker has built."""

    draft: _Draft | None = None
    releases: OrderedDict[int, Chosen] = field(default_factory=OrderedDict)


_memory = _Memory()
_building = threading.Lock()


def content_of(name: str) -> Chosen:
    """Return the content of a name.

    Raises NotPublishableError for a draft with errors, NothingPublishedError, SnapshotError for a
    damaged release, UnknownContentError.
    """
    if name == DRAFT:
        return _draft()
    if name == PUBLISHED:
        served = current()
        return _kept(served.number) or _keep(Chosen(served, str(served.number), served.number))
    if not (name.isascii() and name.isdecimal() and len(name) < 10):
        raise UnknownContentError(name)
    return _release(int(name))


def forget() -> None:
    """Keep nothing in memory, as in a new worker."""
    _memory.draft = None
    _memory.releases.clear()


def _draft() -> Chosen:
    version = draft_version()
    kept = _memory.draft
    if kept is None or kept.version != version:
        with _building:
            kept = _memory.draft
            if kept is None or kept.version != version:
                kept = _memory.draft = _build(version)
    return kept.chosen()


def _build(version: int) -> _Draft:
    try:
        return _Draft(version, Chosen(draft(), DRAFT, version))
    except NotPublishableError as error:
        return _Draft(version, None, tuple(error.findings))


def _release(number: int) -> Chosen:
    kept = _kept(number)
    if kept is not None:
        return kept
    with _building:
        try:
            return _kept(number) or _keep(Chosen(load(number), str(number), number))
        except NothingPublishedError as error:
            raise UnknownContentError(str(number)) from error


def _kept(number: int) -> Chosen | None:
    return _memory.releases.get(number)


def _keep(chosen: Chosen) -> Chosen:
    _memory.releases[chosen.version] = chosen
    while len(_memory.releases) > MOST_RELEASES:
        _memory.releases.popitem(last=False)
    return chosen
