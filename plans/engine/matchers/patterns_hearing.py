"""What the passes over one sentence share, and what all of them know about the language."""

from dataclasses import dataclass

from plans.engine.matchers.matcher import Candidate
from plans.engine.matchers.patterns_index import TriggerIndex
from plans.engine.matchers.patterns_near import NearTriggers
from plans.engine.reading import Edges, Fillers, Reading
from plans.engine.slots import SlotWords
from plans.engine.templates import Template
from plans.engine.vocabulary import Vocabulary


@dataclass(frozen=True, slots=True)
class Knowledge:
    """The triggers and word lists of one language.

    `sounds` ("um") are never read at all; `fillers` ("you know") are left out where the sentence
    does not fit with them. `asides` are the fillers of several words, which begin or end no name
    ("you know", where "just" may), so that they are cut off free words. `near` is for languages
    without spaces, where an error is no unknown word.
    """

    spaced: bool
    index: TriggerIndex
    near: NearTriggers | None
    vocabulary: Vocabulary
    edges: Edges
    sounds: Fillers
    fillers: Fillers
    asides: Fillers
    slot_words: SlotWords


@dataclass(frozen=True, slots=True)
class Spelt:
    """A candidate found by mending the spelling; `acts` where the rest of the sentence is proof."""

    candidate: Candidate
    acts: bool


@dataclass(slots=True)
class Hearing:
    """One sentence: its reading, its index keys, the triggers whose words are all in it."""

    reading: Reading
    keys: frozenset[str]
    possible: list[Template]
    spelt: tuple[Spelt, ...] | None = None
