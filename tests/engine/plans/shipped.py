"""Reads the intents of content/ into a Library, for the tests only."""

from functools import cache
from pathlib import Path

import msgspec

from ontology_io.files.intents_files import read_library
from ontology_io.files.nodes import Problems
from plans.engine.catalogue import Catalogue, compile_catalogue
from plans.engine.intents import Intent, Library

CONTENT = Path(__file__).parents[3] / "content"
LANGUAGES = ("en", "it", "ja")


@cache
def library() -> Library:
    files = sorted(CONTENT.glob("intents*.yaml"))
    libraries = [_read(file) for file in files]
    intents = (intent for one in libraries for intent in one.intents)
    return Library(
        intents=tuple(_numbered(number, intent) for number, intent in enumerate(intents, 1)),
        values=tuple(values for one in libraries for values in one.values),
        phrases=tuple(phrase for one in libraries for phrase in one.phrases),
    )


def _numbered(number: int, intent: Intent) -> Intent:
    return msgspec.structs.replace(intent, number=number)


def _read(file: Path) -> Library:
    problems = Problems(file.name)
    found = read_library(file.read_text("utf-8"), problems, file.stem.partition("_")[2])
    assert not problems.found, problems.found
    return found


@cache
def catalogue() -> Catalogue:
    return compile_catalogue(library())
