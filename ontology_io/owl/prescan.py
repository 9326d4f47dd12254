"""One pass over an upload before anything interprets it: size, shape, no tricks, nothing kept.

owlready2 reads some RDF/XML wrongly without a word; such files are refused here, with what to do.
"""

from typing import Literal
from xml.parsers import expat

from ontology_io.owl.file_records import Problem
from ontology_io.owl.limits import Limits, OwlError, refusal
from ontology_io.owl.looks import SAVE_AS, strange
from ontology_io.owl.prescan_owlxml import OwlXmlRules
from ontology_io.owl.prescan_rdfxml import RdfXmlRules
from ontology_io.owl.prescan_rules import RDF, SEPARATOR, XML_OWL, Rules, Stop

Kind = Literal["rdfxml", "owlxml"]
_GATHERED = 1 << 16
_ENCODINGS = {"utf-8", "us-ascii", "ascii", "iso-8859-1", "utf-16"}


def scan(data: bytes, limits: Limits) -> Kind:
    """Return what the file is written in; raise OwlError where it cannot or must not be read."""
    if len(data) > limits.size:
        megabytes = limits.size // (1024 * 1024)
        raise refusal(f"It is larger than {megabytes} MB.", "Split it, or ask for a higher limit.")
    if kind := strange(data):
        raise refusal(kind, SAVE_AS)
    return _Scan(limits).run(data)


class _Scan:
    """One expat pass; the root element decides which rules the rest is held to."""

    def __init__(self, limits: Limits) -> None:
        self._limits = limits
        self._rules: Rules | None = None
        self._kind: Kind = "rdfxml"
        self._entities = 0
        self._parser = expat.ParserCreate(namespace_separator=SEPARATOR)

    def run(self, data: bytes) -> Kind:
        """Feed all of `data`; return its kind."""
        self._listen()
        try:
            # In one piece: older versions of expat read a long token anew with every piece.
            self._parser.Parse(data, True)
        except Stop as stop:
            raise OwlError([self._here(stop)]) from None
        except (expat.ExpatError, ValueError, LookupError) as error:
            raise self._broken(error) from None
        if self._rules is None or self._rules.problems:
            raise OwlError(self._rules.problems if self._rules else ())
        return self._kind

    def _listen(self) -> None:
        parser = self._parser
        parser.buffer_text = True
        parser.buffer_size = _GATHERED
        parser.SetParamEntityParsing(expat.XML_PARAM_ENTITY_PARSING_NEVER)
        parser.XmlDeclHandler = self._declaration
        parser.StartDoctypeDeclHandler = self._doctype
        parser.EntityDeclHandler = self._entity
        parser.ElementDeclHandler = self._no_dtd
        parser.AttlistDeclHandler = self._no_dtd
        parser.NotationDeclHandler = self._no_dtd
        parser.ExternalEntityRefHandler = self._no_entity
        parser.SkippedEntityHandler = self._no_dtd
        parser.CommentHandler = self._aside
        parser.ProcessingInstructionHandler = self._aside
        parser.StartElementHandler = self._root

    def _declaration(self, version: str, encoding: str | None, standalone: int) -> None:
        if encoding and encoding.lower() not in _ENCODINGS:
            raise Stop(f"Its encoding {encoding[:40]!r} is not read.", "Save it as UTF-8.")

    def _doctype(self, name: str, system: str | None, public: str | None, internal: int) -> None:
        if system or public:
            raise Stop("Its DOCTYPE names another file.", "Remove SYSTEM and PUBLIC.")

    def _no_dtd(self, *_: object) -> None:
        raise Stop("Its DOCTYPE holds more than short names for IRIs.", SAVE_AS)

    def _aside(self, *words: str) -> None:
        if max(len(word) for word in words) > self._limits.text:
            raise Stop(f"A comment is longer than {self._limits.text} characters.", "Shorten it.")

    def _no_entity(self, *_: object) -> int:
        raise Stop("It refers to another file.", SAVE_AS)

    def _entity(self, name: str, parameter: bool, value: str | None, *other: object) -> None:
        self._entities += 1
        if parameter or value is None or any(isinstance(word, str) for word in other[1:]):
            raise Stop("Its DOCTYPE names another file or a parameter entity.", SAVE_AS)
        if "&" in value or "%" in value or "<" in value:
            raise Stop(f"The entity {name[:40]!r} holds more than plain text.", SAVE_AS)
        if len(value) > self._limits.entity or self._entities > self._limits.entities:
            raise Stop("Its DOCTYPE has too many or too long entities.", SAVE_AS)

    def _root(self, tag: str, attributes: dict[str, str]) -> None:
        if tag == f"{RDF}{SEPARATOR}RDF":
            self._kind, self._rules = "rdfxml", RdfXmlRules(self._limits, self._line)
        elif tag == f"{XML_OWL}{SEPARATOR}Ontology":
            self._kind, self._rules = "owlxml", OwlXmlRules(self._limits, self._line)
        else:
            name = tag.rsplit(SEPARATOR, 1)[-1][:40]
            raise Stop(f"Its first element is {name!r}: neither rdf:RDF nor Ontology.", SAVE_AS)
        self._parser.StartElementHandler = self._rules.start
        self._parser.EndElementHandler = self._rules.end
        self._parser.CharacterDataHandler = self._rules.text
        self._rules.start(tag, attributes)

    def _line(self) -> int:
        return self._parser.CurrentLineNumber

    def _here(self, stop: Stop) -> Problem:
        return Problem(where=f"Line {self._line()}", text=stop.text, hint=stop.hint)

    def _broken(self, error: Exception) -> OwlError:
        code = getattr(error, "code", None)
        reason = expat.ErrorString(code) if code else "unknown encoding"
        line, column = self._parser.ErrorLineNumber, self._parser.ErrorColumnNumber + 1
        return refusal(
            f"It is not well-formed XML: {reason}.",
            "It may be cut short or not be UTF-8: save it again.",
            f"Line {line}, column {column}",
        )
