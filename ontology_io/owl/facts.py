"""All triples of a file, by subject and property; what is read is taken out, the rest remains."""

import sqlite3
from collections import defaultdict
from collections.abc import Callable, Iterable
from typing import NamedTuple

from ontology_io.owl.file_records import Problem
from ontology_io.owl.terms import names_of

#: The key of `""` among owlready2's datatypes: xsd:string, which is also what is untyped.
PLAIN = 60


class Text(NamedTuple):
    """A literal: its value as owlready2 gives it (NaN is None), "@en" or the datatype's key."""

    value: str | int | float | None
    kind: str | int


Node = int  # negative: a blank node
Value = Node | Text
Values = tuple[Value, ...]
Rows = dict[str, Values]


class Facts:
    """The triples; `nodes` is subject → property → values, where properties are short names.

    A property of the vocabulary is "hasName", of OWL "owl:hasValue", any other its whole IRI.
    """

    def __init__(self, iris: dict[Node, str]) -> None:
        self.iris = iris
        self.nodes: dict[Node, Rows] = {}
        self.terms: dict[Node, str] = {}
        self.problems: list[Problem] = []
        #: Blank nodes that only an axiom that was taken points to, or that were taken themselves.
        self.copies: set[Node] = set()
        self._locals: dict[Node, str] = {}
        self._types: dict[str | Node, set[Node]] = {}

    def term(self, node: Node) -> str:
        """Return the short name of a term ("Topic", "owl:Class"), or "" for any other node."""
        return self.terms.get(node, "")

    def term_of(self, value: Value) -> str:
        """Return the short name of a term, "" for other nodes and for literals."""
        return self.terms.get(value, "") if isinstance(value, int) else ""

    def key(self, node: Node) -> str:
        """Return the short name of a term, the IRI of any other node."""
        return self.terms.get(node) or self.iris.get(node, "")

    def name(self, node: Node) -> str:
        """Return the local name: after the last #, else / or :."""
        found = self._locals.get(node)
        if found is None:
            found = self._locals[node] = local_name(self.iris.get(node, ""))
        return found

    def take(self, node: Node, key: str) -> list[Value]:
        """Take all values of a property out."""
        rows = self.nodes.get(node)
        return list(rows.pop(key, ())) if rows else []

    def put(self, node: Node, key: str, values: Iterable[Value]) -> None:
        """Put values back that are not ours after all."""
        rows = self.nodes.setdefault(node, {})
        rows[key] = (*rows.get(key, ()), *values)

    def take_if(self, node: Node, key: str, wanted: Callable[[Value], bool]) -> list[Value]:
        """Take those values out that are wanted; the others stay."""
        values = self.take(node, key)
        if rest := [value for value in values if not wanted(value)]:
            self.put(node, key, rest)
            return [value for value in values if wanted(value)]
        return values

    def see(self, node: Node, key: str) -> Values:
        """Return the values of a property without taking them."""
        return self.nodes.get(node, {}).get(key, ())

    def take_nodes(self, node: Node, key: str) -> list[Node]:
        """Take the nodes out, in order of their names; literals stay."""
        found = self.take_if(node, key, lambda value: isinstance(value, int))
        nodes = [value for value in found if isinstance(value, int)]
        return sorted(nodes, key=self.name) if len(nodes) > 1 else nodes

    def take_texts(self, node: Node, key: str) -> list[Text]:
        """Take the literals out; nodes stay."""
        found = self.take_if(node, key, lambda value: isinstance(value, Text))
        return [value for value in found if isinstance(value, Text)]

    def typed(self, term: str) -> list[Node]:
        """Return the named nodes that are said to be of this term, by name."""
        return sorted(self._types.get(term, ()), key=self.name)

    def index_types(self) -> None:
        """Note the types of all named nodes; they stay known after they are taken."""
        for node, rows in self.nodes.items():
            if node > 0:
                for value in rows.get("rdf:type", ()):
                    if isinstance(value, int):
                        self._types.setdefault(self.term(value) or value, set()).add(node)

    def forget(self, node: Node) -> None:
        """Know no type of this node any more."""
        for nodes in self._types.values():
            nodes.discard(node)

    def of_type(self, node: Node, kind: str | Node) -> bool:
        """Say whether a named node is said to be of this term or class."""
        return node in self._types.get(kind, ())

    def instances(self, kind: Node) -> list[Node]:
        """Return the named nodes that are said to be of this class, by name."""
        return sorted(self._types.get(kind, ()), key=self.name)

    def wrong(self, where: Node | str, text: str, hint: str = "") -> None:
        """Note an error."""
        self._note(where, text, hint, error=True)

    def warn(self, where: Node | str, text: str, hint: str = "") -> None:
        """Note what was taken otherwise than it stands."""
        self._note(where, text, hint, error=False)

    def _note(self, where: Node | str, text: str, hint: str, *, error: bool) -> None:
        place = where if isinstance(where, str) else self.name(where) or "A nameless axiom"
        self.problems.append(Problem(where=place, text=text, hint=hint, error=error))


def local_name(iri: str) -> str:
    """Return what follows the last #, else the last /, else the last colon."""
    for mark in "#/:":
        if mark in iri:
            return iri.rsplit(mark, 1)[1]
    return iri


def load(database: sqlite3.Connection, graph: int) -> Facts:
    """Return the triples of one graph of owlready2's quadstore."""
    iris = dict(database.execute("SELECT storid, iri FROM resources"))
    facts = Facts(iris)
    facts.terms = names_of(iris)
    keys: dict[Node, str] = defaultdict(str, iris)
    keys.update(facts.terms)
    add = _adder(facts.nodes, keys)
    for s, p, o in database.execute("SELECT s, p, o FROM objs WHERE c = ?", (graph,)):
        add(s, p, o)
    make = tuple.__new__
    shared: dict[Text, Text] = {}
    for s, p, o, d in database.execute("SELECT s, p, o, d FROM datas WHERE c = ?", (graph,)):
        text = make(Text, (o, d))
        add(s, p, shared.setdefault(text, text))
    facts.index_types()
    return facts


def _adder(nodes: dict[Node, Rows], keys: dict[Node, str]) -> Callable[[Node, Node, Value], None]:
    """Return what adds a triple; equal values share one tuple, which halves the memory."""
    shared: dict[Values, Values] = {}

    def add(subject: Node, key: Node, value: Value) -> None:
        rows = nodes.get(subject)
        if rows is None:
            rows = nodes[subject] = {}
        name = keys[key]
        values = (*rows[name], value) if name in rows else (value,)
        rows[name] = shared.setdefault(values, values) if len(values) == 1 else values

    return add
