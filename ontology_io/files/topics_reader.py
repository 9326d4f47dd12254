"""Read a branch file: classes, leaves, lines (docs/content-format.md)."""

import re
from collections.abc import Mapping
from dataclasses import dataclass

import msgspec

from dialogue.engine.concepts import Frame, Topic, usual_likeliness
from languages.known import LANGUAGES
from ontology_io.files.nodes import LONGEST_TEXT, Problems, Value, each, parse

TOPIC_KEYS = frozenset(
    [
        "id",
        "is_a",
        "also",
        "of",
        "gentle",
        "stop",
        "pattern",
        "vars",
        "kw",
        "like",
        "individuals",
        "see",
        "note",
        "s",
    ]
) | frozenset(LANGUAGES)
LINE_KEYS = frozenset(("at", "id", "only", "scope", "do")) | frozenset(LANGUAGES)
FRAME_KEYS = LINE_KEYS - {"at", "id"}
SECTIONS = ("classes", "leaves", "lines")
SCOPES = ("", "self", "below")
LONGEST_SENTENCE, LONGEST_ACTIVITY, LONGEST_VARIABLE, LONGEST_WORDS = 400, 200, 120, 2000

_TOPIC_ID = re.compile(r"[A-Za-z][A-Za-z0-9]{0,99}")
_FRAME_ID = re.compile(r"[a-z][0-9]{1,4}")
_VARIABLE = re.compile(r"[a-z][a-z_]{0,39}")
_INDIVIDUAL = re.compile(r"[A-Za-z][A-Za-z0-9_.-]{0,99}")
_LIKE = re.compile(r"([A-Z]{2,8})\s+(0?\.\d{1,3}|[01](?:\.0{1,3})?)")


@dataclass(frozen=True, slots=True)
class Place:
    """Where a topic or a frame is written, for later errors."""

    file: str
    line: int


def read_topics(
    text: str, problems: Problems, cultures: tuple[str, ...]
) -> tuple[tuple[Topic, ...], dict[str, Place]]:
    """Return the topics of a branch file in order, with the place of each topic and frame."""
    entries = parse(text, problems, SECTIONS)
    places: dict[str, Place] = {}
    topics: dict[str, Topic] = {}
    for section in SECTIONS[:2]:
        for value in each(entries, section):
            topic = _topic(value, problems, cultures, places)
            if topic.key in topics:
                problems.add(value.line, f"The topic {topic.key} stands in this file twice.")
            places[topic.key] = Place(problems.file, value.line)
            topics[topic.key] = topic
    for value in each(entries, "lines"):
        _add_line(value, problems, topics, places)
    return tuple(topics.values()), places


def _topic(
    value: Value, problems: Problems, cultures: tuple[str, ...], places: dict[str, Place]
) -> Topic:
    entries = value.known_entries(TOPIC_KEYS)
    key = _text(entries, "id")
    if not _TOPIC_ID.fullmatch(key):
        problems.add(value.line, f"The id {key!r} must be one word of letters and digits.")
    of = _text(entries, "of")
    return Topic(
        key=key,
        is_a=_text(entries, "is_a"),
        also=_list(entries, "also"),
        of=of,
        gentle=_is_gentle(entries),
        stop="".join(_list(entries, "stop")),
        pattern=_patterns(_text(entries, "pattern", LONGEST_ACTIVITY)),
        variables=_variables(entries, problems),
        names={c: entries[c].text_entries() for c in LANGUAGES if c in entries},
        keywords=_keywords(entries, problems),
        likeliness=usual_likeliness(of, cultures) | _likeliness(entries, problems, cultures),
        individuals=_individuals(entries, problems, cultures),
        see=_list(entries, "see"),
        note=_text(entries, "note"),
        frames=_frames(entries, key, places, problems),
    )


def _text(entries: Mapping[str, Value], key: str, longest: int = LONGEST_TEXT) -> str:
    return entries[key].text(longest) if key in entries else ""


def _list(entries: Mapping[str, Value], key: str) -> tuple[str, ...]:
    return entries[key].texts() if key in entries else ()


def _is_gentle(entries: Mapping[str, Value]) -> bool:
    text = _text(entries, "gentle")
    if text not in ("", "yes", "no"):
        entries["gentle"].problems.add(entries["gentle"].line, f"{text!r} must be yes or no.")
    return text == "yes"


def _patterns(text: str) -> tuple[str, ...]:
    return tuple(part.strip() for part in text.split(" | ")) if text.strip() else ()


def _variables(entries: Mapping[str, Value], problems: Problems) -> dict[str, dict[str, str]]:
    variables: dict[str, dict[str, str]] = {}
    for name, value in entries["vars"].entries().items() if "vars" in entries else ():
        language, dot, variable = name.partition(".")
        if not dot or language not in LANGUAGES or not _VARIABLE.fullmatch(variable):
            problems.add(value.line, f"{name!r} must be a language and a name, e.g. en.unit.")
        else:
            variables.setdefault(language, {})[variable] = value.text(LONGEST_VARIABLE)
    return {code: variables[code] for code in LANGUAGES if code in variables}


def _keywords(
    entries: Mapping[str, Value], problems: Problems
) -> dict[str, tuple[tuple[str, ...], tuple[str, ...]]]:
    if "kw" not in entries:
        return {}
    keywords = {}
    for language, value in entries["kw"].known_entries(frozenset(LANGUAGES)).items():
        text = value.text(2 * LONGEST_WORDS)
        first, slash, second = text.partition(" / ")
        if not slash or " / " in second:
            problems.add(value.line, f"{text!r} needs two sets, e.g. green / tea|chai.")
        keywords[language] = (_alternatives(first), _alternatives(second))
    return {code: keywords[code] for code in LANGUAGES if code in keywords}


def _individuals(
    entries: Mapping[str, Value], problems: Problems, cultures: tuple[str, ...]
) -> dict[str, str]:
    if "individuals" not in entries:
        return {}
    names = entries["individuals"].known_entries(frozenset(cultures))
    for value in names.values():
        if not _INDIVIDUAL.fullmatch(value.text()):
            problems.add(value.line, f"{value.text()!r} is no name of an individual, e.g. EN_TEA.")
    return {code: names[code].text() for code in cultures if code in names}


def _alternatives(text: str) -> tuple[str, ...]:
    return tuple(word.strip() for word in text.split("|") if word.strip())


def _likeliness(
    entries: Mapping[str, Value], problems: Problems, cultures: tuple[str, ...]
) -> dict[str, float]:
    text = _text(entries, "like")
    pairs = _LIKE.findall(text)
    codes = [code for code, _ in pairs]
    # Where cultures.yaml cannot be read, that one problem is enough.
    unknown = {*codes} - {*cultures} if cultures else ()
    if _LIKE.sub("", text).strip() or unknown or len({*codes}) < len(codes):
        problems.add(
            entries["like"].line,
            f"{text!r} must be cultures, each once, with values 0 to 1, e.g. IT .9 JP .3 "
            f"(cultures: {' '.join(cultures)}).",
        )
        return {}
    return {code: float(value) for code, value in pairs}


def _frames(
    entries: Mapping[str, Value], key: str, places: dict[str, Place], problems: Problems
) -> tuple[Frame, ...]:
    frames = []
    for local, value in entries["s"].entries().items() if "s" in entries else ():
        frame = _frame(f"{key}.{local}", local, value, value.known_entries(FRAME_KEYS))
        places[frame.key] = Place(problems.file, value.line)
        frames.append(frame)
    return tuple(frames)


def _frame(key: str, local: str, value: Value, entries: Mapping[str, Value]) -> Frame:
    if not _FRAME_ID.fullmatch(local):
        value.problems.add(value.line, f"{local!r} must be a type and a number, e.g. q1.")
    scope = _text(entries, "scope")
    if scope not in SCOPES:
        value.problems.add(entries["scope"].line, f"{scope!r} must be self or below.")
    return Frame(
        key=key,
        type=local[:1],
        texts={c: entries[c].text(LONGEST_SENTENCE) for c in LANGUAGES if c in entries},
        only=_list(entries, "only"),
        scope=scope,
        do=_text(entries, "do", LONGEST_ACTIVITY),
    )


def _add_line(
    value: Value, problems: Problems, topics: dict[str, Topic], places: dict[str, Place]
) -> None:
    entries = value.known_entries(LINE_KEYS)
    at, local = _text(entries, "at"), _text(entries, "id")
    if at not in topics:
        problems.add(value.line, f"The line is at {at!r}, but this file has no such topic.")
        return
    frame = _frame(f"{at}.{local}", local, value, entries)
    if frame.key in places:
        problems.add(value.line, f"The sentence {frame.key} stands in this file twice.")
    places[frame.key] = Place(problems.file, value.line)
    topics[at] = msgspec.structs.replace(topics[at], frames=(*topics[at].frames, frame))
