"""What operators are given: the dashboard asks for numbers there are; the audit tells the truth."""

import importlib.util
import json
import re
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from cair_site import metrics
from cair_site.errors import ERRORS

ROOT = Path(__file__).parents[2]
DASHBOARD = json.loads((ROOT / "deploy" / "grafana" / "cair.json").read_text(encoding="utf-8"))
NAME = re.compile(r"\bcair_\w+")
LABELS = {"job", "le", "service", "language", "plan", "code", "result"}


def expressions(node: Any) -> list[str]:
    """Return every query of the dashboard."""
    if isinstance(node, list):
        return [text for one in node for text in expressions(one)]
    if not isinstance(node, dict):
        return []
    own = [node[key] for key in ("expr", "query") if isinstance(node.get(key), str)]
    return own + [text for one in node.values() for text in expressions(one)]


def exposed() -> set[str]:
    """Return the names of all metrics, as Prometheus stores them."""
    metrics.count_turn("hub", "en", 0.1, plan=True, state=10)
    metrics.count_error("not_found")
    metrics.count_login("done")
    text = metrics.text().decode()
    return {line.split("{")[0].split(" ")[0] for line in text.splitlines() if line[:1] != "#"}


def test_every_query_names_a_metric_there_is() -> None:
    asked = {name for text in expressions(DASHBOARD) for name in NAME.findall(text)}
    assert len(asked) >= 8
    assert asked <= exposed()


def test_every_metric_is_on_the_dashboard() -> None:
    asked = {name for text in expressions(DASHBOARD) for name in NAME.findall(text)}
    ours = {name for name in exposed() if not name.endswith(("_created", "_sum", "_count"))}
    assert ours - asked <= {"cair_start_time_seconds"}


def test_every_query_groups_by_labels_there_are() -> None:
    for text in expressions(DASHBOARD):
        grouped = re.findall(r"by \(([^)]*)\)", text)
        matched = re.findall(r'(\w+)(?:=~|=)"', text)
        names = {name.strip() for group in grouped for name in group.split(",")} | set(matched)
        assert names <= LABELS, text
        assert text.count("(") == text.count(")"), text


def test_the_codes_on_the_dashboard_are_errors_there_are() -> None:
    found = [one for text in expressions(DASHBOARD) for one in re.findall(r'code=~"([^"]*)"', text)]
    codes = {code for one in found for code in one.split("|")}
    assert codes
    assert codes <= ERRORS.keys()


def test_panels_have_places_and_numbers_of_their_own() -> None:
    panels = DASHBOARD["panels"]
    assert len({panel["id"] for panel in panels}) == len(panels)
    squares = [
        (x, y)
        for panel in panels
        for x in range(panel["gridPos"]["x"], panel["gridPos"]["x"] + panel["gridPos"]["w"])
        for y in range(panel["gridPos"]["y"], panel["gridPos"]["y"] + panel["gridPos"]["h"])
    ]
    assert len(set(squares)) == len(squares)
    assert all(x < 24 for x, _y in squares)


@pytest.fixture(scope="module")
def audit() -> ModuleType:
    """Return deploy/audit.py."""
    spec = importlib.util.spec_from_file_location("audit", ROOT / "deploy" / "audit.py")
    assert spec
    assert spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def report(*packages: dict[str, Any]) -> str:
    return json.dumps({"dependencies": list(packages), "fixes": []})


GOOD = {"name": "a", "version": "1", "vulns": []}
BAD = {"name": "b", "version": "2", "vulns": [{"id": "X-1", "fix_versions": ["3"]}]}
UNSEEN = {"name": "c", "skip_reason": "not found"}


@pytest.mark.parametrize(
    ("printed", "trouble", "expected"),
    [
        (report(GOOD), "", (0, "1 packages audited, 0 with known faults")),
        (report(GOOD, BAD), "", (1, "b 2: X-1, mended in 3")),
        (report(GOOD, UNSEEN), "", (0, "Not audited: c")),
        (report(UNSEEN), "", (0, "Audit skipped")),
        ("", "requests.exceptions.ConnectionError: nobody", (0, "Audit skipped")),
        ("", "TypeError: something", (2, "The audit broke: TypeError")),
        ("", "", (2, "The audit broke")),
    ],
)
def test_the_audit_says_what_it_did(
    audit: ModuleType,
    capsys: pytest.CaptureFixture[str],
    printed: str,
    trouble: str,
    expected: tuple[int, str],
) -> None:
    assert audit.judged(printed, trouble) == expected[0]
    assert expected[1] in capsys.readouterr().out
