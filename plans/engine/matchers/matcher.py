"""The small interface every way of matching keeps."""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from typing import Protocol, runtime_checkable

import msgspec

from plans.engine.intents import Intent


class Way(StrEnum):
    """How a sentence was understood, from strict to loose.

    A looser way is only tried where the stricter ones find nothing. What is found as SUGGESTION is
    asked about and never acted on.
    """

    WORDS = "words"
    CLAUSE = "clause"
    FILLERS = "fillers"
    SPELLING = "spelling"
    SUGGESTION = "suggestion"


class Candidate(msgspec.Struct, frozen=True):
    """An intent a sentence may mean.

    `score` compares with other candidates only: priority, literal words, listed values, fewest
    free slots, fewest free words. `spans` says which characters of the sentence each parameter
    covers; `change` says in plain words what was forgiven, "" where nothing was.
    """

    intent: Intent
    trigger: str
    parameters: dict[str, str]
    score: tuple[int, ...]
    spans: Mapping[str, tuple[int, int]]
    change: str = ""


class Matcher(Protocol):
    """A way of matching for one language, compiled once."""

    def find(self, sentence: str, way: Way = Way.WORDS) -> tuple[Candidate, ...]:
        """Return every intent the sentence may mean when it is read in this way, in any order.

        A matcher answers () to the ways it does not know; it is asked in the order WORDS,
        FILLERS, SPELLING, and for SUGGESTION where something may be asked.
        """
        ...

    def forget(self) -> None:
        """Keep nothing of what was said: the turn is over."""
        ...

    def prepare(self) -> None:
        """Build now what is else built when the first sentence needs it."""
        ...


@dataclass(frozen=True, slots=True)
class NearMiss:
    """A trigger that almost fits; `faults` are sentences for an author."""

    intent: Intent
    trigger: str
    faults: tuple[str, ...]


@runtime_checkable
class Explaining(Protocol):
    """What a matcher may offer besides, for the page that explains a sentence."""

    def words(self, sentence: str) -> tuple[str, ...]:
        """Return the words as the matcher reads them."""
        ...

    def near(self, sentence: str, most: int) -> tuple[NearMiss, ...]:
        """Return up to `most` triggers that almost fit, the nearest first."""
        ...
