"""What a long run concludes: growth is told from noise, memory is read as Linux writes it."""

import csv
import os
from pathlib import Path
from random import Random

import pytest

from cluster.load import Counted
from cluster.memory import Memory, family, memory_of
from cluster.soak import Minute, verdicts, write_csv
from cluster.trend import trend

MINUTES = [60.0 * number for number in range(1, 31)]


def test_a_leak_is_told_from_noise() -> None:
    chance = Random(1)
    noise = [100 + chance.gauss(0, 1) for _ in MINUTES]
    leak = [value + 0.5 * number for number, value in enumerate(noise)]
    steady, growing = trend(MINUTES, noise), trend(MINUTES, leak)
    assert steady
    assert growing
    assert not steady.grows
    assert growing.grows
    assert growing.slope == pytest.approx(30, abs=5)


def test_warming_up_is_no_growth() -> None:
    found = trend(MINUTES, [min(100.0, 60 + 10 * number) for number in range(30)])
    assert found
    assert (found.slope, found.grows) == (pytest.approx(0), False)


def test_too_few_values_say_nothing() -> None:
    assert trend(MINUTES[:5], [1.0] * 5) is None


def test_a_short_noisy_run_is_called_too_short() -> None:
    found = trend(MINUTES[:7], [100.0, 130, 90, 125, 80, 140, 95])
    assert found
    assert found.text("MB").endswith("too short to tell")


def test_a_few_minutes_are_no_trend_however_steep() -> None:
    found = trend(MINUTES[:12], [100.0 + number for number in range(12)])
    assert found
    assert (found.grows, found.sure) == (False, False)


def test_memory_is_read_from_what_linux_says(tmp_path: Path) -> None:
    folder = tmp_path / "7"
    folder.mkdir()
    (folder / "smaps_rollup").write_text(
        "00400000-7fff r-xp 00000000 00:00 0 [rollup]\nRss: 900 kB\nPss:  500 kB\n"
        "Private_Clean:  100 kB\nPrivate_Dirty:  200 kB\n",
        encoding="ascii",
    )
    assert memory_of(7, tmp_path) == Memory(pss=500 * 1024, uss=300 * 1024, rss=900 * 1024)
    assert memory_of(8, tmp_path) is None


def test_this_process_is_the_first_of_its_family() -> None:
    assert family(os.getpid())[0] == os.getpid()


def minutes(leak: int, copied: int = 0) -> list[Minute]:
    counted = Counted(100, 0, 0, 0.004, 0.02, 0.5)
    return [
        Minute(
            at,
            counted,
            {"node1.worker1": Memory(0, 20_000_000 + copied * number, 100_000_000 + leak * number)},
        )
        for number, at in enumerate(MINUTES)
    ]


def test_a_verdict_names_what_grows() -> None:
    grown, steady = verdicts(minutes(1_000_000)), verdicts(minutes(0))
    assert grown[0].startswith("memory of node1.worker1")
    assert "GROWS; 20.0 MB of its own" in grown[0]
    assert not any("GROWS" in line for line in steady)
    assert steady[-1] == "3000 turns, 0 failed, 0 states did not go on"


def test_copies_of_shared_pages_are_no_leak() -> None:
    told = verdicts(minutes(0, copied=1_000_000))
    assert not any("GROWS" in line for line in told)
    assert "49.0 MB of its own at the end" in told[0]


def test_a_row_is_written_for_every_minute(tmp_path: Path) -> None:
    write_csv(minutes(0), tmp_path / "soak.csv")
    with (tmp_path / "soak.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 30
    assert rows[0]["p99_ms"] == "20.00"
    assert rows[-1]["node1.worker1_uss"] == "20000000"
    assert rows[-1]["node1.worker1_rss"] == "100000000"
