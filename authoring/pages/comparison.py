"""What every page that shows changes hands to its template."""

from collections.abc import Callable
from typing import Any

from django.http import HttpRequest

from authoring.releases.release_rows import KINDS
from authoring.releases.release_words import groups, headlines
from authoring.releases.releases import Comparison
from dialogue.snapshot import SnapshotError

#: So many changes stand on one page.
MOST_SHOWN = 200


def compared(request: HttpRequest, work: Callable[[], Comparison]) -> dict[str, Any]:
    """Return the changes in their groups; with ?kind=… those of one group only.

    `damaged` is True where a release cannot be read.
    """
    try:
        comparison = work()
    except SnapshotError:
        return {"damaged": True, "groups": [], "headlines": [], "total": 0}
    asked = request.GET.get("kind", "")
    kind = asked if asked in KINDS else ""
    found = groups(comparison.notes, comparison.cultures, MOST_SHOWN, kind)
    total = comparison.notes.total
    shown = sum(len(group.told) for group in found)
    return {
        "damaged": False,
        "groups": found,
        "headlines": headlines(comparison.notes),
        "total": total,
        "shown": shown,
        "kind": kind,
    }
