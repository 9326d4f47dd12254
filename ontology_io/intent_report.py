"""What check_intents prints: a table of the intents, what failed, and where it stands."""

import re
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from plans.engine.intents import Library
from plans.engine.stored_tests import TestedSpeech

_BEGINS = re.compile(r"- \{?id: ([a-z][a-z0-9_]*)")


class Places:
    """Where the intents of a folder stand: the line of a trigger or test, else of its intent."""

    def __init__(self, folder: Path) -> None:
        self._blocks: dict[str, tuple[str, int, list[str]]] = {}
        for file in sorted(folder.rglob("*.yaml")):
            if "intents" in str(file.relative_to(folder)):
                self._read(file, f"{folder.name}/{file.relative_to(folder)}")

    def _read(self, file: Path, name: str) -> None:
        block: list[str] = []
        for number, line in enumerate(file.read_text("utf-8").splitlines(), 1):
            begins = _BEGINS.match(line)
            if begins:
                block = []
                self._blocks.setdefault(begins[1], (name, number, block))
            block.append(line)

    def of(self, key: str, near: str = "") -> str:
        """Return `content/intents_media.yaml:12: `, or "" where the key stands nowhere."""
        key = key.strip("<>")
        if key not in self._blocks:
            return ""
        name, first, block = self._blocks[key]
        lines = (place for place, line in enumerate(block) if near and near in line)
        return f"{name}:{first + next(lines, 0)}: "


def table(tested: Sequence[TestedSpeech]) -> Iterator[str]:
    """Yield a row for each intent: in each language triggers/plan sentences/tests."""
    codes = list(dict.fromkeys(each.language for each in tested))
    by_intent: dict[str, list[TestedSpeech]] = {}
    for each in tested:
        by_intent.setdefault(each.intent.key, []).append(each)
    rows = [["family", "intent", "priority", *codes, "passed", "failed"]]
    rows += [_row(these) for these in by_intent.values()]
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    for row in rows:
        cells = (cell.ljust(width) for cell, width in zip(row, widths, strict=True))
        yield "  ".join(cells).rstrip()
    yield f"{codes and ', '.join(codes)}: triggers/plan sentences/tests."


def _row(these: list[TestedSpeech]) -> list[str]:
    intent = these[0].intent
    speech = [
        f"{each.triggers}/{each.plan_sentences}/{each.positive + each.must_not_match}"
        for each in these
    ]
    passed = sum(each.passed for each in these)
    failed = sum(len(each.failures) for each in these)
    return [intent.family, intent.key, str(intent.priority), *speech, str(passed), str(failed)]


def failures(tested: Iterable[TestedSpeech], places: Places) -> Iterator[str]:
    """Yield a line for each test that failed."""
    for each in tested:
        for one in each.failures:
            place = places.of(one.intent, one.sentence)
            yield f"{place}{one.intent} ({one.language}): '{one.sentence}' {one.reason}."


def totals(library: Library, tested: Sequence[TestedSpeech]) -> str:
    """Return how much was checked, in one line."""
    keys = {each.intent.key for each in tested}
    triggers = sum(each.triggers for each in tested)
    passed = sum(each.passed for each in tested)
    failed = sum(len(each.failures) for each in tested)
    return (
        f"{len(keys)} of {len(library.intents)} intents, {triggers} triggers: "
        f"{passed} tests passed, {failed} failed"
    )
