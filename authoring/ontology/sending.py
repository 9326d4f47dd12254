"""The ontology as a file on its way to a person or a program, a piece at a time."""

import zlib
from collections.abc import Iterable, Iterator

from django.http import StreamingHttpResponse

OWL, GZIP = "application/rdf+xml", "application/gzip"
#: The quickest one: an ontology repeats itself so much that more work saves little.
LEVEL = 3


def gzipped(chunks: Iterable[bytes]) -> Iterator[bytes]:
    """Yield the chunks as one gzip file; the same chunks give the same bytes."""
    machine = zlib.compressobj(LEVEL, zlib.DEFLATED, zlib.MAX_WBITS | 16)
    for chunk in chunks:
        if packed := machine.compress(chunk):
            yield packed
    yield machine.flush()


def sent(
    chunks: Iterable[bytes], name: str, *, packed: bool = False, accepts: str = ""
) -> StreamingHttpResponse:
    """Return the answer that sends a file called `name`.owl, with `packed` as `name`.owl.gz.

    `accepts` is the request's Accept-Encoding: a plain file travels compressed where it may.
    """
    on_the_way = not packed and "gzip" in accepts.lower()
    answer = StreamingHttpResponse(
        gzipped(chunks) if packed or on_the_way else iter(chunks),
        content_type=GZIP if packed else OWL,
    )
    ending = ".owl.gz" if packed else ".owl"
    answer["Content-Disposition"] = f'attachment; filename="{name}{ending}"'
    answer["Cache-Control"] = "no-store"
    if not packed:
        answer["Vary"] = "Accept-Encoding"
    if on_the_way:
        answer["Content-Encoding"] = "gzip"
    return answer
