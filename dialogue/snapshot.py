"""A publication's bytes: a knowledge base as compressed msgpack, with a version and a checksum."""

import hashlib
import zlib

import msgspec

from dialogue.engine.concepts import Knowledge
from plans.engine.intents import Library

FORMAT = 1
_MAGIC = b"CAIR"


class Snapshot(msgspec.Struct, frozen=True, kw_only=True):
    """What a publication holds."""

    knowledge: Knowledge
    library: Library


class SnapshotError(ValueError):
    """A publication that cannot be read: damaged, or of a newer format."""


def pack(snapshot: Snapshot) -> bytes:
    """Return the bytes to store; the same snapshot gives the same bytes."""
    return _MAGIC + bytes((FORMAT,)) + zlib.compress(msgspec.msgpack.encode(snapshot), 6)


def checksum(data: bytes) -> str:
    """Return the SHA-256 of a publication's bytes in hexadecimal."""
    return hashlib.sha256(data).hexdigest()


def unpack(data: bytes, expected: str) -> Snapshot:
    """Return the snapshot, or raise SnapshotError where it is not what was stored."""
    if checksum(data) != expected:
        raise SnapshotError("The publication is damaged: its checksum differs. Publish again.")
    if data[:5] != _MAGIC + bytes((FORMAT,)):
        raise SnapshotError(f"The publication has another format than {FORMAT}. Publish again.")
    try:
        return msgspec.msgpack.decode(zlib.decompress(data[5:]), type=Snapshot)
    except (zlib.error, msgspec.MsgspecError) as error:
        raise SnapshotError("The publication cannot be read. Publish again.") from error
