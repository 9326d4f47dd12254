"""The code blocks of docs/ontology.md, how they are run, and what the records say to the same."""

import io
import re
from collections import Counter
from collections.abc import Iterator
from contextlib import redirect_stdout
from decimal import Decimal

import owlready2
import rdflib

from dialogue.engine.concepts import Frame, Topic
from dialogue.engine.sentence_types import SENTENCE_TYPES
from ontology_io.records import KnowledgeBase
from tests.ontology.ontology_page import PAGE

TEXT = PAGE.read_text(encoding="utf-8")
BLOCKS = re.compile(r"^```(python|sparql) (\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
CODE = {(kind, name): block for kind, name, block in BLOCKS.findall(TEXT)}
PREFIXES = re.findall(r"^```sparql\n(.*?)^```$", TEXT, re.MULTILINE | re.DOTALL)
QUERIES = sorted(name for kind, name in CODE if kind == "sparql")
Row = tuple[object, ...]


def run(code: str, names: dict[str, object]) -> str:
    """Run code of the page; return what it prints."""
    out = io.StringIO()
    with redirect_stdout(out):
        exec(code, names)  # noqa: S102 - the page is ours
    return out.getvalue()


def plain(value: object) -> object:
    """Return a value of either library as Python has it; what has an IRI by its local name."""
    if isinstance(value, rdflib.Literal):
        value = value.toPython()
    if isinstance(value, Decimal):
        return float(value)
    iri = str(value) if isinstance(value, rdflib.URIRef) else getattr(value, "iri", "")
    if iri:
        return iri.rpartition("#")[2]
    return str(value) if isinstance(value, str) else value


def by_rdflib(graph: rdflib.Graph, name: str) -> list[Row]:
    """Return the answers of a query of the page."""
    rows = graph.query(PREFIXES[0] + CODE["sparql", name])
    return [tuple(plain(value) for value in row) for row in rows]  # type: ignore[union-attr]


def by_owlready2(world: owlready2.World, name: str) -> list[Row]:
    """Return the answers of a query of the page."""
    rows = world.sparql(PREFIXES[0] + CODE["sparql", name])
    return [tuple(plain(value) for value in row) for row in rows]


class Facts:
    """What the records say, asked as the page asks the ontology."""

    def __init__(self, base: KnowledgeBase) -> None:
        self.base = base
        self.topics = {topic.key: topic for topic in base.knowledge.topics}
        self.parents = {topic.is_a for topic in base.knowledge.topics}

    def on_class(self, frame: Frame, topic: Topic) -> bool:
        inherited = topic.key in self.parents and frame.scope != "self"
        return inherited or not frame.only

    def frames(self) -> Iterator[tuple[Topic, Frame]]:
        return ((topic, frame) for topic in self.topics.values() for frame in topic.frames)

    def line(self, key: str) -> Iterator[Topic]:
        while key in self.topics:
            yield self.topics[key]
            key = self.topics[key].is_a

    def by_likeliness(self) -> list[Row]:
        values = [(one.key, one.likeliness["JP"]) for one in self.topics.values()]
        return [(key, value) for key, value in values if value > 0.8]

    def hardly_liked(self) -> list[Row]:
        return [(key,) for key, one in self.topics.items() if one.likeliness["IN"] <= 0.1]

    def inherited(self) -> list[Row]:
        return [
            (topic.key, SENTENCE_TYPES[frame.type].owl_property, frame.texts["en"])
            for topic in self.line("GreenTea")
            for frame in topic.frames
            if self.on_class(frame, topic)
        ]

    def of_one_culture(self) -> list[Row]:
        return [
            (topic.key, frame.texts["en"])
            for topic, frame in self.frames()
            if "JP" in frame.only and not self.on_class(frame, topic)
        ]

    def most_linked(self) -> list[int]:
        links = Counter(key for one in self.topics.values() for key in one.see)
        return [count for _, count in links.most_common(10)]

    def coverage(self) -> list[Row]:
        frames = [frame for _, frame in self.frames()]
        frames += [frame for pool in self.base.knowledge.pools.values() for frame in pool]
        return list(Counter(code for frame in frames for code in frame.texts).items())

    def offers(self) -> list[Row]:
        return [
            (topic.key, frame.texts["it"])
            for topic, frame in self.frames()
            if frame.do.split()[:1] == ["playsong"] and self.on_class(frame, topic)
        ]

    def plans(self) -> list[Row]:
        return [
            (f"INTENT_{one.key}", item.action)
            for one in self.base.library.intents
            for item in one.plan
        ]
