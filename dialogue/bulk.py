"""What was written in bulk is told in one line of the history, about the whole draft."""

from django.utils import timezone

from dialogue.models import DraftVersion
from plans.recording import person

LONGEST = 100


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
