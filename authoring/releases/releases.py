"""Releases as people see them: what each changed, and going back; computed once a worker."""

import io
import threading
import zipfile
from collections import OrderedDict
from collections.abc import Callable
from dataclasses import dataclass

from django.db import transaction
from django.db.models import QuerySet
from django.utils.translation import gettext

from authoring.releases.release_notes import Notes, notes
from dialogue.content import read_knowledge
from dialogue.draft import draft_version
from dialogue.engine.concepts import Culture
from dialogue.garbage import collected_later
from dialogue.models import Frame, Publication
from dialogue.publishing import DraftChangedError, served_number
from dialogue.snapshot import Snapshot, unpack
from ontology_io.files.folder import folder_texts
from ontology_io.numbering import last_numbers
from ontology_io.records import KnowledgeBase
from ontology_io.store import write_base
from plans.content import read_library

#: So many comparisons are kept in a worker.
MOST_KEPT = 16
#: With more sentences a draft is not compared while a page waits for it.
LARGE = 8000


@dataclass(frozen=True, slots=True)
class Comparison:
    """What changes between two releases, or from one to the draft; the cultures of the new one."""

    notes: Notes
    cultures: tuple[Culture, ...]


_kept: OrderedDict[tuple[str, str], Comparison] = OrderedDict()
_lock = threading.Lock()


def rows() -> QuerySet[Publication]:
    """Return the releases, the newest first, without their data."""
    return Publication.objects.defer("data").select_related("author")


def release(number: int) -> Publication:
    """Return a release without its data. Raises ObjectDoesNotExist."""
    return rows().get(pk=number)


def newest() -> Publication | None:
    """Return the newest release."""
    return rows().first()


def before(row: Publication) -> Publication | None:
    """Return the release before another one."""
    return rows().filter(pk__lt=row.pk).first()


def now_served() -> int | None:
    """Return the number of the release that robots talk with, None where there is none."""
    served = served_number()
    return served if served is not None else rows().values_list("pk", flat=True).first()


def snapshot(row: Publication) -> Snapshot:
    """Return what a release says. Raises SnapshotError where it is damaged."""
    data = Publication.objects.values_list("data", flat=True).get(pk=row.pk)
    return unpack(bytes(data), row.checksum)


@collected_later()
def draft_snapshot() -> Snapshot:
    """Return what the draft says now."""
    return Snapshot(knowledge=read_knowledge(), library=read_library())


def changes_of_release(row: Publication) -> Comparison:
    """Return what a release changed. Raises SnapshotError where it or the one before is damaged."""
    return changes_between(before(row), row)


def changes_between(old: Publication | None, new: Publication) -> Comparison:
    """Return what changes from one release to another. Raises SnapshotError."""
    key = (old.checksum if old else "", new.checksum)
    return _once(key, lambda: _compared(_said(old), snapshot(new)))


def changes_of_draft(old: Publication | None) -> Comparison:
    """Return what publishing the draft would change. Raises SnapshotError."""
    return _once(_of_draft(old), lambda: _compared(_said(old), draft_snapshot()))


def takes_long(old: Publication | None) -> bool:
    """Say whether the draft is large and this worker has not compared it yet."""
    if _of_draft(old) in _kept:
        return False
    return Frame.objects.count() > LARGE


def _of_draft(old: Publication | None) -> tuple[str, str]:
    return (old.checksum if old else "", f"draft {draft_version()}")


def changes_of_taking_back(row: Publication) -> Comparison:
    """Return what changes in the draft when it is made to say what a release says."""
    key = (f"draft {draft_version()}", row.checksum)
    return _once(key, lambda: _compared(draft_snapshot(), snapshot(row)))


def _said(row: Publication | None) -> Snapshot | None:
    return snapshot(row) if row else None


@collected_later()
def _compared(old: Snapshot | None, new: Snapshot) -> Comparison:
    cultures = {one.code: one for one in (old.knowledge.cultures if old else ())}
    cultures |= {one.code: one for one in new.knowledge.cultures}
    return Comparison(notes(old, new), tuple(cultures.values()))


def _once(key: tuple[str, str], work: Callable[[], Comparison]) -> Comparison:
    """Return what was computed for this key before; else compute it, one thread at a time."""
    with _lock:
        found = _kept.get(key)
        if found is None:
            found = _kept[key] = work()
            while len(_kept) > MOST_KEPT:
                _kept.popitem(last=False)
        _kept.move_to_end(key)
        return found


def content_files(row: Publication) -> bytes:
    """Return a .zip of the content files that say what a release says. Raises SnapshotError."""
    held = snapshot(row)
    base = KnowledgeBase(knowledge=held.knowledge, library=held.library)
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in sorted(folder_texts(base, last_numbers()).items()):
            entry = zipfile.ZipInfo(f"content/{name}", row.created.timetuple()[:6])
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, text.encode())
    return file.getvalue()


@collected_later()
def take_back(row: Publication, expected: int) -> None:
    """Make the draft say what a release says, all or nothing.

    Raises SnapshotError where the release is damaged, DraftChangedError where the draft is not at
    the version that the person looked at.
    """
    held = snapshot(row)
    told = gettext("The draft says what release %(number)s said.") % {"number": row.pk}
    with transaction.atomic():
        if draft_version() != expected:
            raise DraftChangedError
        write_base(KnowledgeBase(knowledge=held.knowledge, library=held.library), told=told)
