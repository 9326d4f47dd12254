"""Languages, cultures, pools, phrases and value lists."""

from collections.abc import Iterable, Iterator, Mapping

from dialogue.engine.concepts import Culture, Frame
from languages.known import LANGUAGES
from ontology_io.owl import xml_writer as xml
from ontology_io.owl.names import culture_name, language_name, list_name, phrase_name, pool_name
from ontology_io.owl.vocabulary import VOCABULARY
from ontology_io.owl.write_said import Context, annotations, assertion, kept_for
from plans.engine.intents import Phrase, ValueList


def cultures(rows: Iterable[Culture], context: Context) -> Iterator[str]:
    """Yield the languages, then the cultures in order."""
    rows = tuple(rows)
    for code in sorted({*LANGUAGES, *(row.language for row in rows if row.language)}):
        yield xml.individual(
            context.iri(language_name(code)),
            f"{VOCABULARY}Language",
            xml.text("cair:hasCode", code),
        )
    for place, row in enumerate(rows, start=1):
        spoken = context.iri(language_name(row.language))
        yield xml.individual(
            context.iri(culture_name(row.code)),
            f"{VOCABULARY}Culture",
            xml.text("cair:hasCode", row.code),
            xml.resource("cair:hasDefaultLanguage", spoken) if row.language else "",
            *(xml.text("rdfs:label", row.names[code], code) for code in sorted(row.names)),
            xml.integer("cair:order", place),
        )


def pools(rows: Mapping[str, Iterable[Frame]], context: Context) -> Iterator[str]:
    """Yield the pools in order, each with its lines."""
    for place, (code, frames) in enumerate(rows.items(), start=1):
        source = context.iri(pool_name(code))
        parts = list(_lines(frames, source, context))
        yield xml.individual(
            source,
            f"{VOCABULARY}Pool",
            xml.text("cair:hasCode", code),
            xml.integer("cair:order", place),
            *dict.fromkeys(line for line, _ in parts),
        ) + "".join(rest for _, rest in parts)


def _lines(frames: Iterable[Frame], source: str, context: Context) -> Iterator[tuple[str, str]]:
    for place, frame in enumerate(frames, start=1):
        kept = [kept_for(code, context) for code in context.ordered(frame.only)]
        for language in sorted(frame.texts):
            notes = [*annotations(frame, place, language, context), *kept]
            yield assertion("hasLine", frame, language, source, notes)


def phrases(rows: Iterable[Phrase], context: Context) -> Iterator[str]:
    """Yield the phrases in order."""
    for place, row in enumerate(rows, start=1):
        yield xml.individual(
            context.iri(phrase_name(row.key)),
            f"{VOCABULARY}Phrase",
            *(xml.text("cair:hasPattern", row.texts[code], code) for code in sorted(row.texts)),
            xml.integer("cair:order", place),
        )


def value_lists(rows: Iterable[ValueList], context: Context) -> Iterator[str]:
    """Yield the value lists in order, each followed by its canonical values."""
    for place, row in enumerate(rows, start=1):
        values = dict.fromkeys(value for words in row.values.values() for value in words)
        names = [context.iri(context.names.value(row.key, value)) for value in values]
        yield xml.individual(
            context.iri(list_name(row.key)),
            f"{VOCABULARY}ValueList",
            xml.integer("cair:order", place),
            *(xml.resource("cair:hasValue", name) for name in names),
        )
        for name, value in zip(names, values, strict=True):
            yield _value(row, value, name)


def _value(row: ValueList, value: str, source: str) -> str:
    lines, rest = [], []
    for code in sorted(row.values):
        places = {each: place for place, each in enumerate(row.values[code], start=1)}
        if value in places:
            words = "|".join(row.values[code][value])
            order = xml.integer("cair:order", places[value])
            target = xml.literal_target(words, code)
            lines.append(xml.text("cair:hasWords", words, code))
            rest.append(xml.axiom(source, f"{VOCABULARY}hasWords", target, order))
    code_line = xml.text("cair:hasCode", value)
    return xml.individual(source, f"{VOCABULARY}CanonicalValue", code_line, *lines) + "".join(rest)
