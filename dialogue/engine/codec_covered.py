"""Columns of a state cut down to the covered topics, and spread over all topics again.

Covered topics mostly come in runs, so whole runs are copied: all columns at once, interleaved.
"""

import re
from collections.abc import Sequence

_RUN = re.compile(rb"\0*([^\0]+)")
_DIGITS = re.compile("0*(1+)")
_RUN_COSTS = 20


def gathered(columns: Sequence[bytes], cover: bytes, count: int) -> list[bytes]:
    """Return each column's bytes at the `count` topics whose byte of `cover` is not zero."""
    if len(cover) == count:
        return [column[:count].ljust(count, b"\0") for column in columns]
    width = len(columns)
    rows = _interleaved([column.ljust(len(cover), b"\0") for column in columns])
    kept = b"".join(
        [rows[run.start(1) * width : run.end(1) * width] for run in _RUN.finditer(cover)]
    )
    return [kept[number::width] for number in range(width)]


def spread(columns: Sequence[bytes], presence: str, count: int) -> list[bytes]:
    """Return the columns with a zero for each topic whose digit of `presence` is "0"."""
    if count == len(presence):
        return list(columns)
    # To copy a run costs as much as to write some twenty values one by one.
    if _RUN_COSTS * presence.count("01") > count * len(columns):
        form = presence.encode("ascii").replace(b"0", b"\0").replace(b"1", b"%c")
        return [form % tuple(column) for column in columns]
    width, at = len(columns), 0
    rows, full = _interleaved(columns), bytearray(len(columns) * len(presence))
    for run in _DIGITS.finditer(presence):
        start, end = run.span(1)
        length = (end - start) * width
        full[start * width : end * width] = rows[at : at + length]
        at += length
    return [bytes(full[number::width]) for number in range(width)]


def _interleaved(columns: Sequence[bytes]) -> bytes:
    width = len(columns)
    rows = bytearray(width * len(columns[0]))
    for number, column in enumerate(columns):
        rows[number::width] = column
    return bytes(rows)
