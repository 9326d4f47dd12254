"""Read and write the files of intents: phrases, value lists, intents with their tests."""

from collections.abc import Mapping
from typing import TypeVar

from languages.known import LANGUAGES
from ontology_io.files.emit import flow_list, flow_map, flow_scalar, raw_map, scalar
from ontology_io.files.nodes import Problems, Value, each, parse
from plans.engine.intents import (
    ActionItem,
    Intent,
    IntentTest,
    Library,
    Phrase,
    PlanSentence,
    Slot,
    ValueList,
)
from plans.engine.plan_text import PlanTextError, parse_plan, print_plan

SECTIONS = ("phrases", "values", "intents")
Said = TypeVar("Said")
CODES = frozenset(LANGUAGES)
NAMED_KEYS = frozenset(("id",)) | CODES
INTENT_KEYS = frozenset(("id", "priority", "slots", "ask", "plan", "kbplan", "note")) | CODES
SPEECH_KEYS = frozenset(("can", "triggers", "says", "tests"))
SAID_KEYS = frozenset(("only", "text"))
REQUIRED = " required"
ARROW, BETWEEN, MUST_NOT = " -> ", " | ", "no"


def read_library(text: str, problems: Problems, family: str = "") -> Library:
    """Return what one file says; its intents are of the family the file is named for."""
    entries = parse(text, problems, SECTIONS)
    return Library(
        phrases=tuple(_phrase(value) for value in each(entries, "phrases")),
        values=tuple(_value_list(value) for value in each(entries, "values")),
        intents=tuple(_intent(value, family) for value in each(entries, "intents")),
    )


def _text(entries: Mapping[str, Value], key: str, default: str = "") -> str:
    return entries[key].text() if key in entries else default


def _phrase(value: Value) -> Phrase:
    entries = value.known_entries(NAMED_KEYS)
    texts = {code: entries[code].text() for code in LANGUAGES if code in entries}
    return Phrase(key=_text(entries, "id"), texts=texts)


def _value_list(value: Value) -> ValueList:
    entries = value.known_entries(NAMED_KEYS)
    values = {
        code: {
            canonical: tuple(word.strip() for word in words.split("|") if word.strip())
            for canonical, words in entries[code].text_entries().items()
        }
        for code in LANGUAGES
        if code in entries
    }
    return ValueList(key=_text(entries, "id"), values=values)


def _intent(value: Value, family: str) -> Intent:
    entries = value.known_entries(INTENT_KEYS)
    speech = {
        code: entries[code].known_entries(SPEECH_KEYS) for code in LANGUAGES if code in entries
    }
    priority = _text(entries, "priority", "50")
    if not priority.isdecimal() or int(priority) > 100:
        value.problems.add(value.line, f"The priority {priority!r} must be a number 0 to 100.")
        priority = "50"
    return Intent(
        number=0,
        key=_text(entries, "id"),
        family=family,
        priority=int(priority),
        slots=_slots(entries),
        abilities={code: one["can"].text() for code, one in speech.items() if "can" in one},
        triggers=_filled({code: _texts(one, "triggers") for code, one in speech.items()}),
        plan_sentences=_filled(
            {code: tuple(map(_plan_sentence, each(one, "says"))) for code, one in speech.items()}
        ),
        plan=_plan(entries, "plan"),
        kbplan=_plan(entries, "kbplan"),
        tests=_filled(
            {code: tuple(map(_test, each(one, "tests"))) for code, one in speech.items()}
        ),
        note=_text(entries, "note"),
    )


def _filled(by_language: dict[str, tuple[Said, ...]]) -> dict[str, tuple[Said, ...]]:
    """Return it without the languages in which nothing is said, as the database gives it."""
    return {code: rows for code, rows in by_language.items() if rows}


def _texts(entries: Mapping[str, Value], key: str) -> tuple[str, ...]:
    return entries[key].texts() if key in entries else ()


def _slots(entries: Mapping[str, Value]) -> tuple[Slot, ...]:
    kinds = entries["slots"].text_entries() if "slots" in entries else {}
    questions = entries["ask"].entries() if "ask" in entries else {}
    return tuple(
        Slot(
            name=name,
            kind=kind.removesuffix(REQUIRED),
            required=kind.endswith(REQUIRED),
            questions=questions[name].text_entries() if name in questions else {},
        )
        for name, kind in kinds.items()
    )


def _plan_sentence(value: Value) -> PlanSentence:
    if value.is_text:
        return PlanSentence(text=value.text())
    entries = value.known_entries(SAID_KEYS)
    return PlanSentence(
        text=_text(entries, "text"), only=entries["only"].texts() if "only" in entries else ()
    )


def _plan(entries: Mapping[str, Value], key: str) -> tuple[ActionItem, ...]:
    if key not in entries:
        return ()
    try:
        return parse_plan(entries[key].text())
    except PlanTextError as error:
        entries[key].problems.add(entries[key].line, str(error))
        return ()


def _test(value: Value) -> IntentTest:
    """Read `sentence`, `sentence -> name=value | name=value` or `sentence -> no`."""
    sentence, _, expected = value.text().partition(ARROW)
    if expected == MUST_NOT:
        return IntentTest(sentence=sentence)
    pairs = [part.partition("=") for part in expected.split(BETWEEN) if part]
    return IntentTest(sentence=sentence, parameters={name: text for name, _, text in pairs})


def write_library(library: Library) -> str:
    """Return the text of one file with everything the library holds."""
    lines = []
    if library.phrases:
        lines.append("phrases:")
    for phrase in library.phrases:
        lines.append("- " + flow_map({"id": phrase.key} | phrase.texts))
    if library.values:
        lines.append("values:")
    for value_list in library.values:
        lines += _value_list_lines(value_list)
    if library.intents:
        lines.append("intents:")
    for intent in library.intents:
        lines += _intent_lines(intent)
    return "\n".join(lines) + "\n"


def _value_list_lines(value_list: ValueList) -> list[str]:
    return [
        f"- id: {flow_scalar(value_list.key)}",
        *(
            f"  {code}: {flow_map({name: '|'.join(words) for name, words in values.items()})}"
            for code, values in value_list.values.items()
        ),
    ]


def _intent_lines(intent: Intent) -> list[str]:
    lines = [f"- id: {intent.key}", f"  priority: {intent.priority}"]
    if intent.slots:
        kinds = {slot.name: slot.kind + REQUIRED * slot.required for slot in intent.slots}
        lines.append(f"  slots: {flow_map(kinds)}")
    questions = {slot.name: flow_map(slot.questions) for slot in intent.slots if slot.questions}
    if questions:
        lines.append(f"  ask: {raw_map(questions)}")
    for name, plan in (("plan", intent.plan), ("kbplan", intent.kbplan)):
        if plan:
            lines.append(f"  {name}: {scalar(print_plan(plan))}")
    if intent.note:
        lines.append(f"  note: {scalar(intent.note)}")
    for code in LANGUAGES:
        if any(code in said for said in _said(intent)):
            lines += _speech_lines(intent, code)
    return lines


def _said(intent: Intent) -> tuple[Mapping[str, object], ...]:
    return intent.abilities, intent.triggers, intent.plan_sentences, intent.tests


def _speech_lines(intent: Intent, code: str) -> list[str]:
    said = [
        f"{{only: {flow_list(one.only)}, text: {flow_scalar(one.text)}}}"
        if one.only
        else scalar(one.text)
        for one in intent.plan_sentences.get(code, ())
    ]
    sections = {
        "triggers": [scalar(text) for text in intent.triggers.get(code, ())],
        "says": said,
        "tests": [scalar(_test_text(test)) for test in intent.tests.get(code, ())],
    }
    lines = [f"  {code}:"]
    if code in intent.abilities:
        lines.append(f"    can: {scalar(intent.abilities[code])}")
    for name, rows in sections.items():
        if rows:
            lines += [f"    {name}:", *(f"    - {row}" for row in rows)]
    return lines


def _test_text(test: IntentTest) -> str:
    if test.parameters is None:
        return f"{test.sentence}{ARROW}{MUST_NOT}"
    pairs = BETWEEN.join(f"{name}={text}" for name, text in test.parameters.items())
    return f"{test.sentence}{ARROW}{pairs}" if pairs else test.sentence
