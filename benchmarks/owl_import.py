"""How long an OWL file takes to be read, and how much memory: `python -m benchmarks.owl_import`.

A made-up knowledge base of the size that is aimed at, or a file of one's own.
"""

import argparse
import os
import resource
import time
from pathlib import Path

from benchmarks.owl_synthetic import INTENTS, ROWS, TOPICS, highest, synthetic
from ontology_io.owl.export import owl_bytes
from ontology_io.owl.limits import Limits
from ontology_io.owl.prescan import scan
from ontology_io.owl.reading import read_owl

MOST_SECONDS, MOST_MEGABYTES = 9.0, 300.0


def main() -> None:
    """Print what the parts cost; fail where they cost more than they may."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("file", nargs="?", type=Path, help="an OWL file; made up without")
    parser.add_argument("--topics", type=int, default=TOPICS)
    parser.add_argument("--rows", type=int, default=ROWS, help="sentences, one row a language")
    parser.add_argument("--intents", type=int, default=INTENTS)
    chosen = parser.parse_args()
    data = chosen.file.read_bytes() if chosen.file else _made_up(chosen)
    print(f"file: {len(data) / 1e6:.1f} MB")
    limits = Limits()
    before = time.process_time()
    scan(data, limits)
    print(f"scan alone: {time.process_time() - before:.2f} s CPU")
    measure(data, limits)


def measure(data: bytes, limits: Limits) -> None:
    """Read `data`; print CPU seconds of both processes and the peak of the one that reads."""
    before, started = os.times(), time.monotonic()
    file = read_owl(data, limits)
    after, wall = os.times(), time.monotonic() - started
    here = after.user + after.system - before.user - before.system
    there = (
        after.children_user + after.children_system - before.children_user - before.children_system
    )
    peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
    said = sum(len(topic.said) for topic in file.topics)
    print(f"read: {here + there:.2f} s CPU ({here:.2f} here, {there:.2f} in its own process)")
    print(f"      {wall:.2f} s on the clock, {peak:.0f} MB at most in its own process")
    print(f"      {len(file.topics)} topics, {said} sentences, {len(file.intents)} intents")
    assert here + there <= MOST_SECONDS, "too slow"
    assert peak <= MOST_MEGABYTES, "too much memory"


def _made_up(chosen: argparse.Namespace) -> bytes:
    base = synthetic(chosen.topics, chosen.rows, chosen.intents)
    chunks = owl_bytes(base, iri="urn:cair:kb", version="draft", highest=highest(base))
    return b"".join(chunks)


if __name__ == "__main__":
    main()
