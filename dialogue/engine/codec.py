"""The opaque text of a state: signed, compressed, safe to take back from anybody.

base64url of: 16 bytes of keyed BLAKE2b over the rest | version | header | body.
"""

import binascii
from collections.abc import Sequence
from hashlib import blake2b
from hmac import compare_digest

from msgspec.structs import replace

from dialogue.engine.codec_columns import body, read_body
from dialogue.engine.codec_header import header, read_header
from dialogue.engine.codec_wire import Reader, StateError
from dialogue.engine.state import DialogueState

__all__ = ["StateError", "decode", "encode"]

VERSION = 1
SHORTEST_KEY = 16

_TAG = 16
_PERSON = b"cair.state"
_TO_URL = bytes.maketrans(b"+/", b"-_")
# "+" and "/" become "!", which base64 refuses.
_FROM_URL = bytes.maketrans(b"-_+/", b"+/!!")


def encode(state: DialogueState, keys: Sequence[bytes]) -> str:
    """Return the state as ASCII text, signed with the first key.

    Raises ValueError where a field is out of its range (see `Pending.cut_to_fit`).
    """
    data = bytes((VERSION,)) + header(state) + body(state.levels, state.used, state.topics)
    signed = _tag(data, keys[0]) + data
    encoded = binascii.b2a_base64(signed, newline=False).translate(_TO_URL)
    return encoded.rstrip(b"=").decode("ascii")


def decode(
    text: str | bytes,
    keys: Sequence[bytes],
    *,
    longest: int = 64_000,
    inflated: int = 4_000_000,
) -> DialogueState:
    """Return the state that one of the keys signed, or raise StateError.

    Nothing is interpreted before the signature is verified; columns come back without
    zeros at their ends.
    """
    if len(text) > longest:
        raise StateError("state.too_large")
    signed = _unwrapped(text)
    tag, data = signed[:_TAG], signed[_TAG:]
    if not any(compare_digest(tag, _tag(data, key)) for key in keys):
        raise StateError("state.damaged")
    if data[0] != VERSION:
        raise StateError("state.version")
    reader = Reader(data)
    reader.position = 1
    state = read_header(reader)
    topics, levels, used = read_body(reader, inflated)
    return replace(state, topics=topics, levels=levels, used=used)


def _unwrapped(text: str | bytes) -> bytes:
    try:
        encoded = text.encode("ascii") if isinstance(text, str) else text
        plain = encoded.translate(_FROM_URL)
        signed = binascii.a2b_base64(plain + b"=" * (-len(plain) % 4), strict_mode=True)
    except (UnicodeEncodeError, binascii.Error) as error:
        raise StateError("state.unreadable") from error
    # Base64 can write the same last bytes in several ways; ours is the only one that is read.
    spare = len(signed) % 3
    last = binascii.b2a_base64(signed[-spare:], newline=False) if spare else b""
    if len(signed) <= _TAG or plain[len(signed) // 3 * 4 :] != last.rstrip(b"="):
        raise StateError("state.unreadable")
    return signed


def _tag(data: bytes, key: bytes) -> bytes:
    if len(key) < SHORTEST_KEY:
        raise ValueError(f"A key has {SHORTEST_KEY} bytes or more, this one {len(key)}.")
    short = key if len(key) <= blake2b.MAX_KEY_SIZE else blake2b(key).digest()
    return blake2b(data, digest_size=_TAG, key=short, person=_PERSON).digest()
