"""Cultures, pools, phrases and value lists."""

from dialogue.engine.pools import POOLS
from ontology_io.owl.facts import Node
from ontology_io.owl.file_records import OwlCulture, Said
from ontology_io.owl.names import CULTURE, LANGUAGE, POOL, list_key, phrase_key
from ontology_io.owl.read_said import in_order, lines
from ontology_io.owl.read_values import Reader, words
from plans.engine.intents import Phrase, ValueList


def read_cultures(reader: Reader) -> tuple[OwlCulture, ...]:
    """Take the cultures and languages; note the code of each culture for the other parts."""
    facts = reader.facts
    languages = {}
    for node in facts.typed("Language"):
        reader.declared(node, "Language")
        languages[node] = reader.word(node, "hasCode") or _code(reader, node, LANGUAGE).lower()
    found: dict[str, OwlCulture] = {}
    for node in facts.typed("Culture"):
        reader.declared(node, "Culture")
        row = _culture(reader, node, languages)
        if row.code in found:
            facts.wrong(node, f"The culture {row.code!r} is there twice.", "Keep one of them.")
        found.setdefault(row.code, row)
        reader.cultures[node] = row.code
    return tuple(sorted(found.values(), key=lambda row: (row.order or 1_000_000, row.code)))


def _culture(reader: Reader, node: Node, languages: dict[Node, str]) -> OwlCulture:
    facts = reader.facts
    spoken = facts.take_nodes(node, "hasDefaultLanguage")
    if len(spoken) > 1 or any(one not in languages for one in spoken):
        facts.wrong(node, "Its hasDefaultLanguage is not one Language of the file.", "Correct it.")
    return OwlCulture(
        code=reader.word(node, "hasCode", 8) or _code(reader, node, CULTURE),
        names=reader.by_language(node, "rdfs:label", 200),
        language=languages.get(spoken[0], "") if spoken else "",
        order=reader.integer(facts.take(node, "order"), node, "order", 0),
    )


def _code(reader: Reader, node: Node, prefix: str) -> str:
    return reader.facts.name(node).removeprefix(prefix)


def read_pools(reader: Reader) -> dict[str, tuple[Said, ...]]:
    """Take the pools with their sentences, in order."""
    facts = reader.facts
    found: list[tuple[int, str, tuple[Said, ...]]] = []
    for node in facts.typed("Pool"):
        reader.declared(node, "Pool")
        code = reader.word(node, "hasCode", 60) or _code(reader, node, POOL).lower()
        order = reader.integer(facts.take(node, "order"), node, "order", 1_000_000)
        if code not in POOLS:
            facts.wrong(node, f"The pool {code!r} is unknown.", f"Known are {', '.join(POOLS)}.")
        elif any(code == row[1] for row in found):
            facts.wrong(node, f"The pool {code!r} is there twice.", "Put its lines together.")
        found.append((order, code, in_order(list(lines(reader, node, "hasLine", code)))))
    return {code: said for _, code, said in sorted(found, key=lambda row: row[:2])}


def read_phrases(reader: Reader) -> tuple[Phrase, ...]:
    """Take the named pieces of triggers, in order."""
    facts = reader.facts
    found = []
    for node in facts.typed("Phrase"):
        reader.declared(node, "Phrase")
        order = reader.integer(facts.take(node, "order"), node, "order", 1_000_000)
        key = phrase_key(facts.name(node))
        found.append((order, Phrase(key=key, texts=reader.by_language(node, "hasPattern"))))
    return tuple(row for _, row in sorted(found, key=lambda row: (row[0], row[1].key)))


def read_values(reader: Reader) -> tuple[ValueList, ...]:
    """Take the value lists with their canonical values, in order."""
    facts = reader.facts
    found = []
    for node in facts.typed("ValueList"):
        reader.declared(node, "ValueList")
        order = reader.integer(facts.take(node, "order"), node, "order", 1_000_000)
        found.append((order, ValueList(key=list_key(facts.name(node)), values=_list(reader, node))))
    return tuple(row for _, row in sorted(found, key=lambda row: (row[0], row[1].key)))


def _list(reader: Reader, node: Node) -> dict[str, dict[str, tuple[str, ...]]]:
    facts = reader.facts
    rows: list[tuple[str, int, str, tuple[str, ...]]] = []
    for value in facts.take_nodes(node, "hasValue"):
        if not facts.of_type(value, "CanonicalValue"):
            hint = "Declare it as a CanonicalValue, or remove the link."
            facts.wrong(node, f"Its value {facts.name(value)!r} is not in the file.", hint)
            continue
        reader.declared(value, "CanonicalValue")
        canonical = reader.word(value, "hasCode", 80)
        if not canonical:
            facts.wrong(value, "It has no hasCode.", "Write the value that it stands for.")
        for language, text, about in reader.ordered(value, "hasWords"):
            order = reader.integer(about.get("order", ()), value, "order", 1_000_000)
            rows.append((language, order, canonical, words(text)))
    found: dict[str, dict[str, tuple[str, ...]]] = {}
    for language, _, canonical, meant in sorted(rows):
        of_language = found.setdefault(language, {})
        of_language[canonical] = of_language.get(canonical, ()) + meant
    return found
