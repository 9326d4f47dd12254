"""What both XML forms of OWL are held to: depth, lengths, IRIs, numbers, no foreign code."""

import re
from collections.abc import Callable

from ontology_io.owl.file_records import Problem
from ontology_io.owl.limits import Limits, OwlError
from ontology_io.owl.vocabulary import OWL, XSD
from ontology_io.owl.vocabulary import RDF as RDF_NAMESPACE

SEPARATOR = "\n"
RDF = RDF_NAMESPACE
XML_OWL = OWL
XML = "http://www.w3.org/XML/1998/namespace"
#: owlready2 imports and runs Python modules that a file names with these.
DANGER = "http://www.lesfleursdunormal.fr/static/_downloads/owlready_ontology.owl"

_IRI = re.compile(
    r"[A-Za-z][A-Za-z0-9+.-]*:[^\s<>\"{}|\\^`\x00-\x20\x7f-\x9f#]*(#[^\s<>\"{}|\\^`\x00-\x20\x7f-\x9f#]*)?"
)
_INTEGER = re.compile(r"\s*[+-]?[0-9]{1,18}\s*", re.ASCII)
_DECIMAL = re.compile(r"\s*[+-]?([0-9]{1,18}(\.[0-9]{0,18})?|\.[0-9]{1,18})\s*", re.ASCII)
_FLOAT = re.compile(r"\s*[+-]?([0-9]{1,18}(\.[0-9]{0,18})?|\.[0-9]{1,18})([eE][+-]?[0-9]{1,3})?\s*")
_INTEGERS = frozenset(
    XSD + name
    for name in (
        *("integer", "byte", "short", "int", "long", "unsignedByte", "unsignedShort"),
        *("unsignedInt", "unsignedLong", "negativeInteger", "nonNegativeInteger"),
        *("positiveInteger", "nonPositiveInteger"),
    )
)
_NUMBERS = {
    **dict.fromkeys(_INTEGERS, _INTEGER),
    f"{XSD}decimal": _DECIMAL,
    f"{OWL}real": _DECIMAL,
    f"{XSD}double": _FLOAT,
    f"{XSD}float": _FLOAT,
}


class Stop(Exception):  # noqa: N818 - it ends the pass, it is told as an OwlError
    """The file must not be read any further: why, and what to do."""

    def __init__(self, text: str, hint: str) -> None:
        super().__init__(text)
        self.text, self.hint = text, hint


class Rules:
    """Handlers for one pass of expat; `problems` collects what need not end it."""

    def __init__(self, limits: Limits, line: Callable[[], int]) -> None:
        self.limits = limits
        self.line = line
        self.problems: list[Problem] = []
        self.depth = 0
        self._elements = 0
        self._length = 0
        self._datatype = ""
        self._kept = ""

    def start(self, tag: str, attributes: dict[str, str]) -> None:
        """Count an element and hold its name and attributes to the rules."""
        self.depth += 1
        self._elements += 1
        self._length = 0
        self._datatype = self._kept = ""
        if self.depth > self.limits.depth:
            raise Stop(f"Its elements lie more than {self.limits.depth} deep.", "Flatten it.")
        if self._elements > self.limits.elements:
            raise Stop(f"It has more than {self.limits.elements} elements.", "Split it.")
        if tag.startswith(DANGER):
            raise _foreign_code()
        for name, value in attributes.items():
            if len(value) > self.limits.attribute:
                raise Stop("An attribute is too long.", f"At most {self.limits.attribute}.")
            if name.startswith(DANGER) or DANGER in value:
                raise _foreign_code()

    def end(self, tag: str) -> None:
        """Check the number that ends here."""
        self.depth -= 1
        if self._datatype:
            self._check_number()

    def text(self, text: str) -> None:
        """Count characters; keep the first of a number."""
        self._length += len(text)
        if self._length > self.limits.text:
            raise Stop(f"A text is longer than {self.limits.text} characters.", "Shorten it.")
        if self._datatype and len(self._kept) < 100:
            self._kept += text

    def typed(self, datatype: str) -> None:
        """Say that the element that has just begun holds a value of this type."""
        if datatype == f"{RDF}XMLLiteral":
            self.problem("XML inside a value (rdf:XMLLiteral) is not read.", "Write plain text.")
        if datatype in _NUMBERS:
            self._datatype = datatype

    def iri(self, iri: str) -> None:
        """Note an IRI that is not absolute or has characters that no IRI has."""
        if not _IRI.fullmatch(iri):
            self.problem(f"{iri[:80]!r} is not an absolute IRI.", "Write it in full, no blanks.")

    def problem(self, text: str, hint: str) -> None:
        """Note what is wrong in this line; too many of them end the pass."""
        where = f"Line {self.line()}"
        self.problems.append(Problem(where=where, text=text, hint=hint))
        if len(self.problems) >= self.limits.problems:
            raise OwlError(self.problems)

    def _check_number(self) -> None:
        if not _NUMBERS[self._datatype].fullmatch(self._kept):
            name = self._datatype.rsplit("#", 1)[-1]
            self.problem(f"{self._kept[:40]!r} is not a number (xsd:{name}).", "Write digits.")
        self._datatype = ""


def _foreign_code() -> Stop:
    return Stop("It names Python code to be run (owlready_ontology).", "Remove those lines.")
