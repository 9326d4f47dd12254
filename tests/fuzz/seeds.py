"""Well-formed data to begin with, and the words its grammars are made of."""

import gzip
import json
import zlib

from dialogue.engine import codec
from dialogue.engine.state import DialogueState, Pending
from tests.fuzz.targets import KEY
from tests.ontology import hostile_owl

_START = DialogueState("en", "EN")
_TALK = DialogueState(
    "ja", "JP", 7, 9, 3, "q", "wc", (9, 8, 400), (1, 2), offer=3, levels=b"\0\5\0\1",
    pending=Pending(1, "title", (("title", "千本桜"),)), used=(b"\1\3", b"\0\7"),
)  # fmt: skip
_TURN = json.dumps({"client_sentence": "perché", "capabilities": ["playsong"], "seed": 7}).encode()

STATES = [codec.encode(state, [KEY]).encode() for state in (_START, _TALK)]
SIGNED = [codec._unwrapped(text)[16:] for text in STATES]
TRIGGERS = [
    text.encode()
    for text in (
        "(play|put on) [the song] {title}\nplay the song Volare",
        "[<please>] turn {level} [{count} times]\nplease turn up 3 times",
        "mi (piace|piacciono) {topic}\nmi piace il caffè",
        "{title} を かけて\n千本桜をかけて",
        "a [b [c [d e]]]\na b c",
    )
]
BODIES = [
    _TURN,
    zlib.compress(_TURN),
    gzip.compress(_TURN, mtime=0),
    b'{"a": [[{"b": "\\ud83d\\ude00"}], 1e9, null]}',
    zlib.compress(bytes(500_000)),
]
_DOCTYPE = '[<!ENTITY kb "urn:cair:kb#">]'
FILES = [
    hostile_owl.document().bytes(),
    hostile_owl.document().as_owlxml(),
    hostile_owl.with_doctype(_DOCTYPE, "&kb;Tea"),
    hostile_owl.changed(tea='<rdfs:seeAlso rdf:resource="urn:x"/>'),
]
TRIGGER_WORDS = ["{title}", "{level}", "{count}", "{topic}", "<please>", "(a|b)", "[a]", "|", "\n"]
JSON_WORDS = ["\\ud800", "\\u0000", "1e999", "null", "[[", "]]", '{"', '":', "NaN", "\x1f\x8b"]
XML_WORDS = [
    "<!DOCTYPE", "<!ENTITY", "SYSTEM", "<![CDATA[", "]]>", "<?x ?>", "<!--", "-->", "&#0;", "&kb;",
    "rdf:about=", "rdf:resource=", "rdf:nodeID=", "rdf:parseType=", "rdf:ID=", "xml:lang=",
    "rdf:datatype=", "xml:base=", "owl:Class", "owl:Axiom", "owl:imports", 'encoding="utf-16"',
]  # fmt: skip
