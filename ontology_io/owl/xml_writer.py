"""Elements of RDF/XML as text: escaped right, one a line, the same for the same values."""

import re

from ontology_io.owl.vocabulary import OWL, RDF, RDFS, VOCABULARY, XSD

#: What XML 1.0 has no way to write (other control characters are written as they are).
FORBIDDEN = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\ud800-\udfff\ufffe\uffff]")
_LANGUAGE = re.compile(r"[A-Za-z]{1,8}(-[A-Za-z0-9]{1,8})*")


class UnwritableError(ValueError):
    """A text that XML cannot hold."""


def escaped(text: str) -> str:
    """Return the text for the content of an element. Raises UnwritableError."""
    found = FORBIDDEN.search(text)
    if found:
        place = f"{text[: found.start()]!r} and {found[0]!r}"
        raise UnwritableError(f"XML cannot hold the character after {place}. Remove it.")
    text = text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
    return text.replace("\r", "&#13;")


def attribute(text: str) -> str:
    """Return the text for an attribute in double quotes. Raises UnwritableError."""
    text = escaped(text).replace('"', "&quot;")
    return text.replace("\t", "&#9;").replace("\n", "&#10;")


def text(name: str, value: str, language: str = "") -> str:
    """Return `<name xml:lang="en">value</name>`."""
    return f"  <{name}{tag(language)}>{escaped(value)}</{name}>\n"


def tag(language: str) -> str:
    """Return the attribute that names a language, nothing for ""."""
    if language and not _LANGUAGE.fullmatch(language):
        raise UnwritableError(f"{language!r} is not the code of a language. Use one such as en.")
    return f' xml:lang="{language}"' if language else ""


def resource(name: str, iri: str) -> str:
    """Return `<name rdf:resource="iri"/>`; the IRI is an attribute's text already."""
    return f'  <{name} rdf:resource="{iri}"/>\n'


def node(name: str, number: int) -> str:
    """Return `<name rdf:nodeID="r1"/>`."""
    return f'  <{name} rdf:nodeID="r{number}"/>\n'


def integer(name: str, value: int) -> str:
    """Return a typed whole number."""
    return f'  <{name} rdf:datatype="{XSD}integer">{value}</{name}>\n'


def decimal(name: str, value: float) -> str:
    """Return a typed number with at least one and at most three decimals: 0.5, 0.125, 1.0."""
    digits = f"{value:.3f}".rstrip("0")
    digits += "0" if digits.endswith(".") else ""
    return f'  <{name} rdf:datatype="{XSD}decimal">{digits}</{name}>\n'


def flag(name: str, *, value: bool) -> str:
    """Return a typed true or false."""
    return f'  <{name} rdf:datatype="{XSD}boolean">{str(value).lower()}</{name}>\n'


def element(name: str, iri: str, *lines: str) -> str:
    """Return `<name rdf:about="iri">` with the lines in it."""
    return f'<{name} rdf:about="{iri}">\n{"".join(lines)}</{name}>\n'


def individual(iri: str, type_iri: str, *lines: str) -> str:
    """Return a named individual of one class."""
    return element("owl:NamedIndividual", iri, resource("rdf:type", type_iri), *lines)


def axiom(source: str, prop: str, target: str, *lines: str) -> str:
    """Return the annotations of an axiom; `target` are attributes and content: ` xml:lang="en">x`.

    The target ends with `</owl:annotatedTarget>` or is an empty element: see `literal_target` and
    `node_target`.
    """
    return (
        f'<owl:Axiom>\n  <owl:annotatedSource rdf:resource="{source}"/>\n'
        f'  <owl:annotatedProperty rdf:resource="{prop}"/>\n'
        f"  <owl:annotatedTarget{target}\n{''.join(lines)}</owl:Axiom>\n"
    )


def literal_target(value: str, language: str = "") -> str:
    """Return the target of an axiom about a text."""
    return f"{tag(language)}>{escaped(value)}</owl:annotatedTarget>"


def node_target(number: int) -> str:
    """Return the target of an axiom about a restriction."""
    return f' rdf:nodeID="r{number}"/>'


def opening(iri: str) -> str:
    """Return the beginning of the document; `iri` is an attribute's text already."""
    spaces = (("rdf", RDF), ("rdfs", RDFS), ("owl", OWL), ("xsd", XSD), ("cair", VOCABULARY))
    lines = [f'  xmlns:{prefix}="{space}"' for prefix, space in (*spaces, ("kb", f"{iri}#"))]
    return (
        f'<?xml version="1.0" encoding="UTF-8"?>\n<rdf:RDF xml:base="{iri}"\n'
        + "\n".join(lines)
        + ">\n"
    )


CLOSING = "</rdf:RDF>\n"
