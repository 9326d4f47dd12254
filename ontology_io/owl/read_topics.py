"""Topics: each class below Topic with what is inherited from it."""

from ontology_io.owl.axioms import Restriction
from ontology_io.owl.facts import Node, Text, Value
from ontology_io.owl.file_records import OwlTopic, Said
from ontology_io.owl.names import VARIABLE_NAME
from ontology_io.owl.read_individuals import Individuals
from ontology_io.owl.read_keywords import keywords
from ontology_io.owl.read_said import in_order, inherited
from ontology_io.owl.read_structure import Structure
from ontology_io.owl.read_values import Reader, string
from ontology_io.owl.vocabulary import NAME_FORMS, SENTENCES

_NAMES = {"name": "rdfs:label", **NAME_FORMS}
_KEYWORDS = ("defaultKeyword1", "defaultKeyword2")
_SHORT = 120
_VARIABLE_KIN = ("hasName", "hasNameWithArticle", "hasChunk")


def read_topics(reader: Reader, structure: Structure) -> tuple[OwlTopic, ...]:
    """Take all topics with their individuals, by key."""
    patterns = _patterns(reader)
    variables = _variables(reader)
    individuals = Individuals(reader, structure)
    nodes = sorted(structure.keys, key=lambda node: structure.keys[node])
    found = [_Topic(reader, structure, node, patterns, variables) for node in nodes]
    rows = tuple(topic.row(individuals) for topic in found)
    _forget(reader, variables, {name for topic in found for name in topic.used})
    return rows


def _patterns(reader: Reader) -> dict[Node, str]:
    """Return the sequences; the individuals are taken by the topics that use them."""
    facts = reader.facts
    return {
        node: "\n".join(string(v) for v in facts.see(node, "hasSequence") if isinstance(v, Text))
        for node in facts.typed("DialoguePattern")
    }


def _variables(reader: Reader) -> dict[str, Node]:
    """Return the properties below hasChunk by their key (an IRI)."""
    facts = reader.facts
    return {
        facts.key(node): node
        for node in facts.typed("owl:DatatypeProperty")
        if any(facts.term_of(v) == "hasChunk" for v in facts.see(node, "rdfs:subPropertyOf"))
        and facts.term(node) not in _VARIABLE_KIN
    }


def _forget(reader: Reader, variables: dict[str, Node], used: set[str]) -> None:
    """Take the declarations of the variables that topics have."""
    facts = reader.facts
    for key in sorted(used):
        node = variables[key]
        facts.take(node, "rdf:type")
        facts.take_if(node, "rdfs:subPropertyOf", lambda v: facts.term_of(v) == "hasChunk")
        if not VARIABLE_NAME.fullmatch(facts.name(node)):
            hint = "Use small letters and _."
            facts.wrong(node, "This name of a variable cannot be used.", hint)


class _Topic:
    """One class while it is read."""

    def __init__(
        self,
        reader: Reader,
        structure: Structure,
        node: Node,
        patterns: dict[Node, str],
        variables: dict[str, Node],
    ) -> None:
        self._reader, self._structure, self._node = reader, structure, node
        self._patterns, self._known = patterns, variables
        self._said: list[Said] = []
        self._sequences: set[str] = set()
        self._texts: list[tuple[str, int, str, str]] = []
        #: Keys of the variables it has.
        self.used: set[str] = set()

    def row(self, individuals: Individuals) -> OwlTopic:
        """Take everything that is said about it."""
        reader, facts, node = self._reader, self._reader.facts, self._node
        self._declared()
        tree_parent = self._structure.tree_parent(node)
        self._above()
        rows, own = individuals.of(node)
        return OwlTopic(
            key=self._structure.keys[node],
            parents=tuple(self._structure.key(one) for one in self._structure.parents[node]),
            id=reader.word(node, "id"),
            tree_parent=tree_parent,
            order=reader.integer(facts.take(node, "order"), node, "order", 0),
            names=self._names(),
            keywords=keywords(reader, node, _KEYWORDS),
            variables=self._variables(),
            gentle=reader.flag(node, "gentle"),
            stop=reader.word(node, "inheritsNo", 20),
            home=self._home(),
            pattern=self._pattern(),
            note=reader.note(node),
            link_order=tuple(reader.word(node, "linkOrder", 10_000).split()),
            said=in_order(self._said + own),
            individuals=rows,
        )

    def _declared(self) -> None:
        facts, node = self._reader.facts, self._node
        facts.take_if(node, "rdf:type", lambda value: facts.term_of(value) == "owl:Class")
        if facts.see(node, "rdf:type"):
            hint = "Give the individual another name."
            facts.wrong(node, "It is a class and an individual.", hint)

    def _above(self) -> None:
        """Take the superclasses: named ones, and the restrictions that the vocabulary knows."""
        facts, node = self._reader.facts, self._node
        rest: list[Value] = []
        seen: dict[Restriction, None] = {}
        for value in facts.take(node, "rdfs:subClassOf"):
            if isinstance(value, int) and value > 0 and self._structure.key(value):
                continue
            restriction = self._known_restriction(value)
            if restriction is None:
                rest.append(value)
            else:
                seen[restriction] = None
        for restriction in seen:
            self._restriction(restriction)
        if rest:
            facts.put(node, "rdfs:subClassOf", rest)

    def _known_restriction(self, value: Value) -> Restriction | None:
        if not isinstance(value, int) or value > 0:
            return None
        found = self._reader.axioms.restriction(value)
        if found is None or not (
            found[0] in SENTENCES or found[0] in self._known or found[0] == "usesPattern"
        ):
            return None
        if self._reader.axioms.asleep(self._node, "rdfs:subClassOf", found):
            return None
        self._reader.facts.copies.add(value)
        return found

    def _restriction(self, restriction: Restriction) -> None:
        key, value = restriction
        if key in SENTENCES:
            self._said += inherited(self._reader, self._node, restriction, SENTENCES[key])
        elif key == "usesPattern":
            self._uses(value)
        else:
            self._variable(restriction)

    def _uses(self, value: Value) -> None:
        facts = self._reader.facts
        if not isinstance(value, int) or value not in self._patterns:
            text = "The value of its usesPattern is no DialoguePattern of the file."
            facts.wrong(self._node, text, "Declare it, or choose another.")
            return
        self._sequences.add(self._patterns[value])
        if value not in self._reader.parts:
            self._reader.parts.add(value)
            self._reader.declared(value, "DialoguePattern")
            self._reader.word(value, "hasSequence", 500)

    def _pattern(self) -> str:
        if len(self._sequences) > 1:
            self._reader.facts.wrong(self._node, "It uses several patterns.", "Keep one.")
        return min(self._sequences, default="")

    def _variable(self, restriction: Restriction) -> None:
        key, value = restriction
        reader, node = self._reader, self._node
        about = reader.axioms.take(node, "rdfs:subClassOf", restriction)
        self.used.add(key)
        name = reader.facts.name(self._known[key])
        if not isinstance(value, Text):
            reader.facts.wrong(node, f"Its {name} is not a text.", "Write a text.")
            return
        language = reader.language(value, node, name)
        text = reader.checked(string(value), node, name, _SHORT)
        order = reader.integer(about[0].get("order", ()) if about else (), node, "order", 1_000_000)
        if language:
            self._texts.append((language, order, name, text))

    def _variables(self) -> dict[str, dict[str, str]]:
        found: dict[str, dict[str, str]] = {}
        for language, _, name, text in sorted(self._texts):
            if found.setdefault(language, {}).setdefault(name, text) != text:
                hint = "Keep one of them."
                self._reader.facts.wrong(self._node, f"It has two {name} in {language!r}.", hint)
        return found

    def _names(self) -> dict[str, dict[str, str]]:
        found: dict[str, dict[str, str]] = {}
        for field, key in _NAMES.items():
            for language, text in self._reader.by_language(self._node, key, _SHORT).items():
                found.setdefault(language, {})[field] = text
        return found

    def _home(self) -> str:
        reader, node = self._reader, self._node
        nodes = reader.facts.take_nodes(node, "homeCulture")
        codes = {reader.cultures.get(one, "") for one in nodes}
        if "" in codes or len(codes) > 1:
            hint = "Name one Culture of the file."
            reader.facts.wrong(node, "Its homeCulture is not a culture of the file.", hint)
        return max(codes, default="")
