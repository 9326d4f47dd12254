"""The draft or a release as an ontology: what the pages, the API and the command send out."""

from collections.abc import Iterator
from dataclasses import dataclass

from django.conf import settings
from django.db import transaction

from dialogue.models import Publication
from dialogue.snapshot import unpack
from ontology_io.numbering import highest_numbers, last_numbers
from ontology_io.owl.export import owl_bytes
from ontology_io.records import KnowledgeBase
from ontology_io.remainder import remainder_text
from ontology_io.store import read_base


@dataclass(frozen=True, slots=True)
class Export:
    """What is written (`base`, called `version`), and its bytes in chunks, to be taken once."""

    base: KnowledgeBase
    version: str
    chunks: Iterator[bytes]

    def counts(self) -> dict[str, int]:
        """Return how many there are of what a researcher counts."""
        knowledge, library = self.base.knowledge, self.base.library
        frames = [frame for topic in knowledge.topics for frame in topic.frames]
        for pool in knowledge.pools.values():
            frames += pool
        return {
            "topics": len(knowledge.topics),
            "individuals": sum(len(topic.likeliness) for topic in knowledge.topics),
            "sentences": sum(len(frame.texts) for frame in frames),
            "intents": len(library.intents),
        }


def draft() -> Export:
    """Return the whole draft, with what imports kept beyond the vocabulary."""
    with transaction.atomic():
        base, highest, remainder = read_base(), last_numbers(), remainder_text()
    iri, version = settings.CAIR_ONTOLOGY_IRI, "draft"
    chunks = owl_bytes(base, iri=iri, version=version, highest=highest, remainder=remainder)
    return Export(base, version, chunks)


def release(number: int) -> Export:
    """Return what a release says; what imports kept beyond the vocabulary is not part of one.

    Raises Publication.DoesNotExist, or SnapshotError where it is damaged.
    """
    row = Publication.objects.get(pk=number)
    snapshot = unpack(bytes(row.data), row.checksum)
    base = KnowledgeBase(knowledge=snapshot.knowledge, library=snapshot.library)
    iri, version = settings.CAIR_ONTOLOGY_IRI, f"release {number}"
    chunks = owl_bytes(base, iri=iri, version=version, highest=highest_numbers(base))
    return Export(base, version, chunks)


def export_draft() -> Iterator[bytes]:
    """Return the bytes of the draft in chunks; the rows are read at the call."""
    return draft().chunks


def export_release(number: int) -> Iterator[bytes]:
    """Return the bytes of a release in chunks.

    Raises, at the call, Publication.DoesNotExist, or SnapshotError where it is damaged.
    """
    return release(number).chunks
