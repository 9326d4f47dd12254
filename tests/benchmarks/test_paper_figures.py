"""Where a curve crosses one second, and the baseline's own small parts."""

from random import Random

import pytest

pytest.importorskip("tqdm")

from benchmarks.baseline.data import Data, Lists, compiled
from benchmarks.baseline.dialogue_manager import reply, search
from benchmarks.baseline.plan_manager import find_plan
from benchmarks.baseline.state import covered, first_state, squeeze, unsqueeze
from benchmarks.paper.experiments import BURST, Row, crossing


def _row(n: int, mean: float, errors: int = 0) -> Row:
    return Row(BURST, "cair", n, 9, 9, 1, mean, 0.0, mean, mean, 1.0, 0.0, errors)


@pytest.fixture
def data() -> Data:
    topic = {"likeliness": 0.5, "children": [], "pattern": "qp"}
    said = [{"type": kind, "text": f"A sentence of type {kind}."} for kind in "qpn"]
    names = {"GreenTea": [["green"], ["tea"]], "Tea": [["tea"], ["*"]]}
    topics = [
        topic | {"name": name, "keywords": words, "sentences": said}
        for name, words in names.items()
    ]
    intent = {
        "name": "love",
        "triggers": ["i ?love (?P<topic>.+)"],
        "sentences": ["Good."],
        "plan": "",
        "kbplan": "#action=setlikeliness topic=$topic value=1.0"
        "#action=jump topic=$topic startsentence=p",
    }
    return compiled(Lists(topics=topics, roots=[0, 1], intents=[intent]))


def test_the_crossing_lies_between_the_last_good_step_and_the_next() -> None:
    assert crossing([_row(10, 500.0), _row(20, 1500.0)]) == (15, True)


def test_a_curve_that_stays_below_is_said_not_to_have_crossed() -> None:
    assert crossing([_row(10, 500.0), _row(20, 900.0)]) == (20, False)


def test_a_step_measured_later_counts_where_its_n_belongs() -> None:
    assert crossing([_row(10, 500.0), _row(20, 1500.0), _row(15, 1200.0)]) == (14, True)


def test_failed_requests_end_the_capacity_however_quick_they_are() -> None:
    assert crossing([_row(10, 500.0), _row(20, 100.0, errors=1)]) == (10, True)


def test_both_keywords_must_be_said_unless_one_is_a_wildcard(data: Data) -> None:
    assert search(data, ["i", "drink", "tea"]) == [1]
    assert search(data, ["green", "tea"]) == [0, 1]


def test_a_plan_carries_what_was_said(data: Data) -> None:
    assert "topic=tea value=1.0" in find_plan(data, "I love tea.", Random(1))["kbplan"]
    assert find_plan(data, "Good morning", Random(1))["intent"] == ""


def test_a_kbplan_sets_the_likeliness_and_jumps(data: Data) -> None:
    state = first_state(data)
    kbplan = find_plan(data, "I love tea", Random(1))["kbplan"]
    said = reply(data, state, "I love tea", kbplan, Random(1))
    assert said["dialogue_sentence"] == "A sentence of type p."
    assert (state["topic"], state["likelinesses"]) == (1, {"1": 1.0})


def test_a_talk_covers_topics_and_its_state_survives_the_wire(data: Data) -> None:
    state = first_state(data)
    assert covered(state) == 0
    for _ in range(6):
        reply(data, state, "no", "", Random(1))
    assert covered(state) == 2
    assert unsqueeze(squeeze(state)) == state
