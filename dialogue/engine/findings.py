"""Findings: what a check found wrong or worth a look, in words for experts."""

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Finding:
    """One finding: a stable code, where (a topic's or sentence's key), what, and what to do."""

    code: str
    where: str
    message: str
    hint: str
    error: bool = True

    def __str__(self) -> str:
        return f"{self.code} {self.where}: {self.message} Hint: {self.hint}"

    def with_place(self, places: Mapping[str, tuple[str, int]]) -> str:
        """Return the finding after the file and line it stands in, where they are known."""
        file, line = places.get(self.where, ("", 0))
        return f"{file}:{line}: {self}" if file else str(self)
