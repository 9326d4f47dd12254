"""What a trial counts, writes and concludes, without a cluster."""

import csv
import json
import threading
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest

from cluster.load import Counted, Load, share_of
from cluster.report import HEADINGS, Row, Seen, write_report
from cluster.trial import faults

GOOD = Counted(100, 0, 0, 0.004, 0.02, 0.5)


class Forgetful(BaseHTTPRequestHandler):
    """A service whose third turn fails, and whose states never count beyond two turns."""

    protocol_version = "HTTP/1.1"
    turns = 0

    def do_POST(self) -> None:
        asked = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
        status, said = 200, self._said(asked)
        if "client_sentence" in asked:
            type(self).turns += 1
            status = 503 if self.turns == 3 else 200
        text = json.dumps(said).encode()
        self.send_response(status)
        self.send_header("Content-Length", str(len(text)))
        self.end_headers()
        self.wfile.write(text)

    def _said(self, asked: dict[str, object]) -> dict[str, object]:
        if self.path.endswith("/inspect/"):
            return {"turn": 2, "seed": 1, "language": "en"}
        return {"dialogue_state": "s", "dialogue_sentence": "yes", "plan_sentence": ""}

    def log_message(self, format: str, *arguments: object) -> None:
        """Keep quiet."""


@pytest.fixture
def forgetful() -> Iterator[int]:
    server = ThreadingHTTPServer(("127.0.0.1", 0), Forgetful)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    yield server.server_port
    server.shutdown()
    server.server_close()


def test_a_failed_turn_and_a_state_that_was_lost_are_counted(forgetful: int) -> None:
    with Load(forgetful, talkers=1, a_second=200) as load:
        until = threading.Event()
        while len(load.talkers[0].samples) < 12 and not until.wait(0.02):
            pass
    counted = load.counted(0, float("inf"))
    assert counted.failed == 1
    assert counted.turns >= 11
    assert counted.not_continued == load.inspected() >= 2
    assert "503" in counted.faults[0]
    assert "(2, 1, 'en') instead of (5, 1, 'en')" in counted.faults[1]


def test_turns_that_were_counted_can_be_forgotten(forgetful: int) -> None:
    with Load(forgetful, talkers=1, a_second=200) as load:
        until = threading.Event()
        while len(load.talkers[0].samples) < 5 and not until.wait(0.02):
            pass
    load.forget(float("inf"))
    assert load.counted(0, float("inf")).turns == 0


def test_a_share_of_nothing_is_nothing() -> None:
    assert share_of([], 0.99) == 0
    assert share_of([1.0, 2.0, 3.0, 4.0], 0.5) == 3.0
    assert share_of([1.0, 2.0], 1.0) == 2.0


def row(what: str, counted: Counted, *served: float | None) -> Row:
    seen = Seen()
    for seconds in served:
        seen.take_over(seconds, "all nodes")
    return Row(what, 5.0, counted, seen)


def test_a_trial_without_faults_keeps_every_promise() -> None:
    assert faults([row("a", GOOD, 2.5), row("all of it", GOOD)]) == []


@pytest.mark.parametrize("served", [5.1, None])
def test_a_publication_that_comes_late_or_never_is_a_fault(served: float | None) -> None:
    assert len(faults([row("a", GOOD, served), row("all of it", GOOD)])) == 1


@pytest.mark.parametrize("bad", [Counted(9, 1, 0, 0, 0, 0), Counted(9, 0, 1, 0, 0, 0)])
def test_one_failed_turn_or_lost_state_is_a_fault(bad: Counted) -> None:
    assert faults([row("a", GOOD), row("all of it", bad)])


def test_the_table_is_written_twice_with_the_same_cells(tmp_path: Path) -> None:
    rows = [row("a node is killed", GOOD, 2.5), row("all of it", GOOD)]
    page = write_report(rows, "Two nodes.", tmp_path)
    assert page == (tmp_path / "cluster-trial.md").read_text(encoding="utf-8")
    assert "| a node is killed | 5.0 | 100 | 0 | 0 | 4 | 20 | 500 | 2.5 (all nodes) |  |" in page
    with (tmp_path / "cluster-trial.csv").open(encoding="utf-8", newline="") as file:
        table = list(csv.reader(file))
    assert table[0] == list(HEADINGS)
    assert [tuple(cells) for cells in table[1:]] == [one.cells() for one in rows]
