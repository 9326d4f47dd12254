"""Publish the draft ("rebuild the Dialogue Tree"), roll back, and serve what is published.

A turn never asks the database: each worker holds one immutable Content and a thread of its own
looks for a newer publication once a second, off the path of the requests.
"""

import logging
import threading
from collections.abc import Mapping
from dataclasses import dataclass

import msgspec
from django.conf import settings
from django.db import DatabaseError, close_old_connections, transaction

from dialogue import models
from dialogue.content import read_knowledge
from dialogue.draft import draft_version
from dialogue.engine.checks import check_knowledge
from dialogue.engine.content import Content, build_content
from dialogue.engine.findings import Finding
from dialogue.engine.library_checks import check_library
from dialogue.engine.slots import missing_slots
from dialogue.engine.tree import Tree
from dialogue.garbage import collected_later
from dialogue.snapshot import Snapshot, SnapshotError, checksum, pack, unpack
from plans.content import read_library

logger = logging.getLogger(__name__)


class NotPublishableError(ValueError):
    """The draft has errors; `findings` are all of them."""

    def __init__(self, findings: list[Finding]) -> None:
        super().__init__("\n".join(map(str, findings)))
        self.findings = findings


class NothingPublishedError(LookupError):
    """No publication exists yet."""


class DraftChangedError(RuntimeError):
    """The draft is no longer what the person looked at, or somebody else is publishing it."""

    def __init__(self) -> None:
        super().__init__("The draft has changed meanwhile. Look at the changes and publish again.")


#: The steps of publishing, in their order.
STEPS = ("reading", "checking", "building", "conversations", "storing")


class Watch:
    """Hears how publishing goes on. What `built` raises stops it; then nothing has changed."""

    def step(self, name: str) -> None:
        """Hear that one of STEPS begins."""

    def built(self, content: Content) -> None:
        """Hear of what would be served."""


@collected_later()
def publish(
    *,
    note: str = "",
    author: int | None = None,
    expected: int | None = None,
    watch: Watch | None = None,
) -> models.Publication:
    """Check the draft, compile it to a snapshot, and make it what robots use.

    Raises NotPublishableError with all errors, DraftChangedError where the draft is not at the
    version `expected`; then nothing has changed. A draft that says exactly what the last
    publication says gives that publication again.
    """
    watch = watch or Watch()
    watch.step("reading")
    snapshot = _read_draft(expected)
    watch.step("checking")
    _refuse_errors(snapshot)
    slots = missing_slots(snapshot.knowledge)
    snapshot = _with_slots(snapshot, slots)
    watch.step("building")
    content = build_content(snapshot.knowledge, snapshot.library)
    watch.step("conversations")
    watch.built(content)
    watch.step("storing")
    data, counted = pack(snapshot), counts(snapshot, content.tree)
    with transaction.atomic():
        _give_slots(slots)
        return _store(data, counted, note, author)


@transaction.atomic
def _read_draft(expected: int | None = None) -> Snapshot:
    if expected is not None and draft_version() != expected:
        raise DraftChangedError
    return Snapshot(knowledge=read_knowledge(), library=read_library())


def _refuse_errors(snapshot: Snapshot) -> None:
    errors = [finding for finding in check(snapshot) if finding.error]
    if errors:
        raise NotPublishableError(errors)


def _with_slots(snapshot: Snapshot, slots: Mapping[int, int]) -> Snapshot:
    """Return the snapshot with these slots, by the number of the frame."""
    replace, knowledge = msgspec.structs.replace, snapshot.knowledge
    topics = tuple(
        replace(
            topic,
            frames=tuple(
                replace(frame, slot=slots.get(frame.number, frame.slot)) for frame in topic.frames
            ),
        )
        if any(frame.number in slots for frame in topic.frames)
        else topic
        for topic in knowledge.topics
    )
    return replace(snapshot, knowledge=replace(knowledge, topics=topics))


def _give_slots(slots: Mapping[int, int]) -> None:
    """Give new frames their slots in the dialogue state, for ever."""
    if not slots:
        return
    without = models.Frame.objects.filter(slot=-1).values_list("pk", flat=True)
    if not slots.keys() <= set(without):
        raise DraftChangedError
    frames = [models.Frame(pk=number, slot=slot) for number, slot in slots.items()]
    models.Frame.objects.bulk_update(frames, ["slot"], batch_size=400)


def check(snapshot: Snapshot) -> list[Finding]:
    """Return what the checks find in a draft; errors stop its publication."""
    found = check_knowledge(snapshot.knowledge)
    return [*found, *check_library(snapshot.knowledge, snapshot.library)]


@transaction.atomic
def roll_back(number: int, *, author: int | None = None) -> models.Publication:
    """Publish an old snapshot again, as a new publication.

    Raises NothingPublishedError where it never was, SnapshotError where it is damaged.
    """
    old = models.Publication.objects.filter(pk=number).first()
    if old is None:
        raise NothingPublishedError(f"There is no publication {number}.")
    unpack(bytes(old.data), old.checksum)  # A damaged one must not become the newest.
    return _store(bytes(old.data), old.counts, f"Back to {number}", author)


def _store(
    data: bytes, counted: dict[str, int], note: str, author: int | None
) -> models.Publication:
    last = models.Publication.objects.defer("data").first()
    if last and last.checksum == checksum(data):
        return last
    return models.Publication.objects.create(
        author_id=author, note=note, checksum=checksum(data), counts=counted, data=data
    )


def counts(snapshot: Snapshot, tree: Tree) -> dict[str, int]:
    """Return how many topics, sentences (one a topic and frame) and intents there are."""
    sentences = sum(len(lines) for node in tree.nodes.values() for lines in node.lines.values())
    return {
        "topics": len(tree.nodes),
        "frames": sum(len(topic.frames) for topic in snapshot.knowledge.topics),
        "sentences": sentences,
        "intents": len(snapshot.library.intents),
    }


@collected_later()
def load(number: int | None = None) -> Content:
    """Return the content of a publication, of the newest one without a number."""
    rows = models.Publication.objects.all()
    row = rows.first() if number is None else rows.filter(pk=number).first()
    if row is None:
        raise NothingPublishedError("Nothing is published yet: run manage.py publish.")
    snapshot = unpack(bytes(row.data), row.checksum)
    return build_content(snapshot.knowledge, snapshot.library, row.pk)


@collected_later()
def draft() -> Content:
    """Return the content of the draft, for trying it out. Raises NotPublishableError.

    New sentences have the slots that publishing would give them, so that the same seed gives the
    same talk before and after.
    """
    snapshot = _read_draft()
    _refuse_errors(snapshot)
    snapshot = _with_slots(snapshot, missing_slots(snapshot.knowledge))
    return build_content(snapshot.knowledge, snapshot.library)


@dataclass(slots=True)
class _Served:
    """What this worker serves, and the thread that looks for something newer."""

    content: Content | None = None
    watcher: threading.Thread | None = None


_served = _Served()
_starting = threading.Lock()


def current() -> Content:
    """Return the content to talk with. Raises NothingPublishedError.

    No lock and no query once something is served: one reference is read.
    """
    content = _served.content
    if content is None or _served.watcher is None:
        return _first()
    return content


def served_number() -> int | None:
    """Return the number of the publication this worker serves, None where it serves none yet."""
    return _served.content.number if _served.content else None


def serve(content: Content | None) -> None:
    """Make this the content of the worker: one reference is swapped, running turns keep theirs."""
    _served.content = content


@collected_later()
def preload() -> None:
    """Load the newest publication before the workers are forked, so that they share all of it."""
    try:
        content = load()
        content.catalogue.prepare()
        serve(content)
    except (NothingPublishedError, DatabaseError, SnapshotError) as error:
        logger.warning("Nothing to serve yet: %s", error)


def _first() -> Content:
    with _starting:
        if _served.watcher is None:
            _served.watcher = threading.Thread(target=_watch, name="publications", daemon=True)
            _served.watcher.start()
    if _served.content is None:
        serve(_newest())
    return _served.content or _newest()


def _newest() -> Content:
    """Return the newest publication; one that cannot be read is as good as none."""
    try:
        return load()
    except (DatabaseError, SnapshotError) as error:
        logger.warning("Nothing to serve yet: %s", error)
        raise NothingPublishedError("Nothing can be read yet: run manage.py prepare.") from error


def _watch() -> None:
    pause = threading.Event()
    while not pause.wait(settings.CAIR_POLL_SECONDS):
        try:
            _look()
        except Exception as error:  # noqa: BLE001 - a watch that ends would see nothing ever again
            # The last good content goes on being served; the next look may succeed.
            logger.warning("Cannot take over a newer publication: %r", error)


def _look() -> None:
    try:
        refresh()
    finally:
        close_old_connections()


def refresh() -> bool:
    """Serve the newest publication if it is another one; True where it was swapped."""
    newest = models.Publication.objects.values_list("pk", flat=True).first()
    if newest is None or (_served.content and _served.content.number == newest):
        return False
    serve(load(newest))
    logger.info("Publication %s is served now.", newest)
    return True
