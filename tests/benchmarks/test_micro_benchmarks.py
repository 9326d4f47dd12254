"""What the micro benchmarks say of a figure that moved, and that all they record still exists."""

import json
from pathlib import Path
from typing import Any

import pytest
from django.urls import resolve
from rest_framework.test import APIRequestFactory

pytest.importorskip("pytest_benchmark")

from benchmarks.micro import compare
from benchmarks.micro.compare import Recorded, read, table, targets, word, write
from benchmarks.micro.measure import MEGABYTES, MICROS, SECONDS, Figure, Rounds, Work, repeated
from benchmarks.micro.names import OWN, START, all_names
from benchmarks.micro.reference import reference
from benchmarks.micro.works import ECHO_LARGEST


def _figure(ratio: float, unit: str = MICROS, name: str = "turn") -> Figure:
    return Figure(name, 500.0, unit, ratio)


def _recorded(ratio: float, unit: str = MICROS) -> Recorded:
    return Recorded(ratio, 400.0, unit)


@pytest.mark.parametrize(
    ("now", "said"), [(0.5, "faster"), (0.9, ""), (1.0, ""), (1.1, ""), (2.0, "slower")]
)
def test_only_what_moved_more_than_noise_gets_a_word(now: float, said: str) -> None:
    assert word(_figure(now), _recorded(1.0)) == said


def test_a_start_may_move_further_than_a_turn() -> None:
    assert word(_figure(1.4), _recorded(1.0)) == "slower"
    assert word(_figure(1.4, SECONDS), _recorded(1.0, SECONDS)) == ""


def test_memory_is_not_called_slow() -> None:
    assert word(_figure(90, MEGABYTES), _recorded(45, MEGABYTES)) == "more"


def test_what_nobody_recorded_is_new() -> None:
    assert word(_figure(1.0), None) == "new"


def test_ratios_are_compared_and_never_microseconds() -> None:
    slow_machine = Figure("turn", 4_000.0, MICROS, 1.0)
    assert word(slow_machine, _recorded(1.0)) == ""


def test_a_row_of_the_table_tells_now_then_and_the_word() -> None:
    head, row, other = table(
        [_figure(1.5), _figure(2.0, name="build")], {"turn": _recorded(1.0)}
    ).splitlines()
    assert head.split() == ["name", "now", "ratio", "recorded", "now/recorded"]
    assert row.split() == ["turn", "500.0", "µs", "1.500", "1.000", "1.50", "slower"]
    assert other.split()[-3:] == ["–", "–", "new"]


def test_a_missed_target_is_named() -> None:
    turn, echo = _figure(3.0, name="turn, largest state"), Figure(ECHO_LARGEST, 100.0, MICROS, 1.0)
    assert [line.rpartition(" ")[2] for line in targets([turn, echo])] == ["MISSED"]
    assert targets([turn]) == []


def test_a_target_that_is_met_is_named_too() -> None:
    lines = targets([Figure(START, 1.0, SECONDS, 9.0), Figure(OWN, 10.0, MEGABYTES, 10.0)])
    assert [line.rpartition(" ")[2] for line in lines] == ["met", "met"]


def test_recording_one_figure_keeps_the_others_and_drops_orphans(tmp_path: Path) -> None:
    file = tmp_path / "recorded.json"
    old = {name: {"ratio": 1.0, "value": 2.0, "unit": MICROS} for name in ("kept", "turn", "gone")}
    file.write_text(json.dumps(old), encoding="utf-8")
    write([_figure(3.0)], ("turn", "kept"), file)
    assert {name: one.ratio for name, one in read(file).items()} == {"turn": 3.0, "kept": 1.0}


def test_nothing_recorded_is_no_error(tmp_path: Path) -> None:
    assert read(tmp_path / "none.json") == {}


def test_every_recorded_name_is_a_benchmark_and_every_benchmark_is_recorded() -> None:
    assert tuple(read()) == all_names()


def test_the_noise_of_every_unit_is_known() -> None:
    assert {one.unit for one in read().values()} == compare.NOISE.keys() == compare.WORDS.keys()


def test_the_reference_does_the_same_everywhere() -> None:
    assert reference() == 33_540


def test_the_companions_of_a_benchmark_are_measured_in_its_rounds() -> None:
    done: list[str] = []
    beside = {"echo": Work(lambda: done.append("echo"))}
    rounds = Rounds("turn", Work(lambda: None, calls=10, rounds=30, beside=beside))
    for _ in range(30):
        rounds.before()
    ours, echo = rounds.figures(least=1_000.0)
    assert (ours.name, ours.value, echo.name) == ("turn", 100.0, "echo")
    assert ours.ratio == pytest.approx(100.0 / rounds.reference)
    assert done == ["echo"] * 30


def test_a_short_piece_of_work_is_done_many_times_a_round() -> None:
    done: list[int] = []
    work = repeated(lambda: done.append(1))
    done.clear()
    work.run()
    assert len(done) == work.calls > 1


def test_the_echo_view_answers_what_it_got() -> None:
    body = json.dumps({"client_sentence": "Ciao, come va?", "dialogue_state": "x" * 8_000}).encode()
    request = APIRequestFactory().post("/api/v1/echo/", body, content_type="application/json")
    found = resolve("/api/v1/echo/", "benchmarks.micro.echo")
    answer: Any = found.func(request)
    assert json.loads(answer.render().content) == json.loads(body)


def test_the_addresses_of_the_echo_hold_those_of_the_site() -> None:
    assert resolve("/api/v1/hub/", "benchmarks.micro.echo").url_name == "hub-list"
