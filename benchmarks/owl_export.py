"""The export at the full size and of the shipped content: CPU seconds, memory, bytes.

python benchmarks/owl_export.py [--topics 3000] [--rows 24000] [--intents 300] [--write FILE]

It works in a database of its own that is thrown away.
"""

import argparse
import hashlib
import os
import sys
import tempfile
import time
import zlib
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))


def main() -> None:
    """Print a table."""
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--topics", type=int, default=3000)
    arguments.add_argument("--rows", type=int, default=24_000)
    arguments.add_argument("--intents", type=int, default=300)
    arguments.add_argument("--write", type=Path, help="keep the large file here")
    chosen = arguments.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        os.environ |= {"CAIR_VAR": folder, "DJANGO_SETTINGS_MODULE": "cair_site.settings"}
        os.environ.pop("DATABASE_URL", None)
        import django

        django.setup()
        print("| what | CPU s | growth of the process, MB | MB | MB zlib | SHA-256 |")
        print("| --- | --- | --- | --- | --- | --- |")
        measure_synthetic(chosen)
        measure_shipped()


def measure_synthetic(chosen: argparse.Namespace) -> None:
    """Measure the writer alone, twice: the bytes must be the same."""
    from benchmarks.owl_synthetic import highest, synthetic
    from ontology_io.owl.export import owl_bytes

    base = synthetic(chosen.topics, chosen.rows, chosen.intents)
    individuals = sum(len(topic.likeliness) for topic in base.knowledge.topics)
    rows = sum(len(frame.texts) for topic in base.knowledge.topics for frame in topic.frames)
    what = f"{len(base.knowledge.topics)} topics, {individuals} individuals, {rows} sentences"
    last = highest(base)

    def made() -> Iterator[bytes]:
        return owl_bytes(base, iri="urn:cair:kb", version="draft", highest=last)

    for _ in range(2):
        measure(what, made)
    if chosen.write:
        with chosen.write.open("wb") as file:
            file.writelines(made())


def measure_shipped() -> None:
    """Measure the draft with the shipped content, the reading of its rows included."""
    from django.core.management import call_command

    from ontology_io.exporting import export_draft

    call_command("migrate", verbosity=0)
    call_command("load_content", str(ROOT / "content"), verbosity=0)
    export_draft()
    measure("the shipped content, from the database", export_draft)


def measure(what: str, export: Callable[[], Iterator[bytes]]) -> None:
    """Print what an export takes while its chunks are thrown away."""
    before = _start_of_peak()
    worked = time.process_time()
    size = sum(map(len, export()))
    cpu = time.process_time() - worked
    growth = _peak() - before
    packed, checksum = _packed(export())
    print(
        f"| {what} | {cpu:.2f} | {growth:.1f} | {size / 1e6:.1f} | {packed / 1e6:.2f} "
        f"| {checksum[:12]} |"
    )


def _packed(chunks: Iterable[bytes]) -> tuple[int, str]:
    packer, digest, size = zlib.compressobj(6), hashlib.sha256(), 0
    for chunk in chunks:
        digest.update(chunk)
        size += len(packer.compress(chunk))
    return size + len(packer.flush()), digest.hexdigest()


def _start_of_peak() -> float:
    """Return the process's memory in MB, and let the peak count from here (Linux)."""
    Path("/proc/self/clear_refs").write_text("5", encoding="ascii")
    return _status("VmRSS")


def _peak() -> float:
    return _status("VmHWM")


def _status(field: str) -> float:
    for line in Path("/proc/self/status").read_text(encoding="ascii").splitlines():
        if line.startswith(field):
            return int(line.split()[1]) / 1024
    raise OSError(f"{field} is not in /proc/self/status: this benchmark needs Linux.")


if __name__ == "__main__":
    main()
