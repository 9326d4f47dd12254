"""The small interface every way of matching keeps."""

from dataclasses import dataclass
from typing import Protocol

from plans.engine.intents import Intent


@dataclass(frozen=True, slots=True)
class Candidate:
    """An intent a sentence may mean.

    `score` compares with other candidates only: priority, literal words, listed values, fewest
    free slots, fewest free words.
    """

    intent: Intent
    trigger: str
    parameters: dict[str, str]
    score: tuple[int, ...]


class Matcher(Protocol):
    """A way of matching for one language, compiled once."""

    def find(self, sentence: str) -> tuple[Candidate, ...]:
        """Return every intent the sentence may mean, in any order."""
        ...
