"""The benchmarks as pytest-benchmark runs them: start them with `python -m benchmarks.micro`.

Nothing here asserts a time; figures leave as properties of the reports.
"""

import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from pytest_benchmark.fixture import BenchmarkFixture
from pytest_benchmark.stats import Stats

from benchmarks.micro import processes
from benchmarks.micro.measure import CPU_SECONDS, MEGABYTES, SECONDS, Figure, Rounds
from benchmarks.micro.names import FIGURES, MASTER, OWN, SHARED, START, START_CPU, WORKER
from benchmarks.micro.reference import cpu_micros, reference
from benchmarks.micro.works import LARGEST, WORKS, bodies
from benchmarks.micro.world import KEYS, World
from dialogue.engine.codec import encode

STARTS = 5
Record = Callable[[str, object], None]


@pytest.fixture(scope="session")
def world() -> Iterator[World]:
    """Return what all work on, with everything made that is made once."""
    import gc

    with tempfile.TemporaryDirectory() as var:
        made = World(Path(var))
        assert made.states
        gc.collect()
        gc.freeze()
        yield made


@pytest.mark.parametrize("name", WORKS)
def test_work(
    name: str, world: World, benchmark: BenchmarkFixture, record_property: Record
) -> None:
    """Measure a piece of work of this process, its quickest round."""
    work = WORKS[name](world)
    rounds = Rounds(name, work)
    benchmark.pedantic(  # type: ignore[no-untyped-call]
        work.run, setup=rounds.before, rounds=work.rounds, warmup_rounds=1
    )
    record_property(FIGURES, rounds.figures(_stats(benchmark).min * 1e6))


@pytest.mark.benchmark(timer=time.perf_counter)
def test_start(
    world: World, benchmark: BenchmarkFixture, record_property: Record, tmp_path: Path
) -> None:
    """Measure from the start of gunicorn to its first answer: median time, least CPU time."""
    body = bodies(encode(world.states[LARGEST], KEYS))[0]
    folders = iter([tmp_path / str(number) for number in range(STARTS)])
    running: list[processes.Server] = []
    references: list[float] = []
    cpu: list[float] = []

    def before() -> tuple[tuple[Path], dict[str, object]]:
        _stop(running)
        references.extend(cpu_micros(reference) for _ in range(20))
        folder = next(folders)
        folder.mkdir()
        return (folder,), {}

    def start(folder: Path) -> None:
        running.append(processes.start(world.publish(), folder))
        processes.first_answer(running[0], body)
        cpu.append(processes.spent(running[0]))

    try:
        benchmark.pedantic(  # type: ignore[no-untyped-call]
            start, setup=before, rounds=STARTS
        )
    finally:
        _stop(running)
    found = ((START, _stats(benchmark).median, SECONDS), (START_CPU, min(cpu), CPU_SECONDS))
    record_property(
        FIGURES,
        [Figure(name, value, unit, value * 1e6 / min(references)) for name, value, unit in found],
    )


def _stats(benchmark: BenchmarkFixture) -> Stats:
    assert benchmark.stats is not None
    stats: Stats = benchmark.stats.stats
    return stats


def _stop(running: list[processes.Server]) -> None:
    while running:
        processes.stop(running.pop())


def test_memory(world: World, record_property: Record) -> None:
    """Measure whose memory is whose when each worker has answered 600 turns."""
    sent = bodies(encode(world.states[LARGEST], KEYS))
    with processes.served(world.publish(), sent[0]) as server:
        processes.talk(server, sent)
        workers = [processes.memory(pid) for pid in server.workers()]
        master = processes.memory(server.process.pid)
    values = {
        SHARED: max(one.shared for one in workers),
        OWN: max(one.own for one in workers),
        WORKER: max(one.proportional for one in workers),
    }
    values[MASTER] = master.proportional
    record_property(
        FIGURES, [Figure(name, value, MEGABYTES, value) for name, value in values.items()]
    )
