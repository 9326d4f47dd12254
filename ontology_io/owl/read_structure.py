"""Which classes are topics, and what lies above each: cycles, lost classes, several parents."""

from dialogue.engine.concepts import ROOT
from ontology_io.owl.facts import Node
from ontology_io.owl.names import TOPIC_NAME
from ontology_io.owl.read_values import Reader

#: What only a topic has: a class with one of these that is no topic is a slip.
_OF_TOPICS = ("id", "treeParent", "defaultKeyword1", "defaultKeyword2", "linkOrder", "homeCulture")


class Structure:
    """The topics of a file by node, with their named superclasses."""

    def __init__(self, reader: Reader) -> None:
        self.reader = reader
        self.keys: dict[Node, str] = {}
        self.parents: dict[Node, list[Node]] = {}
        facts = reader.facts
        self._above = {
            node: [v for v in rows["rdfs:subClassOf"] if isinstance(v, int) and v > 0]
            for node, rows in facts.nodes.items()
            if node > 0 and "rdfs:subClassOf" in rows and not facts.term(node)
        }
        self.roots = {node for node, term in facts.terms.items() if term == ROOT}
        self._reach()

    def check(self) -> None:
        """Note what is wrong with the hierarchy and with the names of topics."""
        self._check_names()
        self._check_cycles()
        self._check_lost()

    def key(self, node: Node) -> str:
        """Return the key of a topic, "Topic" for the root, "" for what is neither."""
        return ROOT if node in self.roots else self.keys.get(node, "")

    def tree_parent(self, node: Node) -> str:
        """Take the annotation that names the parent in the tree; check that there is just one."""
        facts = self.reader.facts
        named = facts.take_nodes(node, "treeParent")
        above = self.parents[node]
        if len(named) == 1 and self.key(named[0]) in {self.key(one) for one in above}:
            return self.key(named[0])
        others = [one for one in above if one not in self.roots]
        if named and len(others) < 2:
            # A class that was moved in an editor: its only superclass is the new parent.
            facts.warn(node, "Its treeParent is not one of its superclasses: it was left out.")
        if len(others) > 1:
            names = ", ".join(sorted(self.key(one) for one in others))
            hint = "Say by one treeParent which of them is above it in the Dialogue Tree."
            facts.wrong(node, f"It has several superclasses ({names}).", hint)
        elif others and len(above) > 1:
            text = f"It is below Topic and {self.key(others[0])}: the latter was taken as parent."
            facts.warn(node, text)
            self.parents[node] = others
        return ""

    def _reach(self) -> None:
        """Find all classes below Topic, level by level."""
        below: dict[Node, list[Node]] = {}
        for node, parents in self._above.items():
            for parent in parents:
                below.setdefault(parent, []).append(node)
        level, depth = sorted(self.roots), 0
        while level:
            depth += 1
            level = [n for parent in level for n in below.get(parent, ()) if self._new(n)]
            if depth == self.reader.limits.levels and level:
                text = f"It lies more than {depth} classes below Topic."
                self.reader.facts.wrong(level[0], text, "Flatten the hierarchy.")
        for node in self.keys:
            self.parents[node] = sorted(
                {n for n in self._above[node] if n in self.keys or n in self.roots}, key=self.key
            )

    def _new(self, node: Node) -> bool:
        if node in self.keys:
            return False
        self.keys[node] = self.reader.facts.name(node)
        return True

    def _check_names(self) -> None:
        facts = self.reader.facts
        seen: dict[str, Node] = {}
        for node, key in self.keys.items():
            if not TOPIC_NAME.fullmatch(key) or key == ROOT:
                hint = "Use letters and digits, beginning with a letter."
                facts.wrong(node, f"The topic name {key[:60]!r} cannot be used.", hint)
            if seen.setdefault(key, node) != node:
                facts.wrong(node, "There are two classes of this name.", "Rename one of them.")
            for parent in self._above[node]:
                if parent not in facts.nodes and not facts.term(parent):
                    self._missing(node, parent)

    def _missing(self, node: Node, parent: Node) -> None:
        facts = self.reader.facts
        text = f"Its superclass {facts.name(parent)!r} is not in the file."
        facts.wrong(node, text, "Declare it, or choose another superclass.")

    def _check_cycles(self) -> None:
        """Tell each cycle once; classes only leave this walk upwards when all above are done."""
        waiting = {n: {p for p in above if p in self._above} for n, above in self._above.items()}
        below: dict[Node, list[Node]] = {}
        for node, above in waiting.items():
            for parent in above:
                below.setdefault(parent, []).append(node)
        free = [node for node, above in waiting.items() if not above]
        while free:
            done = free.pop()
            del waiting[done]
            for node in below.get(done, ()):
                waiting[node].discard(done)
                if not waiting[node]:
                    free.append(node)
        self._tell_cycles(waiting)

    def _tell_cycles(self, waiting: dict[Node, set[Node]]) -> None:
        facts = self.reader.facts
        told: set[Node] = set()
        for start in sorted(waiting, key=facts.name):
            path: list[Node] = []
            node = start
            while node not in told:
                told.add(node)
                path.append(node)
                node = min(waiting[node], key=facts.name)
            if node in path:
                names = [facts.name(one) for one in path[path.index(node) :]][:20]
                shown = " → ".join([*names, names[0]])
                hint = "Remove one of these superclasses."
                facts.wrong(node, f"It lies below itself: {shown}.", hint)

    def _check_lost(self) -> None:
        """Tell of classes that look like topics but do not lie below Topic."""
        facts = self.reader.facts
        lost = [n for n in facts.typed("owl:Class") if n not in self.keys and not facts.term(n)]
        for node in lost:
            for parent in self._above.get(node, ()):
                if parent not in facts.nodes and not facts.term(parent):
                    self._missing(node, parent)
            if any(facts.see(node, key) for key in _OF_TOPICS) or self._has_individuals(node):
                hint = "Make it a subclass of Topic or of another topic."
                facts.wrong(node, "It does not lie below Topic.", hint)

    def _has_individuals(self, node: Node) -> bool:
        facts = self.reader.facts
        return any(facts.see(one, "hasCulture") for one in facts.instances(node))
