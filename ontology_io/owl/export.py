"""A knowledge base as OWL 2 DL in RDF/XML, piece by piece; the same one gives the same bytes."""

from collections.abc import Iterable, Iterator, Mapping
from itertools import chain

from ontology_io.owl import xml_writer as xml
from ontology_io.owl.line import in_line
from ontology_io.owl.write_intents import intents
from ontology_io.owl.write_lists import cultures, phrases, pools, value_lists
from ontology_io.owl.write_remainder import remainder_elements
from ontology_io.owl.write_said import Context
from ontology_io.owl.write_topics import patterns, topics, variables
from ontology_io.owl.write_vocabulary import head, vocabulary
from ontology_io.records import KnowledgeBase

CHUNK = 32_768


def owl_bytes(
    base: KnowledgeBase, *, iri: str, version: str, highest: Mapping[str, int], remainder: str = ""
) -> Iterator[bytes]:
    """Yield the file in chunks of some tens of kilobytes.

    `iri` names the ontology, its contents are `iri#Name`; `version` is "draft" or "release 12";
    `highest` are the highest numbers ever given by kind ("topic", "frame", "intent"); `remainder`
    are N-Triples that an import kept because the vocabulary does not know them.
    Raises RemainderError at the call, UnwritableError in the chunk where a text holds what XML
    cannot.
    """
    ontology = head(xml.attribute(iri), version, highest)
    return _chunks(_pieces(base, iri, ontology, tuple(remainder_elements(remainder))))


def _pieces(base: KnowledgeBase, iri: str, ontology: str, further: Iterable[str]) -> Iterator[str]:
    context = Context(base, iri)
    knowledge, library = base.knowledge, base.library
    yield xml.opening(xml.attribute(iri))
    yield ontology
    yield from vocabulary()
    yield from _section("Languages and cultures", cultures(knowledge.cultures, context))
    yield from _section("Orders of sentences", patterns(knowledge.topics, context))
    yield from _section("Class variables", variables(knowledge.topics, context))
    yield from _section("Topics and their individuals", topics(in_line(knowledge.topics), context))
    yield from _section("Pools", pools(knowledge.pools, context))
    yield from _section("Intents and plans", intents(library.intents, context))
    lists = chain(phrases(library.phrases, context), value_lists(library.values, context))
    yield from _section("Phrases and value lists", lists)
    yield from _section("Further axioms", further)
    yield xml.CLOSING


def _section(title: str, pieces: Iterable[str]) -> Iterator[str]:
    """Yield the pieces below a comment; nothing where there are none."""
    for place, piece in enumerate(pieces):
        if not place:
            yield f"\n<!-- {title} -->\n"
        yield piece


def _chunks(pieces: Iterable[str]) -> Iterator[bytes]:
    waiting: list[str] = []
    size = 0
    for piece in pieces:
        waiting.append(piece)
        size += len(piece)
        if size >= CHUNK:
            yield "".join(waiting).encode()
            waiting, size = [], 0
    if waiting:
        yield "".join(waiting).encode()
