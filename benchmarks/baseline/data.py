"""What the services of the baseline talk about: topics and intents in plain lists."""

import json
import re
from dataclasses import dataclass
from pathlib import Path
from typing import TypedDict


class Sentence(TypedDict):
    """A sentence and its type, one letter."""

    type: str
    text: str


class Topic(TypedDict):
    """A topic; `keywords` are two sets, `children` are places in the list of topics."""

    name: str
    keywords: list[list[str]]
    likeliness: float
    children: list[int]
    pattern: str
    sentences: list[Sentence]


class Intent(TypedDict):
    """An intent; `triggers` are regular expressions."""

    name: str
    triggers: list[str]
    sentences: list[str]
    plan: str
    kbplan: str


class Lists(TypedDict):
    """All the data."""

    topics: list[Topic]
    roots: list[int]
    intents: list[Intent]


@dataclass(frozen=True, slots=True)
class Data:
    """The data with its regular expressions compiled.

    `remembered`: what was found for a sentence before. Simulated talks have it, services never do.
    """

    topics: list[Topic]
    roots: list[int]
    intents: list[tuple[Intent, list[re.Pattern[str]]]]
    remembered: dict[str, list[int]] | None = None


def compiled(lists: Lists) -> Data:
    """Return the data ready to be searched."""
    intents = [(one, [re.compile(text) for text in one["triggers"]]) for one in lists["intents"]]
    return Data(lists["topics"], lists["roots"], intents)


def read(path: Path) -> Data:
    """Return the data of a file of JSON."""
    return compiled(json.loads(path.read_text(encoding="utf-8")))
