"""The file of a backup: compressed lines of JSON, the first says what follows, the last proves it.

    {"format": "CAIR backup", "version": 1, "migrations": {…}, "tables": {…}}
    ["dialogue.topic", 1, "Tea", …]
    {"rows": 40000, "sha256": "…"}

The checksum is of all lines before the last one, as they are without compression. The same content
gives the same bytes.
"""

import gzip
import hashlib
import os
import tempfile
import zlib
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import IO, NoReturn, TypeVar

import msgspec

FORMAT, VERSION = "CAIR backup", 1
MEGABYTE = 2**20
#: What a file may hold without compression, unless more is asked for.
LARGEST = 2048 * MEGABYTE
#: A line is held in memory: a release of some million sentences fits.
LONGEST_LINE = 256 * MEGABYTE
Row = list[object]
Line = TypeVar("Line")


class BackupError(ValueError):
    """A file that is no backup, is damaged, is too large, or does not fit this database."""


class Table(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """What a backup says of one table: its fields in the order of the rows, the last number."""

    fields: tuple[str, ...]
    last: int


class Header(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The first line. `migrations` are the applied ones of each app, `tables` by model label."""

    format: str = FORMAT
    version: int = VERSION
    migrations: dict[str, tuple[str, ...]]
    tables: dict[str, Table]


class Trailer(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The last line."""

    rows: int
    sha256: str


class _Known(msgspec.Struct):
    """What every version of the format says."""

    format: str = ""
    version: int = 0


_encode = msgspec.json.Encoder().encode  # JSON of authors keeps the order of its keys


def write(path: Path, header: Header, rows: Iterable[Row]) -> tuple[Trailer, int]:
    """Write a backup, whole or not at all; return its last line and its size uncompressed.

    Only its owner may read the file. Raises OSError, BackupError for a row that is too long.
    """
    with tempfile.NamedTemporaryFile(
        dir=path.parent, prefix=f".{path.name}.", delete=False
    ) as file:
        try:
            told = _write(file, header, rows)
            file.flush()
            os.fsync(file.fileno())
            os.replace(file.name, path)
        except BaseException:
            Path(file.name).unlink(missing_ok=True)
            raise
    _keep(path.parent)
    return told


def _write(file: IO[bytes], header: Header, rows: Iterable[Row]) -> tuple[Trailer, int]:
    digest, count, size = hashlib.sha256(), -1, 0
    # No name and no time inside, so that the same content gives the same bytes.
    with gzip.GzipFile(filename="", mode="wb", compresslevel=6, fileobj=file, mtime=0) as packed:
        for line in _lines(header, rows):
            packed.write(line)
            digest.update(line)
            size += len(line)
            count += 1
        trailer = Trailer(rows=count, sha256=digest.hexdigest())
        packed.write(_encode(trailer) + b"\n")
    return trailer, size


def _lines(header: Header, rows: Iterable[Row]) -> Iterator[bytes]:
    yield _encode(header) + b"\n"
    for row in rows:
        line = _encode(row) + b"\n"
        if len(line) > LONGEST_LINE:
            raise BackupError(f"A row of {row[0]} is longer than {LONGEST_LINE} bytes.")
        yield line


def _keep(folder: Path) -> None:
    """Have the new name of the file outlive a power cut."""
    number = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(number)
    finally:
        os.close(number)


class Reader:
    """A backup that is read line by line, never more than `largest` bytes of it."""

    def __init__(self, file: IO[bytes], largest: int = LARGEST) -> None:
        self.file, self.largest = file, largest

    def header(self) -> Header:
        """Read all of it; return the first line of a backup whose checksum is right."""
        lines = self._lines()
        first = next(lines, b"")
        known = _decode(first, _Known, "This is no backup of CAIR.")
        if known.format != FORMAT:
            raise BackupError("This is no backup of CAIR.")
        if known.version != VERSION:
            raise BackupError(f"The backup has format {known.version}; this is {VERSION}.")
        for _ in lines:
            pass
        return _decode(first, Header, "The first line of the backup is damaged.")

    def rows(self) -> Iterator[Row]:
        """Yield the rows; BackupError at the end where the checksum is not right."""
        lines = self._lines()
        next(lines, None)
        for line in lines:
            row = _decode(line, Row, "A row of the backup is damaged.")
            if not row or not isinstance(row[0], str):
                raise BackupError("A row of the backup is damaged.")
            yield row

    def _lines(self) -> Iterator[bytes]:
        """Yield all lines but the last one, which must tell their number and checksum."""
        digest, count, previous = hashlib.sha256(), -1, b""
        for line in self._inflated():
            if previous:
                digest.update(previous)
                count += 1
                yield previous
            previous = line
        trailer = _decode(previous, Trailer, "The backup is not complete: its last line is gone.")
        if (trailer.rows, trailer.sha256) != (count, digest.hexdigest()):
            raise BackupError("The backup is damaged: its checksum differs.")

    def _inflated(self) -> Iterator[bytes]:
        left = self.largest
        self.file.seek(0)
        try:
            with gzip.GzipFile(fileobj=self.file, mode="rb") as packed:
                while line := packed.readline(min(left, LONGEST_LINE) + 1):
                    left -= len(line)
                    if left < 0 or len(line) > LONGEST_LINE:
                        self._too_large(left)
                    yield line
        except (gzip.BadGzipFile, zlib.error, EOFError) as error:
            raise BackupError(f"The file is damaged or no backup: {error}.") from error

    def _too_large(self, left: int) -> NoReturn:
        if left < 0:
            size = self.largest // MEGABYTE
            raise BackupError(f"The backup holds more than {size} MiB; see --largest.")
        raise BackupError(f"A line of the backup is longer than {LONGEST_LINE} bytes.")


def _decode(line: bytes, kind: type[Line], wrong: str) -> Line:
    try:
        return msgspec.json.decode(line, type=kind)
    except (msgspec.MsgspecError, RecursionError, UnicodeDecodeError) as error:
        raise BackupError(wrong) from error
