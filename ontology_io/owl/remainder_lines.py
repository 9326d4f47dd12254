"""What the vocabulary does not know, as sorted N-Triples that do not depend on the file's order."""

import hashlib
import re
from collections import Counter, defaultdict
from collections.abc import Iterator
from typing import TypeGuard

from ontology_io.owl.facts import Facts, Node, Text, Value
from ontology_io.owl.terms import PREFIXES, long, ours
from ontology_io.owl.vocabulary import XSD

_NAMED = 16
_ELEMENT = re.compile(r"[A-Za-z_][A-Za-z0-9_.-]*\Z")
_PARTS = frozenset(
    {"rdf:first", "rdf:rest", "rdf:type", "owl:onProperty", "owl:annotatedSource"}
    | {"owl:annotatedProperty", "owl:annotatedTarget", "owl:members", "owl:onDatatype"}
)


class Remainder:
    """The triples that are left in the facts; `space` is the namespace its content gets."""

    def __init__(self, facts: Facts, iri: str, space: str) -> None:
        self._facts = facts
        self._iri = iri
        self._space = space
        self._left = self._reachable()
        self._names: dict[Node, str] = {}
        self._name_blanks()

    def text(self) -> str:
        """Return the lines, each with its line feed; "" where nothing is left."""
        return "".join(sorted({f"{line}\n" for line in self._lines()}))

    def unwritable(self) -> list[str]:
        """Return the properties whose IRI has no end that can be an element's name."""
        keys = {key for node in self._left for key in self._facts.nodes[node]}
        return sorted(key for key in keys if not _ELEMENT.search(long(key)))

    def counted(self) -> dict[str, int]:
        """Return how often each unknown property or kind of axiom occurs, by name."""
        counts: Counter[str] = Counter()
        spoken_of = self._spoken_of()
        for node in self._left:
            rows = self._facts.nodes[node]
            if node < 0 and "owl:onProperty" in rows:
                if node not in spoken_of:
                    kinds = [key for key in rows if key not in _PARTS]
                    counts[f"owl:Restriction {', '.join(kinds).replace('owl:', '')}"] += 1
                continue
            for key in rows.keys() - _PARTS:
                counts[self._shown(key)] += sum(not _class_below(key, v) for v in rows[key])
            if node > 0:
                counts.update(f"a {self._type(value)}" for value in rows.get("rdf:type", ()))
        return {name: count for name, count in sorted(counts.items()) if count}

    def _spoken_of(self) -> set[Node]:
        """Return the blank nodes that are left only for what is said about an axiom."""
        pointing: dict[Node, set[str]] = defaultdict(set)
        for node in self._left:
            for key, values in self._facts.nodes[node].items():
                for value in values:
                    if _blank(value):
                        pointing[value].add(key)
        return {node for node, keys in pointing.items() if keys == {"owl:annotatedTarget"}}

    def _type(self, value: Value) -> str:
        if not isinstance(value, int) or value < 0:
            return "nameless class"
        return self._shown(self._facts.key(value))

    def _shown(self, key: str) -> str:
        if ours(key) or key.startswith(tuple(PREFIXES)):
            return key
        return key.rsplit("#", 1)[-1].rsplit("/", 1)[-1] or key

    def _reachable(self) -> list[Node]:
        """Return the subjects left: all but what was taken, and what those still point to."""
        facts = self._facts
        pointed = self._below_copies()
        found = dict.fromkeys(n for n, rows in facts.nodes.items() if rows and n not in pointed)
        waiting = list(found)
        while waiting:
            for values in facts.nodes[waiting.pop()].values():
                for value in values:
                    if _blank(value) and value not in found and facts.nodes.get(value):
                        found[value] = None
                        waiting.append(value)
        return list(found)

    def _below_copies(self) -> set[Node]:
        """Return the blank nodes that were taken, with those below them."""
        found = set(self._facts.copies)
        waiting = list(found)
        while waiting:
            for values in self._facts.nodes.get(waiting.pop(), {}).values():
                for value in values:
                    if isinstance(value, int) and value < 0 and value not in found:
                        found.add(value)
                        waiting.append(value)
        return found

    def _lines(self) -> Iterator[str]:
        for node in self._left:
            subject = self._node(node)
            for key, values in self._facts.nodes[node].items():
                for value in values:
                    yield f"{subject} <{escaped(self._space_of(long(key)))}> {self._value(value)} ."

    def _node(self, node: Node) -> str:
        if node < 0:
            return f"_:b{self._names[node]}"
        return f"<{escaped(self._space_of(long(self._facts.key(node))))}>"

    def _space_of(self, iri: str) -> str:
        """Return an IRI of the file's own namespace as one of ours."""
        if self._iri and iri.startswith(self._iri):
            rest = iri[len(self._iri) :]
            if rest[:1] in ("#", "/"):
                return self._space + rest[1:]
            if not rest:
                return self._space.rstrip("#/")
        return iri

    def _value(self, value: Value) -> str:
        if isinstance(value, int):
            return self._node(value)
        text = f'"{escaped(_lexical(value))}"'
        if isinstance(value.kind, str):
            return text + (value.kind if value.kind != "@" else "")
        datatype = self._facts.iris.get(value.kind, "")
        return text if datatype in ("", f"{XSD}string") else f"{text}^^<{escaped(datatype)}>"

    def _name_blanks(self) -> None:
        """Name blank nodes by all they say and by what is said of them.

        Two that cannot be told apart by that get one name: they say the same.
        """
        pointing: dict[Node, list[tuple[Node, str]]] = defaultdict(list)
        for node in self._left:
            for key, values in self._facts.nodes[node].items():
                for value in values:
                    if _blank(value):
                        pointing[value].append((node, key))
        blanks = [*(node for node in self._left if node < 0), *pointing]
        below: dict[Node, str] = {}
        for node in self._bottom_up(blanks):
            below[node] = self._digest(self._said(node, below))
        for node in reversed(self._bottom_up(blanks)):
            above = sorted(
                f"{key} {self._names.get(source, 'cycle') if source < 0 else self._node(source)}"
                for source, key in pointing[node]
            )
            self._names[node] = self._digest([below[node], *above])

    def _said(self, node: Node, below: dict[Node, str]) -> list[str]:
        return sorted(
            f"{key} {below.get(value, '') if _blank(value) else self._value(value)}"
            for key, values in self._facts.nodes.get(node, {}).items()
            for value in values
        )

    def _bottom_up(self, blanks: list[Node]) -> list[Node]:
        """Return the blank nodes so that each stands after those it points to (but in cycles)."""
        done: dict[Node, None] = {}
        opened: set[Node] = set()
        for start in blanks:
            waiting = [start]
            while waiting:
                node = waiting[-1]
                if node in opened:
                    waiting.pop()
                    done[node] = None
                    continue
                opened.add(node)
                waiting += [
                    value
                    for values in self._facts.nodes.get(node, {}).values()
                    for value in values
                    if isinstance(value, int) and value < 0 and value not in opened
                ]
        return list(done)

    @staticmethod
    def _digest(parts: list[str]) -> str:
        return hashlib.sha256("\n".join(parts).encode()).hexdigest()[:_NAMED]


def _blank(value: Value) -> TypeGuard[Node]:
    return isinstance(value, int) and value < 0


def _class_below(key: str, value: Value) -> bool:
    """Say whether this only leads to a nameless class, which is counted itself."""
    return key == "rdfs:subClassOf" and _blank(value)


def _lexical(value: Text) -> str:
    found = value.value
    if found is None:
        return "NaN"
    if isinstance(found, float):
        if found in (float("inf"), float("-inf")):
            return "INF" if found > 0 else "-INF"
        text = f"{found:.15f}".rstrip("0")
        return f"{text}0" if text.endswith(".") else text
    return str(found)


def escaped(text: str) -> str:
    """Return a text as N-Triples write it."""
    for mark, shown in (("\\", "\\\\"), ('"', '\\"'), ("\n", "\\n"), ("\r", "\\r"), ("\t", "\\t")):
        text = text.replace(mark, shown)
    return text
