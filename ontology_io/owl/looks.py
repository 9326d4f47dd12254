"""What a file that is not XML looks like, so that its sender can be told what to do."""

import re

SAVE_AS = "In Protégé: File > Save as > RDF/XML."

_BOMS = (b"\xff\xfe", b"\xfe\xff")
_XML = re.compile(r"\s*<(\?xml|!--|!DOCTYPE|[A-Za-z_])", re.ASCII)
_HTML = re.compile(r"\s*<(!doctype\s+html|html[\s>])", re.IGNORECASE)
_TURTLE = re.compile(
    r"^\s*(@prefix|@base|prefix\s+\S*:\s*<|base\s+<)", re.IGNORECASE | re.MULTILINE
)
_FUNCTIONAL = re.compile(r"^\s*(Prefix\s*\(|Ontology\s*\()", re.MULTILINE)
_MANCHESTER = re.compile(r"^\s*(Prefix:|Ontology:|Class:|Namespace:)", re.MULTILINE)
_TRIPLES = re.compile(
    r"^\s*(<[^>\s]+>|_:\S+)\s+<[^>\s]+>\s+(<[^>\s]+>|_:\S+|\".*\"\S*)\s*\.\s*$", re.MULTILINE
)
_JSON = re.compile(r"\s*[{\[]")
_KINDS = (
    (_HTML, "This is a web page (HTML)."),
    (_TRIPLES, "This is N-Triples."),
    (_XML, ""),
)
_SOMEWHERE = (
    (_TURTLE, "This is Turtle."),
    (_FUNCTIONAL, "This is OWL in functional syntax."),
    (_MANCHESTER, "This is OWL in Manchester syntax."),
    (_JSON, "This is JSON."),
)


def strange(data: bytes) -> str:
    """Return one sentence about what `data` is where it cannot be XML, or "" where it may be."""
    if not data.strip():
        return "The file is empty."
    if data.startswith((b"PK\x03\x04", b"\x1f\x8b", b"7z\xbc\xaf", b"BZh", b"\xfd7zXZ")):
        return "This is a compressed file (zip, gzip ...)."
    head = _head(data)
    if "\0" in head or head.startswith(("%PDF", "\x7fELF", "\x89PNG", "SQLite format")):
        return "This is a binary file."
    return _text_kind(head)


def _head(data: bytes) -> str:
    if data.startswith(_BOMS):
        return data[:4000].decode("utf-16", "replace")
    return data[:4000].removeprefix(b"\xef\xbb\xbf").decode("utf-8", "replace")


def _text_kind(head: str) -> str:
    for pattern, sentence in _KINDS:
        if pattern.match(head):
            return sentence
    for pattern, sentence in _SOMEWHERE:
        if pattern.search(head):
            return sentence
    return "This is not XML."
