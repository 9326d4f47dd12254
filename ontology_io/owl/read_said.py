"""Sentences: on classes as restrictions, on individuals and pools as assertions."""

from collections.abc import Iterator

from msgspec.structs import replace

from ontology_io.owl.axioms import Restriction
from ontology_io.owl.facts import Node, Rows, Text
from ontology_io.owl.file_records import Said
from ontology_io.owl.read_values import Reader, string

SCOPES = ("", "self", "below")


def lines(reader: Reader, node: Node, key: str, kind: str, culture: str = "") -> Iterator[Said]:
    """Take the texts of a property; each gives one sentence for each of its annotated axioms."""
    sleeping = []
    for literal in reader.facts.take_texts(node, key):
        if reader.axioms.asleep(node, key, literal):
            sleeping.append(literal)
            continue
        about = reader.axioms.take(node, key, literal)
        said = Said(type=kind, language="", text="", culture=culture)
        yield from _said(reader, node, literal, said, about)
    if sleeping:
        reader.facts.put(node, key, sleeping)


def inherited(reader: Reader, node: Node, restriction: Restriction, kind: str) -> Iterator[Said]:
    """Yield the sentences of a restriction of a class that was taken."""
    _, value = restriction
    if not isinstance(value, Text):
        reader.facts.wrong(node, "One of its sentences is not a text.", "Write a text.")
        return
    about = reader.axioms.take(node, "rdfs:subClassOf", restriction)
    yield from _said(reader, node, value, Said(type=kind, language="", text=""), about)


def _said(
    reader: Reader, node: Node, literal: Text, said: Said, about: list[Rows]
) -> Iterator[Said]:
    """Yield a sentence for each row of annotations; `said` has its type and culture."""
    language = reader.language(literal, node, "sentence")
    text = reader.checked(string(literal), node, "sentence", reader.limits.sentence)
    if not text.strip():
        reader.facts.wrong(node, "One of its sentences is empty.", "Write it or remove it.")
        return
    if language:
        for rows in about or [{}]:
            yield replace(said, language=language, text=text, **_annotated(reader, node, rows))


def _annotated(reader: Reader, node: Node, rows: Rows) -> dict[str, object]:
    if not rows:
        return {}
    scope = _word(reader, node, rows, "scope")
    if scope not in SCOPES:
        reader.facts.wrong(node, f"The scope {scope!r} is unknown.", "Write self or below.")
        scope = ""
    return {
        "id": _word(reader, node, rows, "id"),
        "frame": _word(reader, node, rows, "frame"),
        "order": reader.integer(rows.get("order", ()), node, "order", 0),
        "slot": reader.integer(rows.get("stateSlot", ()), node, "stateSlot", -1),
        "scope": scope,
        "activity": _word(reader, node, rows, "activity"),
        "goal": _goal(reader, node, rows),
        "only": reader.only(rows, node),
    }


def _word(reader: Reader, node: Node, rows: Rows, key: str) -> str:
    values = rows.get(key)
    return reader.word_of(values, node, key) if values else ""


def _goal(reader: Reader, node: Node, rows: Rows) -> str:
    keys = [
        reader.intents.get(value, "") if isinstance(value, int) else ""
        for value in rows.get("goalIntent", ())
    ]
    if len(keys) > 1 or not all(keys):
        hint = "Name one Intent of the file."
        reader.facts.wrong(node, "The goalIntent of a sentence is not in the file.", hint)
    return keys[0] if len(keys) == 1 else ""


def in_order(said: list[Said]) -> tuple[Said, ...]:
    """Return sentences by place, frame, type, language, culture and text."""
    return tuple(
        sorted(
            said,
            key=lambda row: (
                *(row.order or 1_000_000, row.frame, row.type, row.language),
                *(row.culture, row.text, row.id),
            ),
        )
    )
