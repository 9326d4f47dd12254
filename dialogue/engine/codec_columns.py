"""The second part of a state's text: likeliness and sentences said, as few bytes as possible.

Only covered topics are written: which ones, then their levels, then their masks. Two layouts:

* *rows*, for few topics: gaps between topics as an Exp-Golomb code (neighbours are near, the
  rest far away), levels as half bytes, masks as bytes;
* *columns*: a bit per topic, then one byte per covered topic and column, all deflated.
"""

import re
import zlib
from collections.abc import Sequence
from operator import sub

from dialogue.engine.codec_covered import gathered, spread
from dialogue.engine.codec_wire import Reader, StateError, bits, number, numbers, within
from dialogue.engine.state import MAX_SLOT, MAX_TOPIC, TOPIC_RING, union

MAX_LEVEL = 11
MAX_COLUMNS = (MAX_SLOT + 1) // 8
ROWS_ONLY = 96  # deflate hardly ever wins below
MAX_ROWS = 512  # rows are never tried above: columns always win there

_NOTHING, _ROWS, _COLUMNS = 0, 1, 2
_ZERO_OR_ONE = b"0" + b"1" * 255
_VALID_LEVELS = bytes(range(MAX_LEVEL + 1))
_COVERED = re.compile(rb"\0*([^\0])")
_WHOLE, _PARTLY = b"\1", b"\0"
_ZEROS = ("", *("0" * zeros + "1" for zeros in range(MAX_TOPIC.bit_length() + 1)))

Columns = tuple[tuple[int, ...], bytes, tuple[bytes, ...]]


def body(levels: bytes, used: Sequence[bytes], started: Sequence[int]) -> bytes:
    """Return the shorter of both layouts, with the last topics started."""
    cover = union((levels, *used)).rstrip(b"\0")
    if len(cover) > MAX_TOPIC + 1 or len(used) > MAX_COLUMNS or not _valid(levels):
        raise ValueError("The columns hold a topic, slot or level out of range.")
    count = len(cover) - cover.count(0)
    if not count:
        return bytes((_NOTHING,)) + _ring(started)
    columns = (levels, *used)
    if count <= ROWS_ONLY:
        return _as_rows(cover, columns, started)
    packed = _as_columns(cover, columns, count, started)
    if count > MAX_ROWS or _shortest_rows(used, count) >= len(packed):
        return packed
    return min(packed, _as_rows(cover, columns, started), key=len)


def read_body(reader: Reader, inflated: int) -> Columns:
    """Return started, levels and used, never inflating beyond the limit, or raise StateError."""
    kind = reader.number(_COLUMNS)
    if kind == _ROWS:
        started, columns = _read_rows(reader)
    else:
        started = reader.numbers(TOPIC_RING, MAX_TOPIC)
        columns = _read_columns(reader, inflated) if kind == _COLUMNS else [b""]
    if reader.position < len(reader.data):
        raise StateError("state.damaged")
    columns = [column.rstrip(b"\0") for column in columns]
    while len(columns) > 1 and not columns[-1]:
        columns.pop()
    if not _valid(columns[0]):
        raise StateError("state.damaged")
    return started, columns[0], tuple(columns[1:])


def _ring(topics: Sequence[int]) -> bytes:
    return numbers(topics, TOPIC_RING, MAX_TOPIC)


def _valid(levels: bytes) -> bool:
    return not levels.translate(None, _VALID_LEVELS)


def _as_columns(
    cover: bytes, columns: Sequence[bytes], count: int, started: Sequence[int]
) -> bytes:
    if 16 * count > 15 * len(cover):
        # Nearly all: one zero more per gap and column is cheaper than skipping the gaps.
        cover, count = b"\1" * len(cover), len(cover)
    # Run-length matches suffice: neighbours in a column have little in common but being equal.
    packer = zlib.compressobj(9, zlib.DEFLATED, -zlib.MAX_WBITS, zlib.DEF_MEM_LEVEL, zlib.Z_RLE)
    pieces = [
        bytes((_COLUMNS,)),
        _ring(started),
        number(len(columns) - 1),
        number(len(cover)),
        packer.compress(bits(cover.translate(_ZERO_OR_ONE).decode("ascii"))),
    ]
    for column in gathered(columns, cover, count):
        # A new block has a Huffman table of its own, made for this column.
        pieces.append(packer.flush(zlib.Z_BLOCK))
        pieces.append(packer.compress(column))
    pieces.append(packer.flush())
    return b"".join(pieces)


def _read_columns(reader: Reader, inflated: int) -> list[bytes]:
    width = reader.number(MAX_COLUMNS) + 1
    span = reader.number(MAX_TOPIC + 1)
    largest = (span + 7) // 8 + span * width
    if largest > inflated:
        raise StateError("state.too_large")
    parts = Reader(_inflate(reader.rest(), largest))
    presence = parts.bits(span)
    count = presence.count("1")
    columns = [parts.take(count) for _ in range(width)]
    if parts.rest():
        raise StateError("state.damaged")
    return spread(columns, presence, count)


def _inflate(data: bytes, largest: int) -> bytes:
    unpacker = zlib.decompressobj(-zlib.MAX_WBITS)
    try:
        inflated = unpacker.decompress(data, largest + 1)
    except zlib.error as error:
        raise StateError("state.damaged") from error
    if not unpacker.eof or unpacker.unused_data:
        raise StateError("state.damaged")
    return inflated


def _shortest_rows(used: Sequence[bytes], count: int) -> int:
    """Return how many bytes rows take at the very least: levels, masks, a bit a gap."""
    presence = (count + 7) // 8
    length = (count + 1) // 2 + presence
    for column in used:
        said = len(column) - column.count(0)
        length += said + (presence if said < count else 0)
    return length


def _as_rows(cover: bytes, columns: Sequence[bytes], started: Sequence[int]) -> bytes:
    topics = [found.start(1) for found in _COVERED.finditer(cover)]
    levels, *masks = [
        bytes(map(column.ljust(len(cover), b"\0").__getitem__, topics)) for column in columns
    ]
    pieces = [bytes((_ROWS, len(masks))), number(len(topics)), _halves(levels)]
    for column in masks:
        # Few topics have more than eight sentences: a bit says which have bits in this column.
        presence = column.translate(_ZERO_OR_ONE).decode("ascii")
        pieces.append(_WHOLE if "0" not in presence else _PARTLY + bits(presence))
        pieces.append(column.translate(None, b"\0"))
    pieces.append(_ranks(started, topics))
    pieces.append(_gaps(topics))
    return b"".join(pieces)


def _ranks(started: Sequence[int], topics: Sequence[int]) -> bytes:
    # The topics started are mostly covered ones: the tenth of fifty is a shorter number.
    rank = {topic: rank for rank, topic in enumerate(topics)}
    if all(topic in rank for topic in started):
        return _WHOLE + _ring([rank[topic] for topic in started])
    return _PARTLY + _ring(started)


def _gaps(topics: Sequence[int]) -> bytes:
    gaps = list(map(sub, topics, (-1, *topics[:-1])))
    shift = _best_shift(gaps)
    digits = [f"{gap + (1 << shift) - 1:b}" for gap in gaps]
    lengths = "".join([_ZEROS[len(step) - shift] for step in digits])
    return bytes((shift,)) + bits(lengths + "".join([step[1:] for step in digits]))


def _best_shift(gaps: Sequence[int]) -> int:
    """Return the Exp-Golomb parameter that costs fewest bits, of three that are plausible."""
    middle = sorted(gaps)[len(gaps) // 2].bit_length() - 1

    def cost(shift: int) -> int:
        more = (1 << shift) - 1
        return 2 * sum([(gap + more).bit_length() for gap in gaps]) - shift * len(gaps)

    return min(range(max(middle - 1, 0), middle + 2), key=cost)


def _read_rows(reader: Reader) -> tuple[tuple[int, ...], list[bytes]]:
    width, count = reader.number(MAX_COLUMNS), reader.number(MAX_ROWS)
    columns = [_whole(reader.take((count + 1) // 2), count)]
    columns.extend(_read_masks(reader, count) for _ in range(width))
    ranked = reader.take(1) == _WHOLE
    started = reader.numbers(TOPIC_RING, count - 1 if ranked else MAX_TOPIC)
    topics = _read_gaps(reader, count)
    if ranked:
        started = tuple([topics[rank] for rank in started])
    return started, [_spread(column, topics) for column in columns]


def _read_masks(reader: Reader, count: int) -> bytes:
    if reader.take(1) == _WHOLE:
        return reader.take(count)
    presence = reader.bits(count)
    masks = iter(reader.take(presence.count("1")))
    return bytes([next(masks) if digit == "1" else 0 for digit in presence])


def _read_gaps(reader: Reader, count: int) -> list[int]:
    shift = within(reader.take(1)[0], MAX_TOPIC.bit_length())
    digits = reader.bits(8 * (len(reader.data) - reader.position))
    *zeros, _ = digits.split("1", count)
    if len(zeros) != count or max(map(len, zeros), default=0) > MAX_TOPIC.bit_length():
        raise StateError("state.damaged")
    topics, topic, at = [], -1, sum(map(len, zeros)) + count
    for zero in zeros:
        end = at + len(zero) + shift
        topic += int("1" + digits[at:end], 2) + 1 - (1 << shift)
        topics.append(topic)
        at = end
    if at > len(digits) or topic > MAX_TOPIC:
        raise StateError("state.damaged")
    return topics


def _spread(column: bytes, topics: Sequence[int]) -> bytes:
    spread = bytearray(topics[-1] + 1 if topics else 0)
    for topic, value in zip(topics, column, strict=True):
        spread[topic] = value
    return bytes(spread)


def _halves(levels: bytes) -> bytes:
    digits = levels.hex()[1::2]
    return bytes.fromhex(digits + "0" * (len(digits) % 2))


def _whole(halves: bytes, count: int) -> bytes:
    return bytes([int(digit, 16) for digit in halves.hex()[:count]])
