"""What is taken out as an ontology: the draft, or a release by its number."""

from collections.abc import Iterator
from dataclasses import dataclass

from django.utils import timezone

from dialogue.models import Publication
from dialogue.snapshot import SnapshotError
from ontology_io.exporting import export_draft, export_release

MOST_DIGITS = 9


class UnknownReleaseError(LookupError):
    """There is no such release."""


class DamagedReleaseError(ValueError):
    """The release cannot be read."""


@dataclass(frozen=True, slots=True)
class Export:
    """An ontology on its way: the pieces of the file, its name without the ending."""

    chunks: Iterator[bytes]
    name: str


def export(release: str) -> Export:
    """Return a release by its number as people write it, the draft for "".

    Raises UnknownReleaseError or DamagedReleaseError.
    """
    if not release:
        return Export(export_draft(), f"cair-draft-{timezone.localdate().isoformat()}")
    if not (release.isascii() and release.isdecimal() and len(release) <= MOST_DIGITS):
        raise UnknownReleaseError
    try:
        return Export(export_release(int(release)), f"cair-release-{int(release)}")
    except Publication.DoesNotExist as error:
        raise UnknownReleaseError from error
    except SnapshotError as error:
        raise DamagedReleaseError from error
