"""Short names for the terms a file uses: ours under any of their namespaces, and W3C's."""

from collections.abc import Mapping

from ontology_io.owl import vocabulary

_OURS = frozenset(
    term.name
    for terms in (
        vocabulary.CLASSES,
        vocabulary.OBJECT_PROPERTIES,
        vocabulary.DATA_PROPERTIES,
        vocabulary.ANNOTATION_PROPERTIES,
    )
    for term in terms
)
_NAMESPACES = (vocabulary.VOCABULARY, *vocabulary.ALIASES)
PREFIXES = {
    "rdf:": vocabulary.RDF,
    "rdfs:": vocabulary.RDFS,
    "owl:": vocabulary.OWL,
    "xsd:": vocabulary.XSD,
}


def names_of(iris: Mapping[int, str]) -> dict[int, str]:
    """Return key → short name for the terms among these IRIs."""
    found = {}
    for key, iri in iris.items():
        if name := short(iri):
            found[key] = name
    return found


def short(iri: str) -> str:
    """Return "Topic" for a term of ours, "owl:Class" for one of W3C's, "" for others."""
    for namespace in _NAMESPACES:
        if iri.startswith(namespace):
            name = iri[len(namespace) :]
            return name if name in _OURS else ""
    for prefix, namespace in PREFIXES.items():
        if iri.startswith(namespace):
            return prefix + iri[len(namespace) :]
    return ""


def long(key: str) -> str:
    """Return the IRI of a short name; an IRI is given back as it is."""
    if key in _OURS:
        return vocabulary.VOCABULARY + key
    prefix, colon, name = key.partition(":")
    namespace = PREFIXES.get(prefix + colon)
    return namespace + name if namespace else key


def ours(key: str) -> bool:
    """Say whether a short name is one of our terms."""
    return key in _OURS
