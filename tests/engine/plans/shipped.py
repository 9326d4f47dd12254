"""Reads content/intents.yaml into a Library, for the tests only."""

from functools import cache
from pathlib import Path
from typing import Any

import yaml

from plans.engine.catalogue import Catalogue, compile_catalogue
from plans.engine.intents import (
    Intent,
    IntentTest,
    Library,
    Phrase,
    PlanSentence,
    Slot,
    ValueList,
)
from plans.engine.plan_text import parse_plan

FILE = Path(__file__).parents[3] / "content" / "intents.yaml"
LANGUAGES = ("en", "it", "ja")


@cache
def library() -> Library:
    data = yaml.load(FILE.read_text("utf-8"), Loader=yaml.BaseLoader)  # noqa: S506 (no objects)
    return Library(
        intents=tuple(intent(number, row) for number, row in enumerate(data["intents"], start=1)),
        values=tuple(value_list(row) for row in data.get("values", [])),
        phrases=tuple(
            Phrase(key=row["id"], texts={key: row[key] for key in row if key != "id"})
            for row in data.get("phrases", [])
        ),
    )


@cache
def catalogue() -> Catalogue:
    return compile_catalogue(library())


def value_list(row: dict[str, Any]) -> ValueList:
    values = {
        language: {name: tuple(text.split("|")) for name, text in row[language].items()}
        for language in LANGUAGES
        if language in row
    }
    return ValueList(key=row["id"], values=values)


def intent(number: int, row: dict[str, Any]) -> Intent:
    texts = {language: row[language] for language in LANGUAGES if language in row}
    return Intent(
        number=number,
        key=row["id"],
        priority=int(row["priority"]),
        slots=tuple(slot(name, kind) for name, kind in row.get("slots", {}).items()),
        triggers={key: tuple(text["triggers"]) for key, text in texts.items()},
        plan_sentences={key: tuple(map(says, text.get("says", []))) for key, text in texts.items()},
        plan=parse_plan(row.get("plan", "")),
        kbplan=parse_plan(row.get("kbplan", "")),
        tests={key: tuple(map(stored_test, text.get("tests", []))) for key, text in texts.items()},
        note=row.get("note", ""),
    )


def slot(name: str, kind: str) -> Slot:
    words = kind.split()
    return Slot(name=name, kind=words[0], required="required" in words)


def says(row: str | dict[str, Any]) -> PlanSentence:
    if isinstance(row, str):
        return PlanSentence(text=row)
    return PlanSentence(text=row["text"], only=tuple(row["only"]))


def stored_test(line: str) -> IntentTest:
    sentence, _, expected = line.partition(" -> ")
    if expected == "no":
        return IntentTest(sentence=sentence, parameters=None)
    pairs = (pair.partition("=") for pair in expected.split(" | ") if pair)
    return IntentTest(sentence=sentence, parameters={key: value for key, _, value in pairs})
