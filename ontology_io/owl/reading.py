"""Read an OWL file that may be hostile: scanned first, then interpreted in a process of its own."""

import sys
from pathlib import Path

import msgspec

from ontology_io.owl.child import Answer, Order
from ontology_io.owl.file_records import OwlFile
from ontology_io.owl.limits import Limits, OwlError, refusal
from ontology_io.owl.prescan import scan
from ontology_io.owl.runner import Outcome, run

__all__ = ["Limits", "OwlError", "read_owl"]

CONTENT = "urn:cair:kb#"
_ROOT = str(Path(__file__).resolve().parents[2])
_PROGRAM = (
    "import sys; sys.path.append(sys.argv.pop()); import ontology_io.owl.child as c; c.main()"
)


_LIMITS = Limits()


def read_owl(data: bytes, limits: Limits = _LIMITS, *, content: str = CONTENT) -> OwlFile:
    """Return what the file says, with all problems of its content in `problems`.

    `content` is the namespace in which the remainder names what is ours. OwlError where the file
    cannot be read at all, or must not be.
    """
    order = Order(kind=scan(data, limits), content=content, limits=limits)
    command = [sys.executable, "-I", "-c", _PROGRAM, msgspec.json.encode(order).decode(), _ROOT]
    outcome = run(command, data, seconds=limits.wall, most=limits.answer)
    return answered(outcome, limits)


def answered(outcome: Outcome, limits: Limits) -> OwlFile:
    """Return the file in the answer; OwlError where there is none."""
    if outcome.late:
        raise refusal(f"Reading took longer than {limits.wall} seconds.", "Split the file.")
    if outcome.long:
        raise refusal("What it says is too much to be taken at once.", "Split the file.")
    if outcome.code != 0:
        raise refusal("The reader was stopped: too much memory or time.", "Split the file.")
    try:
        answer = msgspec.msgpack.decode(outcome.answer, type=Answer)
    except msgspec.DecodeError:
        raise refusal("The reader gave no answer.", "Save the file again.") from None
    if answer.file is None:
        raise OwlError(answer.problems)
    return answer.file
