"""The kinds of sentence the agent can say about a topic, one row each (paper, "Dialogue Tree")."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple


class SentenceType(NamedTuple):
    """One kind of sentence: its letter in patterns, its OWL property, whether it ends a turn."""

    letter: str
    name: str
    owl_property: str
    ends_turn: bool
    asks: bool


_TABLE = (
    SentenceType("q", "yes/no question", "hasQuestion", ends_turn=True, asks=True),
    SentenceType("p", "positive assertion", "hasPositiveSentence", ends_turn=False, asks=False),
    SentenceType("n", "negative assertion", "hasNegativeSentence", ends_turn=False, asks=False),
    SentenceType("w", "open question", "hasPositiveAndWait", ends_turn=True, asks=True),
    SentenceType("c", "contextual remark", "hasQuestionContextual", ends_turn=True, asks=False),
    SentenceType("g", "activity proposal", "hasQuestionGoal", ends_turn=True, asks=True),
    SentenceType("t", "transition", "hasTransition", ends_turn=False, asks=False),
    SentenceType("e", "hands the initiative over", "hasInitiative", ends_turn=True, asks=True),
)

SENTENCE_TYPES: Mapping[str, SentenceType] = MappingProxyType({row.letter: row for row in _TABLE})

#: In patterns `r` stands for the reaction: p or n, whichever the answer to the q asks for.
REACTION = "r"

PATTERN_LETTERS = frozenset(SENTENCE_TYPES) | {REACTION}
