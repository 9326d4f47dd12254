"""What is annotated: the owl:Axiom nodes by the triple they speak of, found by its content."""

from collections import defaultdict

from ontology_io.owl.facts import Facts, Node, Rows, Text, Value
from ontology_io.owl.vocabulary import SENTENCES

#: What one of ours says about an axiom.
_OURS = frozenset(
    {"id", "frame", "order", "stateSlot", "scope", "activity", "goalIntent", "onlyCulture"}
    | {"active", "expects"}
)
_FRAME = frozenset(
    {"rdf:type", "owl:annotatedSource", "owl:annotatedProperty", "owl:annotatedTarget"}
)
_TEXTS = frozenset({*SENTENCES, "hasLine", "hasTrigger", "hasPlanSentence", "hasTest", "hasWords"})
#: A restriction to one value: its property and the value.
Restriction = tuple[str, Value]
Target = Value | Restriction


class Axioms:
    """Annotations by (subject, property, object); a restriction is known by its content."""

    def __init__(self, facts: Facts) -> None:
        self._facts = facts
        self._nodes: dict[tuple[Node, str, Target], list[Node]] = defaultdict(list)
        for node, rows in facts.nodes.items():
            if "owl:annotatedSource" in rows:
                self._index(node, rows)

    def restriction(self, node: Node) -> Restriction | None:
        """Return the property and value of a blank node that is such a restriction."""
        rows = self._facts.nodes.get(node, {})
        if len(rows) != 3 or "owl:hasValue" not in rows or "owl:onProperty" not in rows:
            return None
        property_, value = rows["owl:onProperty"], rows["owl:hasValue"]
        if len(property_) != 1 or len(value) != 1 or not isinstance(property_[0], int):
            return None
        return self._facts.key(property_[0]), value[0]

    def take(self, source: Node, key: str, target: Target) -> list[Rows]:
        """Take what is said about a triple: a row of annotations for each axiom with one of ours.

        An axiom that is not active is left as it is, and gives no row; so is what else is said.
        """
        found = []
        for node in self._nodes.pop((source, key, target), ()):
            if self._sleeps(node):
                continue
            rows = self._facts.nodes[node]
            ours = {name: rows.pop(name) for name in tuple(rows) if name in _OURS}
            if ours:
                found.append(ours)
            if rows.keys() <= _FRAME:
                self._drop(node)
        return found

    def asleep(self, source: Node, key: str, target: Target) -> bool:
        """Say whether a triple is annotated, and only as one that is kept but not said."""
        nodes = self._nodes.get((source, key, target), ())
        return bool(nodes) and all(self._sleeps(node) for node in nodes)

    def without_triple(self) -> list[Node]:
        """Take what is left of ours about sentences that the file lacks; return their subjects."""
        found = []
        for (source, key, target), nodes in self._nodes.items():
            if not (key in _TEXTS or (isinstance(target, tuple) and target[0] in SENTENCES)):
                continue
            for node in nodes:
                rows = self._facts.nodes.get(node, {})
                if not self._sleeps(node) and _OURS & rows.keys():
                    found.append(source)
                    self._clear(node, rows)
        return found

    def _clear(self, node: Node, rows: Rows) -> None:
        for name in _OURS:
            rows.pop(name, None)
        if rows.keys() <= _FRAME:
            self._drop(node)

    def _index(self, node: Node, rows: Rows) -> None:
        parts = [rows.get(f"owl:annotated{part}", ()) for part in ("Source", "Property", "Target")]
        if any(len(values) != 1 for values in parts):
            return
        source, property_, target = (values[0] for values in parts)
        if not isinstance(source, int) or not isinstance(property_, int):
            return
        known: Target | None = target
        if isinstance(target, int) and target < 0:
            known = self.restriction(target)
        if known is not None:
            self._nodes[source, self._facts.key(property_), known].append(node)

    def _sleeps(self, node: Node) -> bool:
        values = self._facts.see(node, "active")
        return any(isinstance(value, Text) and value.value in ("false", "0", 0) for value in values)

    def _drop(self, node: Node) -> None:
        rows = self._facts.nodes.pop(node)
        target = rows.get("owl:annotatedTarget", (0,))[0]
        if isinstance(target, int) and target < 0:
            self._facts.copies.add(target)
