"""What an imported file said beyond the vocabulary: kept, and written out with every export."""

import zlib
from collections import deque

from ontology_io.models import Remainder
from ontology_io.owl.write_remainder import remainder_elements

_ONLY = 1


def remainder_text() -> str:
    """Return the sorted N-Triples of the last import, "" where there are none; one query."""
    row = Remainder.objects.filter(pk=_ONLY).first()
    return row.text if row else ""


def keep_remainder(text: str) -> None:
    """Put these N-Triples in the place of those kept so far. Raises RemainderError."""
    deque(remainder_elements(text), maxlen=0)  # What is kept can be written again.
    data = zlib.compress(text.encode(), 6) if text else b""
    Remainder.objects.update_or_create(pk=_ONLY, defaults={"data": data})
