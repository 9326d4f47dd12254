"""What an import kept because the vocabulary does not know it: N-Triples, written as RDF/XML."""

import re
from collections.abc import Iterator
from itertools import groupby
from typing import NamedTuple

from ontology_io.owl import xml_writer as xml
from ontology_io.owl.vocabulary import OWL, RDF, RDFS, VOCABULARY

PREFIXES = {RDF: "rdf", RDFS: "rdfs", OWL: "owl", VOCABULARY: "cair"}
_IRI = r"<([^<>\"{}|^`\\\x00-\x20]*(?:\\u[0-9A-Fa-f]{4}[^<>\"{}|^`\\\x00-\x20]*)*)>"
_BLANK = r"_:([A-Za-z0-9][A-Za-z0-9_.-]*)"
_LITERAL = rf'"((?:[^"\\\n\r]|\\.)*)"(?:@([A-Za-z0-9-]+)|\^\^{_IRI})?'
_TRIPLE = re.compile(rf"(?:{_IRI}|{_BLANK}) {_IRI} (?:{_IRI}|{_BLANK}|{_LITERAL}) ?\.")
_ESCAPE = re.compile(r"\\(?:u([0-9A-Fa-f]{4})|U([0-9A-Fa-f]{8})|(.))", re.DOTALL)
_SHORT = {"t": "\t", "b": "\b", "n": "\n", "r": "\r", "f": "\f"}
_ELEMENT = re.compile(r"[A-Za-z_][A-Za-z0-9_.-]*\Z")


class RemainderError(ValueError):
    """A line of the remainder that cannot be written as RDF/XML."""


class Triple(NamedTuple):
    """One triple; a blank node is `_:name`. `kind` of the object: iri, blank or literal."""

    subject: str
    predicate: str
    kind: str
    value: str
    language: str = ""
    datatype: str = ""


def read_triple(line: str) -> Triple:
    """Return the triple of a line of N-Triples. Raises RemainderError."""
    found = _TRIPLE.fullmatch(line.strip())
    if not found:
        raise RemainderError(f"This is not a line of N-Triples: {line[:80]!r}.")
    about, blank, predicate, iri, node, value, language, datatype = found.groups()
    subject = _unescaped(about) if about is not None else f"_:{blank}"
    if iri is not None:
        return Triple(subject, _unescaped(predicate), "iri", _unescaped(iri))
    if node is not None:
        return Triple(subject, _unescaped(predicate), "blank", node)
    return Triple(
        subject,
        _unescaped(predicate),
        "literal",
        _unescaped(value),
        language or "",
        _unescaped(datatype or ""),
    )


def remainder_elements(lines: str) -> Iterator[str]:
    """Yield an rdf:Description for each subject, in the order of the lines.

    Raises RemainderError where a property's IRI has no end that can name an element.
    """
    triples = (read_triple(line) for line in lines.split("\n") if line.strip())
    for subject, group in groupby(triples, key=lambda triple: triple.subject):
        about = f'nodeID="{_node(subject[2:])}"' if subject.startswith("_:") else _about(subject)
        said = "".join(_property(triple) for triple in group)
        yield f"<rdf:Description rdf:{about}>\n{said}</rdf:Description>\n"


def _about(subject: str) -> str:
    return f'about="{xml.attribute(subject)}"'


def _node(name: str) -> str:
    """Return a name that no restriction of the file has."""
    return f"x-{name}"


def _property(triple: Triple) -> str:
    local, space = _element(triple.predicate)
    prefix = PREFIXES.get(space, "u")
    name = f"{prefix}:{local}"
    start = f"<{name}" if prefix != "u" else f'<{name} xmlns:u="{xml.attribute(space)}"'
    if triple.kind == "iri":
        return f'  {start} rdf:resource="{xml.attribute(triple.value)}"/>\n'
    if triple.kind == "blank":
        return f'  {start} rdf:nodeID="{_node(triple.value)}"/>\n'
    typed = f' rdf:datatype="{xml.attribute(triple.datatype)}"' if triple.datatype else ""
    said = xml.escaped(triple.value)
    return f"  {start}{typed}{xml.tag(triple.language)}>{said}</{name}>\n"


def _element(predicate: str) -> tuple[str, str]:
    found = _ELEMENT.search(predicate)
    if not found:
        raise RemainderError(f"The property {predicate} cannot be written as RDF/XML. Rename it.")
    return found[0], predicate[: found.start()]


def _unescaped(text: str) -> str:
    return _ESCAPE.sub(_character, text) if "\\" in text else text


def _character(found: re.Match[str]) -> str:
    code = found[1] or found[2]
    return chr(int(code, 16)) if code else _SHORT.get(found[3], found[3])
