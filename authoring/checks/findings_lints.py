"""What the draft falls short of: the quality bars, as advice that never stops publishing."""

from dialogue.engine.concepts import Knowledge
from dialogue.engine.lints.accepted import STALE, without_accepted
from dialogue.engine.lints.corpus import corpus_of
from dialogue.engine.lints.lint import lint
from dialogue.engine.lints.remarks import Remark


class LintRemarks:
    """What was remarked last time: filling and reading all sentences takes seconds."""

    def __init__(self) -> None:
        self._last: tuple[Knowledge, tuple[Remark, ...]] | None = None

    def of(self, knowledge: Knowledge) -> tuple[Remark, ...]:
        """Return what falls short in a knowledge base without errors.

        What is accepted for nothing is left out: it concerns programmers only.
        """
        last = self._last
        if last is None or last[0] != knowledge:
            remarks = without_accepted(lint(corpus_of(knowledge)))
            last = self._last = (knowledge, tuple(one for one in remarks if one.code != STALE))
        return last[1]
