"""python -m benchmarks.paper [--quick] [--out docs/performance] [--no-jmeter]."""

import argparse
import gc
import shutil
import subprocess
import sys
import time
from pathlib import Path

from benchmarks.paper.content import ROOT
from benchmarks.paper.experiments import FULL, QUICK, Experiments, Row
from benchmarks.paper.jmeter import runner
from benchmarks.paper.load import allow_many_sockets
from benchmarks.paper.prepare import fingerprint
from benchmarks.paper.report import markdown, write_csv
from benchmarks.paper.systems import System, old_clients, systems

CACHE = ROOT / "var" / "paper-benchmark"


def prepared() -> Path:
    """Return the folder with content and states, made first where something has changed."""
    folder = CACHE / fingerprint()
    if not (folder / "states.json").exists():
        shutil.rmtree(CACHE, ignore_errors=True)
        print("Talking until all topics are covered …", flush=True)
        command = [sys.executable, "-m", "benchmarks.paper.prepare", str(folder)]
        subprocess.run(command, cwd=ROOT, check=True)
    return folder


def measure(system: System, folder: Path, chosen: argparse.Namespace) -> tuple[list[Row], str]:
    """Return the rows of a system, and what JMeter says to the same."""
    plan = QUICK if chosen.quick else FULL
    with system.serve(folder) as port:
        rows = list(Experiments(system, port, plan).all())
        if system.name == "cair":
            rows.append(Experiments(old_clients(folder), port, plan).largest())
        checked = "" if chosen.quick or chosen.no_jmeter else runner.cross_check(system, port)
    return rows, checked


def main() -> None:
    """Run the experiments with both systems and write what came of it."""
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument(
        "--quick", action="store_true", help="few repetitions, no JMeter: three minutes"
    )
    arguments.add_argument("--out", type=Path, default=ROOT / "docs" / "performance")
    arguments.add_argument("--no-jmeter", action="store_true")
    chosen = arguments.parse_args()
    began = time.monotonic()
    allow_many_sockets()
    folder = prepared()
    gc.freeze()
    rows: list[Row] = []
    notes: list[str] = []
    for system in systems(folder):
        measured, note = measure(system, folder, chosen)
        rows += measured
        notes.append(note)
    finish(rows, notes, chosen)
    print(f"{time.monotonic() - began:.0f} s")


def finish(rows: list[Row], notes: list[str], chosen: argparse.Namespace) -> None:
    """Write CSV, the page and the figures."""
    from benchmarks.paper.figures import draw

    write_csv(chosen.out / "results", rows)
    page = markdown(rows, quick=chosen.quick) + "".join(f"\n{note}\n" for note in notes if note)
    (chosen.out / "paper.md").write_text(page, encoding="utf-8")
    draw(chosen.out, rows)
    print(page)


if __name__ == "__main__":
    main()
