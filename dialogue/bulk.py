"""Writing the draft in bulk: no record a row, one line in the history about the whole draft."""

from collections.abc import Iterator
from contextlib import contextmanager

from django.utils import timezone

from dialogue.models import DraftVersion
from plans.recording import in_bulk, person

LONGEST = 100


@contextmanager
def written_in_bulk(words: str) -> Iterator[None]:
    """Write rows unrecorded inside the block, then leave the line, e.g. "content loaded"."""
    with in_bulk():
        yield
    note_about_draft(words)


def note_about_draft(words: str) -> None:
    """Leave one line about the whole draft in the history; up to 100 characters."""
    row, _new = DraftVersion.objects.get_or_create(pk=1)
    DraftVersion.history.create(
        id=row.pk,
        number=row.number,
        history_date=timezone.now(),
        history_type="~",
        history_user=person(),
        history_change_reason=words[:LONGEST],
    )
