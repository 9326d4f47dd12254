"""export_owl: write the draft or a release as OWL 2."""

import gzip
import os
import sys
import tempfile
from argparse import ArgumentParser
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO, cast

from django.core.management.base import BaseCommand, CommandError

from dialogue.models import Publication
from dialogue.snapshot import SnapshotError
from ontology_io import exporting
from ontology_io.owl.write_remainder import RemainderError
from ontology_io.owl.xml_writer import UnwritableError

STDOUT = "-"


class Command(BaseCommand):
    help = "Write the draft, or a release, as an OWL 2 file; the same content gives the same bytes."

    def add_arguments(self, parser: ArgumentParser) -> None:
        parser.add_argument("--output", default=STDOUT, help="a file; without it, standard output")
        parser.add_argument("--release", type=int, help="the number of a release, not the draft")
        parser.add_argument("--gzip", action="store_true", help="compress it")

    def handle(self, *args: object, **options: object) -> None:
        output = str(options["output"])
        try:
            export = _chosen(options["release"])
            with _opened(output) as file:
                size = _write(export.chunks, file, compressed=bool(options["gzip"]))
        except BrokenPipeError:
            raise CommandError("Nobody took the output: it is not complete.") from None
        except OSError as error:
            raise CommandError(f"{output} cannot be written: {error.strerror}.") from error
        except (UnwritableError, RemainderError) as error:
            raise CommandError(f"Nothing was written to {output}: {error}") from error
        counts = ", ".join(f"{count} {name}" for name, count in export.counts().items())
        place = "standard output" if output == STDOUT else output
        self.stderr.write(f"Wrote the {export.version} to {place}: {counts}, {size} bytes.")


def _chosen(number: object) -> exporting.Export:
    if number is None:
        export = exporting.draft()
        if not export.base.knowledge.topics:
            raise CommandError("The draft is empty: nothing was written. Run load_content first.")
        return export
    try:
        return exporting.release(cast("int", number))
    except Publication.DoesNotExist:
        last = Publication.objects.order_by("-pk").values_list("pk", flat=True).first()
        known = f"the last one is {last}" if last else "nothing was published yet"
        raise CommandError(f"There is no release {number}: {known}.") from None
    except SnapshotError as error:
        raise CommandError(f"Release {number}: {error}") from error


@contextmanager
def _opened(output: str) -> Iterator[IO[bytes]]:
    """Yield a file that takes the place of the old one only when all of it was written."""
    if output == STDOUT:
        yield sys.stdout.buffer
        sys.stdout.buffer.flush()
        return
    path = Path(output)
    if path.is_dir():
        raise CommandError(f"{output} is a folder. Name a file in it, e.g. {output}/cair.owl.")
    if not path.parent.is_dir():
        raise CommandError(f"There is no folder {path.parent}. Make it first.")
    mode = path.stat().st_mode & 0o777 if path.exists() else 0o666 & ~_mask()
    with tempfile.NamedTemporaryFile(
        dir=path.parent, prefix=f".{path.name}.", delete=False
    ) as file:
        try:
            yield file
            file.flush()
            os.fsync(file.fileno())
            os.chmod(file.name, mode)
            os.replace(file.name, path)
        except BaseException:
            Path(file.name).unlink(missing_ok=True)
            raise


def _mask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask


def _write(chunks: Iterator[bytes], file: IO[bytes], *, compressed: bool) -> int:
    """Return how many bytes the file got (before compression)."""
    size = 0
    # No name and no time inside, so that the same content gives the same bytes.
    packer = gzip.GzipFile(filename="", mode="wb", fileobj=file, mtime=0) if compressed else None
    for chunk in chunks:
        size += (packer or file).write(chunk)
    if packer:
        packer.close()
    return size
