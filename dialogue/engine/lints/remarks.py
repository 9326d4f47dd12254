"""Remarks: what falls short of a quality bar, and where."""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from dialogue.engine.findings import Finding

_NAMED = 3


class Remark(NamedTuple):
    """One thing worth a look: the bar's id ("C2"), a topic's or sentence's key, what, what to do.

    `language` is "" where it concerns all of them.
    """

    code: str
    where: str
    message: str
    hint: str
    language: str = ""

    def finding(self) -> Finding:
        """Return it as a warning; the language stands in brackets at its end."""
        message = self.message
        if self.language:
            message = f"{message.removesuffix('.')} ({self.language})."
        return Finding(self.code, self.where, message, self.hint, error=False)


def some(keys: Sequence[str]) -> str:
    """Return the first three of many in words: "Tea, Milk, Coffee and 9 more"."""
    shown = ", ".join(keys[:_NAMED])
    return f"{shown} and {len(keys) - _NAMED} more" if len(keys) > _NAMED else shown


def percent(part: float, whole: float) -> float:
    """Return the share in percent; 0 of nothing."""
    return 100 * part / whole if whole else 0.0


def first_of(keys: Iterable[str]) -> list[str]:
    """Return the keys, each once, in their order."""
    return list(dict.fromkeys(keys))
