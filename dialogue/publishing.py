"""Publish the draft ("rebuild the Dialogue Tree"), roll back, and serve what is published.

A turn never asks the database: each worker holds one immutable Content and a thread of its own
looks for a newer publication once a second, off the path of the requests.
"""

import logging
import threading
from dataclasses import dataclass

from django.conf import settings
from django.db import DatabaseError, close_old_connections, transaction

from dialogue import models
from dialogue.content import read_knowledge
from dialogue.engine.build import build_tree
from dialogue.engine.checks import check_knowledge
from dialogue.engine.content import Content, build_content
from dialogue.engine.findings import Finding
from dialogue.engine.library_checks import check_library
from dialogue.engine.slots import missing_slots
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


@transaction.atomic
def publish(*, note: str = "", author: int | None = None) -> models.Publication:
    """Check the draft, compile it to a snapshot, and make it what robots use.

    Raises NotPublishableError with all errors; then nothing has changed. A draft that says exactly
    what the last publication says gives that publication again.
    """
    give_slots()
    snapshot = _checked_draft()
    return _store(pack(snapshot), counts(snapshot), note, author)


def _checked_draft() -> Snapshot:
    """Return the draft; NotPublishableError with all its errors where it has some."""
    snapshot = Snapshot(knowledge=read_knowledge(), library=read_library())
    errors = [finding for finding in check(snapshot) if finding.error]
    if errors:
        raise NotPublishableError(errors)
    return snapshot


def check(snapshot: Snapshot) -> list[Finding]:
    """Return what the checks find in a draft; errors stop its publication."""
    found = check_knowledge(snapshot.knowledge)
    return [*found, *check_library(snapshot.knowledge, snapshot.library)]


def give_slots() -> None:
    """Give every new frame its slot in the dialogue state."""
    slots = missing_slots(read_knowledge())
    frames = [models.Frame(pk=number, slot=slot) for number, slot in slots.items()]
    models.Frame.objects.bulk_update(frames, ["slot"], batch_size=400)


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


def counts(snapshot: Snapshot) -> dict[str, int]:
    """Return how many topics, sentences (one a topic and frame) and intents there are."""
    tree = build_tree(snapshot.knowledge)
    sentences = sum(len(lines) for node in tree.nodes.values() for lines in node.lines.values())
    return {
        "topics": len(tree.nodes),
        "frames": sum(len(topic.frames) for topic in snapshot.knowledge.topics),
        "sentences": sentences,
        "intents": len(snapshot.library.intents),
    }


def load(number: int | None = None) -> Content:
    """Return the content of a publication, of the newest one without a number."""
    rows = models.Publication.objects.all()
    row = rows.first() if number is None else rows.filter(pk=number).first()
    if row is None:
        raise NothingPublishedError("Nothing is published yet: run manage.py publish.")
    snapshot = unpack(bytes(row.data), row.checksum)
    return build_content(snapshot.knowledge, snapshot.library, row.pk)


def draft() -> Content:
    """Return the content of the draft, for trying it out. Raises NotPublishableError."""
    snapshot = _checked_draft()
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


def serve(content: Content | None) -> None:
    """Make this the content of the worker: one reference is swapped, running turns keep theirs."""
    _served.content = content


def preload() -> None:
    """Load the newest publication before the workers are forked, so that they share it."""
    try:
        serve(load())
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
