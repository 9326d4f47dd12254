"""Invented content of any size, and how growth is told."""

from pathlib import Path

import pytest

pytest.importorskip("tqdm")

from benchmarks.growth import rows
from benchmarks.growth.contents import knowledge_of, sentences_a_topic, talked
from benchmarks.growth.rows import Row, ratio, series, table
from dialogue.engine.codec import decode, encode
from dialogue.engine.content import Content, build_content
from plans.engine.intents import Library

ROWS = [
    Row(rows.TOPICS, 3_000, rows.TURN, "0 topics covered", 400.0),
    Row(rows.TOPICS, 30_000, rows.TURN, "0 topics covered", 500.0),
    Row(rows.TOPICS, 300, rows.TURN, "0 topics covered", 390.0),
    Row(rows.TOPICS, 3_000, rows.LOAD, "", 1.5),
]
KEYS = (b"a key of the tests, long enough.",)


@pytest.fixture(scope="module")
def content() -> Content:
    return build_content(knowledge_of(300), Library())


def test_content_has_about_the_size_that_was_asked_for(content: Content) -> None:
    assert len(content.tree.nodes) == 160 + 2 * 96


def test_leaves_get_more_sentences(content: Content) -> None:
    talkative = build_content(knowledge_of(300, sentences=10), Library())
    assert sentences_a_topic(talkative) > sentences_a_topic(content) + 2


def test_classes_stay_small_where_they_should(content: Content) -> None:
    def widest(fan_out: int) -> int:
        made = build_content(knowledge_of(1_300, fan_out=fan_out), Library())
        return max(len(node.children) for node in made.tree.nodes.values())

    assert (widest(5), widest(1_300)) == (5, 11)


@pytest.mark.parametrize("covered", [0, 1, 120])
def test_a_state_covers_as_many_topics_as_asked_for_and_can_be_written(
    content: Content, covered: int
) -> None:
    state = talked(content, covered)
    assert len(state.covered_topics()) == covered
    assert decode(encode(state, KEYS), KEYS) == state


def test_points_come_in_the_order_of_their_size() -> None:
    points = series(ROWS, rows.TOPICS, rows.TURN)["0 topics covered"]
    assert points == [(300, 390.0), (3_000, 400.0), (30_000, 500.0)]
    assert ratio(points) == 1.25


def test_a_table_leaves_out_what_was_not_measured() -> None:
    lines = table(ROWS, rows.TOPICS).strip().splitlines()
    assert lines[0] == "| topics | 300 | 3,000 | 30,000 | last / before |"
    assert lines[2] == "| turn, 0 topics covered, µs | 390 | 400 | 500 | 1.25 × |"
    assert lines[3] == "| load, s |  | 1.50 |  |  |"


def test_rows_come_back_from_their_file(tmp_path: Path) -> None:
    file = tmp_path / "new" / "growth.csv"
    rows.write(file, ROWS)
    assert rows.read(file) == ROWS
