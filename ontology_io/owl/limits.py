"""How much of an OWL file is accepted, and what is said about one that is not."""

from collections.abc import Iterable

import msgspec

from ontology_io.owl.file_records import Problem


class Limits(msgspec.Struct, frozen=True, kw_only=True):
    """Bounds for a file (bytes, characters, counts) and for the process that reads it.

    `memory` is address space in bytes, `cpu` and `wall` are seconds, `answer` bytes.
    """

    size: int = 64 * 1024 * 1024
    elements: int = 3_000_000
    depth: int = 60
    attribute: int = 2_000
    text: int = 10_000
    entities: int = 100
    entity: int = 500
    sentence: int = 400
    levels: int = 100
    problems: int = 200
    memory: int = 1536 * 1024 * 1024
    cpu: int = 60
    wall: int = 180
    answer: int = 128 * 1024 * 1024


class OwlError(Exception):
    """The file cannot be read; `problems` say why, each with what to do."""

    def __init__(self, problems: Iterable[Problem]) -> None:
        self.problems = tuple(problems)
        super().__init__("\n".join(str(problem) for problem in self.problems))


def refusal(text: str, hint: str = "", where: str = "File") -> OwlError:
    """Return the error for a file with one thing wrong."""
    return OwlError([Problem(where=where, text=text, hint=hint)])
