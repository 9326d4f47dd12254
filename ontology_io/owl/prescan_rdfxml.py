"""What RDF/XML may hold: what Protégé and the common libraries write, nothing that is misread."""

from collections.abc import Callable

from ontology_io.owl.limits import Limits
from ontology_io.owl.looks import SAVE_AS
from ontology_io.owl.prescan_rules import RDF, SEPARATOR, XML, Rules, Stop
from ontology_io.owl.vocabulary import OWL

_ABOUT, _NODE, _RESOURCE, _DATATYPE, _PARSE = (
    f"{RDF}{SEPARATOR}{name}" for name in ("about", "nodeID", "resource", "datatype", "parseType")
)
_ID = f"{RDF}{SEPARATOR}ID"
_LANG, _BASE = f"{XML}{SEPARATOR}lang", f"{XML}{SEPARATOR}base"
_IMPORTS = f"{OWL}{SEPARATOR}imports"
_ONTOLOGY = f"{OWL}{SEPARATOR}Ontology"
_OF_NODES = frozenset({_ABOUT, _NODE})
_OF_PROPERTIES = frozenset({_RESOURCE, _NODE, _DATATYPE, _PARSE, _LANG})
_SYNTAX = frozenset(
    f"{RDF}{SEPARATOR}{name}" for name in ("RDF", "li", "aboutEach", "aboutEachPrefix", "bagID")
)


class RdfXmlRules(Rules):
    """Elements take turns: the root, nodes, their properties, nodes again."""

    def __init__(self, limits: Limits, line: Callable[[], int]) -> None:
        super().__init__(limits, line)
        self._base = ""
        self._ontologies = 0
        #: For each open property: (may hold nodes, number of nodes in it, text in it)
        self._open: list[list[bool | int]] = []

    def start(self, tag: str, attributes: dict[str, str]) -> None:
        """Hold a root, node or property to the rules, by its depth."""
        super().start(tag, attributes)
        if self.depth == 1:
            self._root(attributes)
        elif tag in _SYNTAX or SEPARATOR not in tag:
            raise Stop(f"The element {_short(tag)!r} is not read here.", SAVE_AS)
        elif self.depth % 2:
            self._property(tag, attributes)
        else:
            self._node(tag, attributes)

    def end(self, tag: str) -> None:
        """Refuse text and nodes side by side, which would be read wrongly."""
        super().end(tag)
        if self.depth and self.depth % 2 == 0:
            holds, nodes, text = self._open.pop()
            if nodes and text:
                self.problem("Text and elements are mixed.", SAVE_AS)
            if holds == 2 and not nodes:
                self.problem("A collection is empty.", "Remove it, or name its members.")

    def text(self, text: str) -> None:
        """Refuse text that belongs to no property."""
        super().text(text)
        if text.isspace():
            return
        if self.depth % 2 == 0 or self.depth == 1:
            self.problem("There is text between the elements.", "Remove it.")
        elif not self._open[-1][0]:
            self.problem("An element with a resource has text as well.", SAVE_AS)
        else:
            self._open[-1][2] = True

    def _root(self, attributes: dict[str, str]) -> None:
        self._base = attributes.get(_BASE, "")
        if self._base:
            self.iri(self._base)
        if _LANG in attributes:
            raise _inherited()
        if set(attributes) - {_BASE}:
            raise Stop("The root element has attributes that are not read.", SAVE_AS)

    def _node(self, tag: str, attributes: dict[str, str]) -> None:
        if self._open:
            self._inside()
        self._attributes(attributes, _OF_NODES)
        if _ABOUT in attributes:
            self._reference(attributes[_ABOUT], slash=tag == _ONTOLOGY)
        if tag == _ONTOLOGY:
            self._ontologies += 1
            if self._ontologies > 1:
                raise Stop("It holds two ontologies.", "Keep one owl:Ontology element.")

    def _inside(self) -> None:
        """Count a node inside a property: one, or any number in a collection."""
        open_ = self._open[-1]
        open_[1] += 1
        if not open_[0] or (open_[1] > 1 and open_[0] == 1):
            self.problem("A property holds more than one value.", "Write it once for each.")

    def _property(self, tag: str, attributes: dict[str, str]) -> None:
        if tag == _IMPORTS:
            raise Stop(
                "It imports another ontology (owl:imports).",
                "In Protégé: remove the import, or merge it into this ontology first.",
            )
        self._attributes(attributes, _OF_PROPERTIES)
        if _RESOURCE in attributes:
            self._reference(attributes[_RESOURCE])
        if _DATATYPE in attributes:
            self.iri(attributes[_DATATYPE])
            self.typed(attributes[_DATATYPE])
        kind = attributes.get(_PARSE, "")
        if kind not in ("", "Collection"):
            raise Stop(f"rdf:parseType={kind[:20]!r} is not read.", SAVE_AS)
        empty = _RESOURCE in attributes or _NODE in attributes
        self._open.append([0 if empty else 2 if kind else 1, 0, False])

    def _attributes(self, attributes: dict[str, str], known: frozenset[str]) -> None:
        for name in attributes:
            if name in known:
                continue
            if name == _LANG:
                raise _inherited()
            if name == _BASE:
                raise Stop("xml:base is set inside the file.", "Set it once, at rdf:RDF.")
            if name == _ID:
                raise Stop("rdf:ID is not read.", f"Write rdf:about with the full IRI. {SAVE_AS}")
            raise Stop(f"The attribute {_short(name)!r} is not read here.", SAVE_AS)

    def _reference(self, iri: str, *, slash: bool = False) -> None:
        if (not iri or iri.startswith("#")) and self._base and "#" not in self._base:
            self.iri(self._base + iri)
            return
        self.iri(iri)
        if iri.endswith("/") and not slash:
            self.problem(f"{iri[:80]!r} ends in '/', which is lost.", "Write it without.")


def _short(name: str) -> str:
    return name.rsplit(SEPARATOR, 1)[-1][:40]


def _inherited() -> Stop:
    return Stop("xml:lang is given for more than one text.", "Write it at each text.")
