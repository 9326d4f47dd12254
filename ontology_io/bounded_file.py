"""Read a file that may be too large or a gzip bomb: never more than a bound."""

import zlib
from pathlib import Path

from ontology_io.owl.limits import OwlError, refusal

_GZIP = b"\x1f\x8b"
_PIECE = 1 << 20


def read_bounded(path: Path, most: int) -> bytes:
    """Return the bytes of a file, inflated where it is gzip; OwlError above `most` bytes."""
    try:
        with path.open("rb") as file:
            data = file.read(most + 1)
    except OSError as error:
        reason = error.strerror or "unknown reason"
        raise refusal(f"{path} cannot be read: {reason}.", "Check the path.") from error
    return inflated(data, most)


def inflated(data: bytes, most: int) -> bytes:
    """Return the bytes, inflated where they are gzip; OwlError above `most` bytes."""
    if len(data) > most:
        raise _too_large(most)
    if not data.startswith(_GZIP):
        return data
    try:
        whole = _inflated(data, most)
    except zlib.error as error:
        raise refusal("The gzip file is damaged.", "Compress it again.") from error
    return whole


def _inflated(data: bytes, most: int) -> bytes:
    found = bytearray()
    machine = zlib.decompressobj(zlib.MAX_WBITS | 16)
    while data and not machine.eof:
        found += machine.decompress(data, _PIECE)
        if len(found) > most:
            raise _too_large(most)
        data = machine.unconsumed_tail
    if not machine.eof:
        raise refusal("The gzip file ends too early.", "Compress it again.")
    return bytes(found)


def _too_large(most: int) -> OwlError:
    return refusal(
        f"The file is larger than {most // 1_000_000} MB.", "Split it, or raise the limit."
    )
