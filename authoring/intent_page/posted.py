"""The form of an intent as it was sent, read without saving anything; what is broken is skipped."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from django.http import QueryDict

from authoring.intent_page.widgets import (
    CultureBoxes,
    Expected,
    LanguageTexts,
    Parameters,
    PriorityChoice,
    decoded,
)
from languages.known import LANGUAGES
from plans.engine.intents import ActionItem, Intent, IntentTest, PlanSentence, Slot

UNNAMED = "this_intent"
MOST_ROWS = 1000
LONGEST = 2000

_texts = LanguageTexts({})
_cultures = CultureBoxes(list)
_parameters, _expected, _priority = Parameters(), Expected(), PriorityChoice()


@dataclass(frozen=True, slots=True)
class Line:
    """One line of the form: the name of its input, its language, its text."""

    name: str
    language: str
    text: str


@dataclass(frozen=True, slots=True)
class Posted:
    """An intent as it stands in the form; the lines know the inputs they came from."""

    intent: Intent
    triggers: tuple[Line, ...]
    sentences: tuple[Line, ...]
    tests: tuple[Line, ...]
    actions: tuple[tuple[str, ActionItem], ...]


def posted_intent(data: QueryDict, number: int) -> Posted:
    """Return the intent a form describes; `number` is 0 for one that was never saved."""
    triggers = tuple(_lines(data, "triggers", "text"))
    sentences = tuple(_lines(data, "plan_sentences", "text"))
    tests = tuple(_lines(data, "tests", "sentence"))
    plan = tuple(_actions(data, "plan_actions"))
    kbplan = tuple(_actions(data, "kbplan_actions"))
    intent = Intent(
        number=number,
        key="_".join(data.get("key", "").lower().split()) or UNNAMED,
        family=data.get("family", "").strip(),
        priority=_priority_of(data),
        slots=tuple(posted_slots(data)),
        abilities=_languages(data, "abilities"),
        triggers=_by_language(triggers, lambda line: line.text),
        plan_sentences=_by_language(
            sentences,
            lambda line: PlanSentence(text=line.text, only=_only(data, line.name)),
        ),
        plan=tuple(item for _name, item in plan),
        kbplan=tuple(item for _name, item in kbplan),
        tests=_by_language(
            tests,
            lambda line: IntentTest(sentence=line.text, parameters=_wanted(data, line.name)),
        ),
    )
    return Posted(intent, triggers, sentences, tests, (*plan, *kbplan))


def posted_slots(data: Mapping[str, Any]) -> Iterator[Slot]:
    """Yield the parameters that a form declares."""
    for row in _rows(data, "slots"):
        name = _text(data, f"{row}-name")
        if name:
            yield Slot(
                name=name,
                kind=_text(data, f"{row}-kind") or "text",
                required=bool(data.get(f"{row}-required")),
                questions=_languages(data, f"{row}-questions"),
            )


def _rows(data: Mapping[str, Any], prefix: str) -> Iterator[str]:
    """Yield the beginnings of the names of rows that are not to be deleted."""
    total = str(data.get(f"{prefix}-TOTAL_FORMS", "0"))
    number = min(int(total), MOST_ROWS) if total.isdecimal() and len(total) < 6 else 0
    for place in range(number):
        if not data.get(f"{prefix}-{place}-DELETE"):
            yield f"{prefix}-{place}"


def _text(data: Mapping[str, Any], name: str) -> str:
    return " ".join(str(data.get(name) or "").splitlines()).strip()[:LONGEST]


def _lines(data: QueryDict, prefix: str, field: str) -> Iterator[Line]:
    """Yield the lines of a part that are filled in, in the order of their places."""
    found = []
    for place, row in enumerate(_rows(data, prefix)):
        language, text = _text(data, f"{row}-language"), _text(data, f"{row}-{field}")
        if language in LANGUAGES and text:
            position = _text(data, f"{row}-position")
            order = int(position) if position.isdecimal() and len(position) < 9 else MOST_ROWS
            found.append((order, place, Line(f"{row}-{field}", language, text)))
    yield from (line for _order, _place, line in sorted(found, key=lambda one: one[:2]))


def _by_language(lines: tuple[Line, ...], made: Any) -> dict[str, tuple[Any, ...]]:
    groups: dict[str, list[Any]] = {}
    for line in lines:
        groups.setdefault(line.language, []).append(made(line))
    return {code: tuple(groups[code]) for code in LANGUAGES if code in groups}


def _languages(data: Mapping[str, Any], name: str) -> dict[str, str]:
    texts = decoded(_texts.value_from_datadict(data, None, name))
    texts = texts if isinstance(texts, dict) else {}
    return {code: text for code, text in texts.items() if code in LANGUAGES and _is_text(text)}


def _is_text(text: object) -> bool:
    return isinstance(text, str) and bool(text)


def _only(data: QueryDict, name: str) -> tuple[str, ...]:
    row = name.rpartition("-")[0]
    return tuple(_cultures.value_from_datadict(data, None, f"{row}-only").split())


def _wanted(data: QueryDict, name: str) -> dict[str, str] | None:
    row = name.rpartition("-")[0]
    wanted = decoded(_expected.value_from_datadict(data, None, f"{row}-parameters"))
    if not isinstance(wanted, dict):
        return None
    return {str(key): str(value) for key, value in wanted.items()}


def _actions(data: QueryDict, prefix: str) -> Iterator[tuple[str, ActionItem]]:
    for row in _rows(data, prefix):
        action = _text(data, f"{row}-action")
        pairs = decoded(_parameters.value_from_datadict(data, None, f"{row}-parameters"))
        pairs = pairs if isinstance(pairs, list) else []
        parameters = tuple(
            (str(pair[0]), str(pair[1]))
            for pair in pairs
            if isinstance(pair, list) and len(pair) == 2
        )
        if action:
            yield f"{row}-action", ActionItem(action=action, parameters=parameters)


def _priority_of(data: QueryDict) -> int:
    text = str(_priority.value_from_datadict(data, None, "priority") or "")
    return min(int(text), 100) if text.isdecimal() and len(text) < 4 else 50
