"""Individuals of the CS-ABox: culture, likeliness, links, own names, keywords and sentences."""

from ontology_io.owl.facts import Node, Text, Value
from ontology_io.owl.file_records import Individual, Said
from ontology_io.owl.read_keywords import keywords
from ontology_io.owl.read_said import lines
from ontology_io.owl.read_structure import Structure
from ontology_io.owl.read_values import Reader
from ontology_io.owl.vocabulary import SENTENCES, XSD

_KEYWORDS = ("hasKeyword1", "hasKeyword2")
_NAMES = ("hasName", "hasNameWithArticle")
_EXACT = (f"{XSD}decimal", f"{XSD}integer")


class Individuals:
    """The individuals of all topics; each is taken with its topic."""

    def __init__(self, reader: Reader, structure: Structure) -> None:
        self._reader = reader
        self._structure = structure
        facts = reader.facts
        self._topics: dict[Node, Node] = {}
        for topic in sorted(structure.keys, key=lambda node: structure.keys[node]):
            for node in facts.instances(topic):
                if node in self._topics:
                    hint = "Keep one of the types: make an individual for each topic."
                    facts.wrong(node, "It is an individual of two topics.", hint)
                self._topics.setdefault(node, topic)
        self._cultures = {node: self._culture(node) for node in self._topics}

    def of(self, topic: Node) -> tuple[tuple[Individual, ...], list[Said]]:
        """Take the individuals of a topic, by culture, and what they say."""
        facts = self._reader.facts
        rows: dict[str, Individual] = {}
        said: list[Said] = []
        for node in facts.instances(topic):
            if self._topics.get(node) != topic or node in self._structure.keys:
                continue
            row = self._individual(node)
            if row.culture and row.culture in rows:
                text = f"{rows[row.culture].name} is of the same topic and culture."
                facts.wrong(node, text, "Keep one of them.")
            rows.setdefault(row.culture, row)
            for key, letter in SENTENCES.items():
                said += lines(self._reader, node, key, letter, row.culture)
        rows.pop("", None)
        return tuple(rows[culture] for culture in sorted(rows)), said

    def _culture(self, node: Node) -> str:
        facts = self._reader.facts
        cultures = facts.take_nodes(node, "hasCulture")
        if not cultures:
            facts.wrong(node, "It has no hasCulture.", "Name the culture it belongs to.")
            return ""
        if len(cultures) > 1:
            facts.wrong(node, "It has more than one hasCulture.", "Keep one.")
        code = self._reader.cultures.get(cultures[0], "")
        if not code:
            text = f"Its culture {facts.name(cultures[0])!r} is not in the file."
            facts.wrong(node, text, "Declare it as a Culture, or choose another.")
        return code

    def _individual(self, node: Node) -> Individual:
        reader, facts = self._reader, self._reader.facts
        types = ("owl:NamedIndividual", "Topic")
        facts.take_if(node, "rdf:type", lambda value: self._known_type(value, types))
        reader.declared(node, "Topic")
        return Individual(
            name=facts.name(node),
            culture=self._cultures[node],
            id=reader.word(node, "id"),
            likeliness=self._likeliness(node),
            links=self._links(node),
            names={key: texts for key in _NAMES if (texts := reader.by_language(node, key, 120))},
            keywords=keywords(reader, node, _KEYWORDS),
        )

    def _known_type(self, value: Value, terms: tuple[str, ...]) -> bool:
        if not isinstance(value, int):
            return False
        return value in self._structure.keys or self._reader.facts.term(value) in terms

    def _links(self, node: Node) -> tuple[str, ...]:
        facts = self._reader.facts
        found = set()
        for target in facts.take_nodes(node, "hasTopic"):
            topic = self._topics.get(target)
            if topic is None:
                text = f"It leads to {facts.name(target)!r}, which is no individual of a topic."
                facts.wrong(node, text, "Declare that individual, or remove the link.")
                continue
            found.add(self._structure.keys[topic])
            if self._cultures[target] != self._cultures[node]:
                text = f"It leads to {facts.name(target)}, of another culture: taken as a link"
                facts.warn(node, f"{text} to the topic.")
        return tuple(sorted(found))

    def _likeliness(self, node: Node) -> float:
        facts = self._reader.facts
        values = facts.take(node, "hasLikeliness")
        if not values:
            facts.warn(node, "It has no hasLikeliness: the usual one is taken.")
            return -1.0
        numbers = {_number(value) for value in values}
        if len(numbers) > 1:
            facts.wrong(node, "It has more than one hasLikeliness.", "Keep one.")
        number = numbers.pop()
        if number is None or not 0 <= number <= 1:
            text = "Its hasLikeliness is not a number from 0 to 1."
            facts.wrong(node, text, "Write one such as 0.45 (xsd:decimal).")
            return -1.0
        self._check_type(node, values[0])
        return number

    def _check_type(self, node: Node, value: Value) -> None:
        facts = self._reader.facts
        datatype = (
            facts.iris.get(value.kind, "")
            if isinstance(value, Text) and isinstance(value.kind, int)
            else ""
        )
        if datatype not in _EXACT:
            text = "Its hasLikeliness is not typed xsd:decimal: taken as it stands."
            facts.warn(node, text)


def _number(value: Value) -> float | None:
    found = value.value if isinstance(value, Text) else None
    try:
        return None if found is None else float(found)
    except ValueError:
        return None
