"""Conflicts that were looked at and are wanted: which, and why."""

from collections.abc import Collection, Iterable
from dataclasses import dataclass

from plans.engine.remarks import Remark


@dataclass(frozen=True, slots=True)
class Accepted:
    """A remark that is no fault: its code, its intent, the other intent ("" for none), the reason.

    `language` "" holds for all languages, `near` "" for all triggers.
    """

    code: str
    where: str
    other: str
    reason: str
    language: str = ""
    near: str = ""

    def covers(self, remark: Remark) -> bool:
        """Say whether this is the remark that was accepted."""
        same = (self.code, self.where, self.other) == (remark.code, remark.where, remark.other)
        spoken = self.language in ("", remark.language)
        return same and spoken and self.near in ("", remark.near)


ACCEPTED: tuple[Accepted, ...] = (
    Accepted(
        "C001",
        "appreciation",
        "opinion",
        "音楽が好きなの asks the agent more often than it tells something; 好きなのよ tells.",
        language="ja",
    ),
)


def without_accepted(
    remarks: Iterable[Remark],
    accepted: Collection[Accepted] = ACCEPTED,
) -> tuple[list[Remark], list[Accepted]]:
    """Return the remarks nobody accepted, and the acceptances that cover nothing any more."""
    kept: list[Remark] = []
    used: set[Accepted] = set()
    for remark in remarks:
        covering = [each for each in accepted if each.covers(remark)]
        used.update(covering)
        if not covering:
            kept.append(remark)
    return kept, [each for each in accepted if each not in used]
