"""The process that reads one file: bytes in, an OwlFile (or what is wrong) out, nothing else."""

import gc
import os
import sys
from typing import BinaryIO

import msgspec

from ontology_io.owl.file_records import OwlFile, Problem
from ontology_io.owl.limits import Limits, OwlError, refusal
from ontology_io.owl.sandbox import confine, lock


class Order(msgspec.Struct, frozen=True, kw_only=True):
    """What to read: `kind` is rdfxml or owlxml, `content` the namespace a remainder gets."""

    kind: str
    content: str
    limits: Limits


class Answer(msgspec.Struct, frozen=True, kw_only=True):
    """Either the file or the problems."""

    file: OwlFile | None = None
    problems: tuple[Problem, ...] = ()


def main() -> None:
    """Read the file from standard input, write the answer to standard output."""
    order = msgspec.json.decode(sys.argv[1], type=Order)
    confine(order.limits)
    gc.disable()
    try:
        answer = Answer(file=_read(sys.stdin.buffer, order))
    except OwlError as error:
        answer = Answer(problems=error.problems)
    except MemoryError:
        answer = _only("It needs more memory than a file may take.", "Split it.")
    _write(msgspec.msgpack.encode(answer))


#: Indexes of owlready2 for questions that are not asked here: a tenth of the memory.
_NOT_NEEDED = ("index_objs_sp", "index_datas_sp")


class _Nameless:
    """A stream without a name: of a named file of 8 MB owlready2 would start a process to read."""

    def __init__(self, stream: BinaryIO) -> None:
        self.read = stream.read


def _read(stream: BinaryIO, order: Order) -> OwlFile:
    # Imported below the limits and above the lock.
    import owlready2  # type: ignore[import-untyped]
    import owlready2.owlxml_2_ntriples  # type: ignore[import-untyped]
    import owlready2.rdfxml_2_ntriples  # type: ignore[import-untyped]

    from ontology_io.owl.facts import load
    from ontology_io.owl.read_file import read_file

    world = owlready2.World()
    graph = world.get_ontology("urn:cair:file#").graph
    sys.excepthook = lambda *_: None
    for index in _NOT_NEEDED:
        world.graph.db.execute(f"DROP INDEX IF EXISTS {index}")
    lock()
    try:
        graph.parse(_Nameless(stream), format=order.kind, default_base="urn:cair:file")
    except owlready2.OwlReadyOntologyParsingError as error:
        raise _unread(error) from None
    facts = load(world.graph.db, graph.c)
    world.close()
    return read_file(facts, order.limits, order.content)


def _unread(error: Exception) -> Exception:
    cause = error.__context__
    if isinstance(cause, MemoryError) or "memory" in str(cause).lower():
        return MemoryError()
    said = str(error.args[-1]) if error.args else ""
    place = said[said.find("line ") :].rstrip(".") if "line " in said else "File"
    hint = "In Protégé: File > Save as > RDF/XML."
    return refusal("It cannot be read here.", hint, place.capitalize())


def _only(text: str, hint: str) -> Answer:
    return Answer(problems=(Problem(where="File", text=text, hint=hint),))


def _write(answer: bytes) -> None:
    view = memoryview(answer)
    while view:
        view = view[os.write(1, view) :]
