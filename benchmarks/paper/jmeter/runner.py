"""Runs JMeter without its window, and compares its mean with our generator's at small N."""

import csv
import shutil
import subprocess
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from statistics import fmean, median
from typing import NamedTuple

from benchmarks.paper.load import Load, Target, spread
from benchmarks.paper.systems import System

HOME = Path("/usr/share/jmeter")
HERE = Path(__file__).resolve().parent
SECONDS = 120


class Check(NamedTuple):
    """One comparison: so many threads started over so many seconds, each asking so often."""

    title: str
    threads: int
    ramp: int
    loops: int
    pause: int


CHECKS = (
    Check("one after another", 1, 0, 40, 50),
    Check("4 at once", 4, 0, 20, 0),
    Check("50 over 10 s", 50, 10, 1, 0),
)


def missing() -> str:
    """Return why JMeter cannot run here, "" where it can."""
    if shutil.which("java") is None:
        return "there is no java"
    if not (HOME / "lib" / "ext" / "ApacheJMeter_http.jar").exists():
        return "Debian's packages jmeter and jmeter-http are not installed"
    return ""


def cross_check(system: System, port: int) -> str:
    """Return a table of the means of both generators, or why there is none."""
    reason = missing()
    if reason:
        return f"No cross-check with JMeter for {system.label}: {reason}."
    lines = [f"JMeter as a cross-check, {system.label}, median and mean in ms:", ""]
    lines += ["| | JMeter | our generator | medians apart |", "| --- | ---: | ---: | ---: |"]
    for check in CHECKS:
        theirs = jmeter(system, port, check)
        ours = _our_times(system, port, check)
        apart = median(ours) / median(theirs) - 1
        lines.append(f"| {check.title} | {_two(theirs)} | {_two(ours)} | {100 * apart:+.0f} % |")
    return "\n".join(lines)


def _two(times: list[float]) -> str:
    return f"{median(times):.1f} / {fmean(times):.1f}"


def jmeter(system: System, port: int, check: Check) -> list[float]:
    """Return the response times JMeter counts, in ms, the first fifth (its own start) left out.

    Raises RuntimeError where it fails or a request does.
    """
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        result = folder / "result.csv"
        with _body(system, folder) as (method, path, body):
            values = {"port": port, "method": method, "path": path, "body": body}
            values |= {"threads": check.threads, "ramp": check.ramp, "loops": check.loops}
            values |= {"pause": check.pause, "jmeter.save.saveservice.output_format": "csv"}
            values |= {"jmeter.save.saveservice.print_field_names": "true"}
            done = subprocess.run(
                _command(folder, result, values),
                cwd=folder,
                capture_output=True,
                text=True,
                timeout=SECONDS,
                check=False,
            )
        if done.returncode or not result.exists():
            raise RuntimeError(f"JMeter failed: {done.stdout[-1000:]}{done.stderr[-1000:]}")
        return _times(result, check)


def _command(folder: Path, result: Path, values: dict[str, object]) -> list[str]:
    jar = HOME / "bin" / "ApacheJMeter.jar"
    command = ["java", "-Djava.awt.headless=true", f"-Djmeter.home={HOME}", "-cp", str(jar)]
    command += [str(HERE / "Launcher.java"), "-n", "-t", str(HERE / "paper.jmx")]
    command += ["-l", str(result), "-j", str(folder / "log")]
    return command + [f"-J{name}={value}" for name, value in values.items()]


@contextmanager
def _body(system: System, folder: Path) -> Iterator[tuple[str, str, Path]]:
    """Yield method and path of the largest request, and a file with its body."""
    head, _, body = system.requests[-1][0].partition(b"\r\n\r\n")
    method, path, _version = head.decode().splitlines()[0].split(" ")
    file = folder / "body"
    file.write_bytes(body)
    yield method, path, file


def _times(result: Path, check: Check) -> list[float]:
    with result.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    if len(rows) != check.threads * check.loops or any(row["success"] != "true" for row in rows):
        raise RuntimeError(f"JMeter: {check.title}: some of {len(rows)} requests failed.")
    times = [float(row["elapsed"]) for row in rows]
    return times[len(times) // 5 :] if check.loops > 1 else times


def _our_times(system: System, port: int, check: Check) -> list[float]:
    load = Load(Target("127.0.0.1", port))
    bodies = system.requests[-1][:1]
    times: list[float] = []
    for _ in range(check.loops):
        dues = spread(check.threads, check.ramp) if check.ramp else [0.0] * check.threads
        times += [1_000 * one.seconds for one in load.run(bodies, dues)]
        time.sleep(check.pause / 1_000)
    return times
