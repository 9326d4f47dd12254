"""What OWL/XML may hold."""

from collections.abc import Callable

from ontology_io.owl.limits import Limits
from ontology_io.owl.looks import SAVE_AS
from ontology_io.owl.prescan_rules import SEPARATOR, XML, XML_OWL, Rules, Stop

_LANG, _BASE = f"{XML}{SEPARATOR}lang", f"{XML}{SEPARATOR}base"
_KNOWN = frozenset(
    {"IRI", "abbreviatedIRI", "name", "ontologyIRI", "versionIRI", "cardinality", "facet"}
    | {"datatypeIRI", _LANG, _BASE}
)
_ANNOTATED = frozenset(
    {"Ontology", "SubClassOf", "SubObjectPropertyOf", "SubDataPropertyOf", "ClassAssertion"}
    | {"EquivalentClasses", "AnnotationAssertion", "DataPropertyAssertion"}
    | {"ObjectPropertyAssertion", "SubAnnotationPropertyOf", "DisjointUnion"}
    | {"EquivalentObjectProperties", "EquivalentDataProperties", "ObjectPropertyDomain"}
    | {"DataPropertyDomain", "AnnotationPropertyDomain", "ObjectPropertyRange"}
    | {"DataPropertyRange", "AnnotationPropertyRange"}
)
_PAIRS = frozenset(
    {"EquivalentClasses", "EquivalentObjectProperties", "EquivalentDataProperties"}
    | {"SameIndividual", "InverseObjectProperties"}
)
#: What owlready2 passes over without a word.
_PASSED_OVER = frozenset(
    {"AnonymousIndividual", "DLSafeRule", "HasKey", "DatatypeDefinition", "DescriptionGraphRule"}
    | {"NegativeObjectPropertyAssertion", "NegativeDataPropertyAssertion"}
)


class OwlXmlRules(Rules):
    """Every element is of OWL's namespace; only IRI attributes point anywhere."""

    def __init__(self, limits: Limits, line: Callable[[], int]) -> None:
        super().__init__(limits, line)
        self._base = ""
        self._literal = False
        #: IRI or AbbreviatedIRI while one of these is open, and its text.
        self._held = self._iri = ""
        #: The elements that are open, each with the number of its members.
        self._open: list[tuple[str, int]] = []
        self._prefixes: set[str] = set()

    def start(self, tag: str, attributes: dict[str, str]) -> None:
        """Hold an element to the rules."""
        super().start(tag, attributes)
        namespace, _, name = tag.partition(SEPARATOR)
        if namespace != XML_OWL or (self.depth > 1 and name == "Ontology"):
            raise Stop(f"The element {tag.rsplit(SEPARATOR, 1)[-1][:40]!r} is not read.", SAVE_AS)
        if name == "Import":
            raise Stop(
                "It imports another ontology (owl:imports).",
                "In Protégé: remove the import, or merge it into this ontology first.",
            )
        if name in _PASSED_OVER:
            raise Stop(f"{name} is not read in OWL/XML.", SAVE_AS)
        self._within(name)
        self._literal = name == "Literal"
        self._held = name if name in ("IRI", "AbbreviatedIRI") else ""
        self._iri = ""
        self._attributes(name, attributes)

    def _within(self, name: str) -> None:
        """Refuse what is lost when owlready2 reads it: third members, some annotations."""
        if self._open:
            above, members = self._open[-1]
            members += name != "Annotation"
            self._open[-1] = (above, members)
            if name == "Annotation" and above not in _ANNOTATED:
                raise Stop(f"An annotation of {above} is not read in OWL/XML.", SAVE_AS)
            if above in _PAIRS and members > 2:
                raise Stop(f"{above} of more than two is not read in OWL/XML.", SAVE_AS)
        self._open.append((name, 0))

    def text(self, text: str) -> None:
        """Gather the IRI that an element holds; refuse text that nothing holds."""
        super().text(text)
        if self._held:
            self._iri = (self._iri + text)[: self.limits.attribute]
        elif not self._literal and not text.isspace():
            self.problem("There is text between the elements.", "Remove it.")

    def end(self, tag: str) -> None:
        """Hold the IRI that ends here to the rules."""
        super().end(tag)
        self._open.pop()
        if self._held == "IRI":
            self._iris({"IRI": self._iri})
        elif self._held:
            self._abbreviated(self._iri)
        self._held = self._iri = ""
        self._literal = False

    def _attributes(self, tag: str, attributes: dict[str, str]) -> None:
        for name in attributes:
            if name not in _KNOWN or (name == _LANG and not self._literal):
                raise Stop(f"The attribute {name[-40:]!r} is not read here.", SAVE_AS)
            if name == _BASE and self.depth > 1:
                raise Stop("xml:base is set inside the file.", "Set it once, at Ontology.")
        if self.depth == 1:
            self._root(attributes)
        elif tag == "Prefix":
            self.iri(attributes.get("IRI", ""))
            self._prefixes.add(attributes.get("name", ""))
        else:
            self._iris(attributes)

    def _root(self, attributes: dict[str, str]) -> None:
        iri = attributes.get("ontologyIRI", "")
        self.iri(iri)
        self._base = iri
        if attributes.get(_BASE, iri).rstrip("#") != iri:
            self._base = ""

    def _iris(self, attributes: dict[str, str]) -> None:
        if "IRI" in attributes:
            iri = attributes["IRI"]
            self.iri(self._base + iri if iri.startswith("#") else iri)
            if iri.endswith("/"):
                self.problem(f"{iri[:80]!r} ends in '/', which is lost.", "Write it without.")
        if "abbreviatedIRI" in attributes:
            self._abbreviated(attributes["abbreviatedIRI"])
        if "facet" in attributes:
            self.iri(attributes["facet"])
        if "datatypeIRI" in attributes:
            self.iri(attributes["datatypeIRI"])
            self.typed(attributes["datatypeIRI"])

    def _abbreviated(self, iri: str) -> None:
        prefix, colon, _ = iri.partition(":")
        if not colon or prefix not in self._prefixes:
            self.problem(f"The prefix of {iri[:60]!r} is not declared.", SAVE_AS)
