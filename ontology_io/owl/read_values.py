"""Single values out of the facts: texts with their language, numbers, flags; all with checks."""

import re
from collections.abc import Sequence

from languages.known import LANGUAGES
from ontology_io.owl.axioms import Axioms
from ontology_io.owl.facts import Facts, Node, Rows, Text, Value
from ontology_io.owl.limits import Limits
from ontology_io.owl.names import LOCAL_NAME

_CONTROL = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f\ufffe\uffff]")
_LANGUAGES = ", ".join(sorted(LANGUAGES))
#: Characters of a note, a pattern or words.
LONG = 2_000


class Reader:
    """The facts with what is annotated, and the ways in which all parts read a value."""

    def __init__(self, facts: Facts, limits: Limits) -> None:
        self.facts = facts
        self.limits = limits
        self.axioms = Axioms(facts)
        #: Slots, plans, actions and parameters that were taken.
        self.parts: set[Node] = set()
        #: Codes of cultures and keys of intents by node.
        self.cultures: dict[Node, str] = {}
        self.intents: dict[Node, str] = {}

    def declared(self, node: Node, term: str) -> None:
        """Take the declaration of an individual; note names that nothing may have."""
        facts = self.facts
        wanted = (term, "owl:NamedIndividual")
        facts.take_if(node, "rdf:type", lambda value: facts.term_of(value) in wanted)
        if not LOCAL_NAME.fullmatch(facts.name(node)):
            hint = "Use letters, digits, _ . and -, beginning with a letter."
            facts.wrong(node, "This name cannot be used.", hint)
        if facts.of_type(node, "owl:Class"):
            facts.wrong(node, "It is a class and an individual.", "Give one of them another name.")

    def note(self, node: Node) -> str:
        """Take the first comment without language; the others stay."""
        comments = self.facts.take_if(node, "rdfs:comment", _untagged)
        comments.sort(key=lambda value: _string(value))
        if len(comments) > 1:
            self.facts.put(node, "rdfs:comment", comments[1:])
        return self.word_of(comments[:1], node, "rdfs:comment")

    def word(self, node: Node, key: str, longest: int = LONG) -> str:
        """Take the one text without language of a property, "" where there is none."""
        return self.word_of(self.facts.take(node, key), node, key, longest)

    def word_of(self, values: Sequence[Value], where: Node, key: str, longest: int = LONG) -> str:
        """Return the one text among values that were taken."""
        texts = sorted({_string(value) for value in values if isinstance(value, Text)})
        if any(isinstance(value, int) for value in values):
            self.facts.wrong(where, f"Its {key} is not a text.", "Write a text.")
        if len(texts) > 1:
            self.facts.wrong(where, f"It has {len(texts)} values of {key}.", "Keep one.")
        return self.checked(texts[0], where, key, longest) if texts else ""

    def checked(self, text: str, where: Node, key: str, longest: int) -> str:
        """Return a text with its line ends as line feeds; note what no text may hold."""
        text = text.replace("\r\n", "\n").replace("\r", "\n")
        if _CONTROL.search(text):
            self.facts.wrong(where, f"Its {key} has control characters.", "Remove them.")
        if len(text) > longest:
            hint = f"Shorten it: {text[:40]!r} ..."
            self.facts.wrong(where, f"Its {key} is longer than {longest} characters.", hint)
        return text

    def integer(self, values: Sequence[Value], where: Node, key: str, missing: int) -> int:
        """Return the one whole number among values that were taken."""
        if not values:
            return missing
        numbers = {_integer(value) for value in values}
        number = numbers.pop()
        if number is None or numbers:
            self.facts.wrong(where, f"Its {key} is not one whole number.", "Write one, from 1.")
            return missing
        return number

    def flag(self, node: Node, key: str) -> bool:
        """Take a value that is true or false; false where there is none."""
        values = {_string(value).lower() for value in self.facts.take_texts(node, key)}
        if values - {"true", "false", "1", "0"} or len(values) > 1:
            self.facts.wrong(node, f"Its {key} is not true or false.", "Write true or false.")
        return bool(values & {"true", "1"})

    def language(self, text: Text, where: Node, key: str) -> str:
        """Return the language of a text, "" (and a problem) where there is none we speak."""
        tag = text.kind[1:] if isinstance(text.kind, str) else ""
        if tag in LANGUAGES:
            return tag
        shown = repr(_string(text)[:60])
        if not tag:
            hint = f"Give it one: {_LANGUAGES}."
            self.facts.wrong(where, f"Its {key} {shown} has no language tag.", hint)
            return ""
        plain = tag.lower().replace("_", "-").split("-")[0]
        if plain in LANGUAGES:
            self.facts.warn(where, f"Its {key} {shown} is tagged {tag!r}: read as {plain!r}.")
            return plain
        hint = f"The languages are {_LANGUAGES}."
        self.facts.wrong(where, f"Its {key} {shown} has the unknown language {tag!r}.", hint)
        return ""

    def texts(self, node: Node, key: str, longest: int = LONG) -> list[tuple[str, str, Text]]:
        """Take all texts of a property: language, text, and the literal; unknown ones are told."""
        found = []
        for literal in self.facts.take_texts(node, key):
            language = self.language(literal, node, key)
            text = self.checked(_string(literal), node, key, longest)
            if not text.strip():
                self.facts.wrong(node, f"One of its {key} is empty.", "Write it or remove it.")
            elif language:
                found.append((language, text, literal))
        return sorted(found, key=lambda row: row[:2])

    def by_language(self, node: Node, key: str, longest: int = LONG) -> dict[str, str]:
        """Take the one text a language may have."""
        found: dict[str, str] = {}
        for language, text, _ in self.texts(node, key, longest):
            if found.setdefault(language, text) != text:
                hint = f"Keep one of {found[language]!r} and {text!r}."
                self.facts.wrong(node, f"It has two values of {key} in {language!r}.", hint)
        return found

    def ordered(self, node: Node, key: str, longest: int = LONG) -> list[tuple[str, str, Rows]]:
        """Take all texts with their annotations: language, text, rows; by order, then text."""
        found = []
        for language, text, literal in self.texts(node, key, longest):
            rows = self.axioms.take(node, key, literal)
            for row in rows or [{}]:
                order = self.integer(row.get("order", ()), node, "order", 1_000_000)
                found.append((order, language, text, row))
        found.sort(key=lambda row: row[:3])
        return [row[1:] for row in found]

    def only(self, rows: Rows, where: Node) -> tuple[str, ...]:
        """Return the codes of the cultures a text is kept for."""
        codes = []
        for value in rows.get("onlyCulture", ()):
            code = self.cultures.get(value, "") if isinstance(value, int) else ""
            if not code:
                self.facts.wrong(where, "Its onlyCulture is no culture of the file.", "Correct it.")
            codes.append(code)
        return tuple(sorted(code for code in codes if code))


def words(text: str) -> tuple[str, ...]:
    """Return the words between the bars."""
    return tuple(word for word in text.split("|") if word.strip())


def string(value: Text) -> str:
    """Return a literal as a text."""
    return _string(value)


def _untagged(value: Value) -> bool:
    return isinstance(value, Text) and isinstance(value.kind, int)


def _string(value: Value) -> str:
    return "" if isinstance(value, int) or value.value is None else str(value.value)


def _integer(value: Value) -> int | None:
    if isinstance(value, int):
        return None
    found = value.value
    if isinstance(found, str) and found.strip().lstrip("-").isdecimal() and len(found) < 12:
        return int(found)
    if isinstance(found, float) and found.is_integer() and abs(found) < 2**53:
        return int(found)
    return found if isinstance(found, int) and abs(found) < 2**53 else None
