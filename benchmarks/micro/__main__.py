"""python -m benchmarks.micro [--only NAME] [--record]: three minutes, exit 0 whatever it finds."""

import argparse
import io
import os
import sys
from contextlib import redirect_stdout
from pathlib import Path
from typing import Never

import pytest
from tqdm import tqdm

from benchmarks.micro.compare import read, table, targets, write
from benchmarks.micro.measure import Figure
from benchmarks.micro.names import FIGURES, PROCESSES, all_names

ROOT = Path(__file__).resolve().parent.parent.parent
OPTIONS = (
    *("-q", "-c", os.devnull, "--rootdir", str(ROOT), "--import-mode=importlib", "--capture=no"),
    *("-p", "no:django", "-p", "no:cacheprovider", "-p", "no:xdist"),
    *("--benchmark-timer=time.process_time", "--benchmark-quiet"),
)


class Run:
    """A plugin of pytest: chooses benchmarks, shows how far they are, and keeps their figures."""

    def __init__(self, only: str) -> None:
        self.only = only.casefold()
        self.figures: dict[str, Figure] = {}
        self.failures: list[str] = []
        self.bar: tqdm[Never] | None = None

    def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
        """Keep what was asked for."""
        items[:] = [item for item in items if self._is_wanted(item)]
        self.bar = tqdm(total=len(items), unit="benchmark", leave=False, file=sys.stderr)

    def _is_wanted(self, item: pytest.Item) -> bool:
        return any(self.only in name.casefold() for name in _figures_of(item))

    def pytest_runtest_logstart(self, nodeid: str) -> None:
        """Show what is measured now."""
        if self.bar is not None:
            self.bar.set_description(nodeid.partition("::")[2][:50])

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Keep the figures."""
        if report.failed:
            self.failures.append(f"{report.nodeid}\n{report.longreprtext}")
        if report.when != "call":
            return
        for name, value in report.user_properties:
            if name == FIGURES and isinstance(value, list):
                self.figures |= {one.name: one for one in value}
        if self.bar is not None:
            self.bar.update()


def _figures_of(item: pytest.Item) -> tuple[str, ...]:
    """Return the names of the figures a benchmark gives."""
    parameters = getattr(getattr(item, "callspec", None), "params", {})
    if "name" in parameters:
        name = str(parameters["name"])
        return (name, name.replace("turn,", "echo view,")) if name.startswith("turn,") else (name,)
    return PROCESSES[:2] if item.name == "test_start" else PROCESSES[2:]


def measured(only: str = "") -> tuple[list[Figure], list[str]]:
    """Return the figures in the order of their names, and what failed."""
    run, heard = Run(only), io.StringIO()
    with redirect_stdout(heard):
        code = pytest.main([str(Path(__file__).with_name("test_micro.py")), *OPTIONS], [run])
    if run.bar is not None:
        run.bar.close()
    if code not in {pytest.ExitCode.OK, pytest.ExitCode.NO_TESTS_COLLECTED} and not run.failures:
        run.failures.append(heard.getvalue())
    return [run.figures[name] for name in all_names() if name in run.figures], run.failures


def main() -> None:
    """Measure, and print one table."""
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--only", default="", help="benchmarks whose names contain this")
    arguments.add_argument("--record", action="store_true", help="write recorded.json")
    chosen = arguments.parse_args()
    figures, failures = measured(chosen.only)
    print(table(figures, read()))
    print(*targets(figures), *(f"NOT MEASURED: {one}" for one in failures), sep="\n")
    if chosen.record:
        write(figures, all_names())


if __name__ == "__main__":
    main()
