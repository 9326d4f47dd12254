"""The draft's library compiled once per version of the draft, and with one unsaved intent in it."""

from collections import OrderedDict
from dataclasses import dataclass, field
from threading import Lock

import msgspec

from dialogue.draft import draft_version
from plans.content import read_library
from plans.engine.catalogue import Catalogue, LibraryError, compile_catalogue
from plans.engine.intents import Intent, Library
from plans.engine.problems import Problem

MOST_REMEMBERED = 4
_MOST_TRIES = 5


@dataclass(frozen=True, slots=True)
class Compiled:
    """A library that compiles; what had to be left out for that is in `problems`."""

    library: Library
    catalogue: Catalogue
    problems: tuple[Problem, ...]


@dataclass(slots=True)
class _Kept:
    version: int = -1
    draft: Compiled | None = None
    #: The library as it was read: `draft` may have left something out.
    read: Library | None = None
    unsaved: "OrderedDict[bytes, Compiled]" = field(default_factory=OrderedDict)
    lock: Lock = field(default_factory=Lock)


_kept = _Kept()


def draft_library() -> Compiled:
    """Return the draft's library; one query where the draft has not changed since."""
    version = draft_version()
    with _kept.lock:
        if _kept.draft is None or _kept.version != version:
            _kept.draft = _taken(read_library())
            _kept.version = version
        return _kept.draft


def _taken(library: Library) -> Compiled:
    """Return the draft's library; compiled anew unless only what topics say has changed."""
    if _kept.draft is not None and _kept.read == library:
        return _kept.draft
    found = compiled(library)
    _kept.read = library
    _kept.unsaved.clear()
    return found


def with_unsaved(intent: Intent) -> Compiled:
    """Return the draft's library with this intent in the place of the saved one."""
    draft = draft_library()
    key = msgspec.json.encode(intent)
    with _kept.lock:
        found = _kept.unsaved.get(key)
        if found is None:
            found = compiled(_replaced(draft.library, intent))
            _kept.unsaved[key] = found
            while len(_kept.unsaved) > MOST_REMEMBERED:
                _kept.unsaved.popitem(last=False)
        return found


def forget() -> None:
    """Keep nothing: for tests, whose drafts share their numbers."""
    with _kept.lock:
        _kept.draft, _kept.read, _kept.version = None, None, -1
        _kept.unsaved.clear()


def _replaced(library: Library, intent: Intent) -> Library:
    """Return the library with the intent where the one of its number was, or at the end."""
    others = [one for one in library.intents if one.number != intent.number]
    places = [place for place, one in enumerate(library.intents) if one.number == intent.number]
    free = intent.key not in {one.key for one in others}
    fresh = intent if free else msgspec.structs.replace(intent, key=f"{intent.key}_new")
    place = places[0] if places else len(others)
    return msgspec.structs.replace(library, intents=(*others[:place], fresh, *others[place:]))


def compiled(library: Library) -> Compiled:
    """Compile a library; triggers, then intents that cannot be compiled are left out."""
    left_out: list[Problem] = []
    for _try in range(_MOST_TRIES):
        try:
            return Compiled(library, compile_catalogue(library), tuple(left_out))
        except LibraryError as error:
            left_out += error.problems
            library = _without(library, error.problems)
    return Compiled(Library(), compile_catalogue(Library()), tuple(left_out))


def _without(library: Library, problems: tuple[Problem, ...]) -> Library:
    lines = {(one.where, one.language, one.text) for one in problems if one.language and one.text}
    written = {
        (intent.key, code, text)
        for intent in library.intents
        for code, texts in intent.triggers.items()
        for text in texts
    }
    broken = {one.where for one in problems if (one.where, one.language, one.text) not in written}
    phrases = {(one.where, one.language) for one in problems if one.where.startswith("<")}
    return Library(
        intents=tuple(
            _cleaned(intent, lines) for intent in library.intents if intent.key not in broken
        ),
        values=tuple(one for one in library.values if one.key not in broken),
        phrases=tuple(
            msgspec.structs.replace(
                phrase,
                texts={
                    code: text
                    for code, text in phrase.texts.items()
                    if (f"<{phrase.key}>", code) not in phrases
                },
            )
            for phrase in library.phrases
        ),
    )


def _cleaned(intent: Intent, lines: set[tuple[str, str, str]]) -> Intent:
    kept = {
        code: tuple(text for text in texts if (intent.key, code, text) not in lines)
        for code, texts in intent.triggers.items()
    }
    if kept == intent.triggers:
        return intent
    kept = {code: texts for code, texts in kept.items() if texts}
    return msgspec.structs.replace(intent, triggers=kept)
