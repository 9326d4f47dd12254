"""What people say when they answer a yes/no question, phrase by phrase, and where it was said.

A language lists its phrases by meaning; `find_marks` finds them in a sentence, longest first.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from enum import Enum, auto

import msgspec

from languages.language import Token


class Says(Enum):
    """What one phrase contributes to an answer."""

    LOVE = auto()  # opinions: heard anywhere in the sentence
    LIKE = auto()
    MILD = auto()  # "I don't mind it"
    DISLIKE = auto()
    HATE = auto()
    DEPENDS = auto()  # "it depends": anywhere
    YES = auto()  # particles: at the head, alone between commas, or in a short answer
    NO = auto()
    SURE = auto()  # "of course"
    NEVER = auto()  # "not at all"
    MEH = auto()  # "not really"
    ECHO = auto()  # "I do", "I have": yes where the clause ends there
    GOOD = auto()  # the rest alone counts in short answers only
    BAD = auto()
    VERY = auto()
    BIT = auto()
    SOMETIMES = auto()
    NOT = auto()
    NOT_NOT = auto()  # "not that I don't"
    THEIRS = auto()  # "she likes": somebody else's opinion
    BUT = auto()
    ASIDE = auto()  # says nothing; keeps "no idea" from being a "no"


OPINIONS = frozenset({Says.LOVE, Says.LIKE, Says.MILD, Says.DISLIKE, Says.HATE})


@dataclass(frozen=True, slots=True)
class Phrases:
    """What each phrase says, and how long the phrases are that begin with a word, longest first."""

    says: Mapping[tuple[str, ...], Says]
    lengths: Mapping[str, tuple[int, ...]]


class Mark(msgspec.Struct, frozen=True, gc=False):
    """A phrase found at words `start` to `end` (exclusive)."""

    says: Says
    start: int
    end: int


@dataclass(frozen=True, slots=True)
class AnswerBook:
    """All phrases of a language, and the little grammar needed to read them."""

    phrases: Phrases
    #: With subjects: "like" needs one of `selves` before it, and none of `others`.
    selves: frozenset[str] = frozenset()
    others: frozenset[str] = frozenset()
    #: What an opinion about the topic asked is followed by: "I love it", not "I love coffee".
    pronouns: frozenset[str] = frozenset()
    #: Particles that are often something else: Italian "si", Japanese うん in うんどう.
    doubtful: frozenset[str] = frozenset()
    objects_first: bool = False
    #: How many words we do not know a short answer may have.
    slack: int = 4
    #: The same where nothing but "very", "a bit", "lovely" was said.
    slack_of_weak: int = 2


def make_phrases(
    texts: Mapping[Says, str],
    tokens: Callable[[str], Sequence[Token]],
    fold: Callable[[str], str],
) -> Phrases:
    """Return the phrases of a language; `texts` separates them by `|`.

    Each is listed without accents too, unless another phrase is spelt so already.
    """
    found: dict[tuple[str, ...], Says] = {}
    folded: dict[tuple[str, ...], Says] = {}
    for says, text in texts.items():
        for phrase in text.split("|"):
            words = tuple(token.text for token in tokens(phrase))
            found[words] = says
            folded[tuple(fold(word) for word in words)] = says
    says_by_words = folded | found
    lengths: dict[str, set[int]] = {}
    for words in says_by_words:
        lengths.setdefault(words[0], set()).add(len(words))
    longest_first = {first: tuple(sorted(some, reverse=True)) for first, some in lengths.items()}
    return Phrases(says_by_words, longest_first)


@dataclass(frozen=True, slots=True)
class Heard:
    """A sentence with its marks; `breaks`: words after a comma or stop, `known`: words in marks."""

    words: tuple[str, ...]
    breaks: frozenset[int]
    marks: tuple[Mark, ...]
    known: frozenset[int]

    @property
    def unknown(self) -> int:
        """Return how many words are in no mark."""
        return len(self.words) - len(self.known)

    def ends_clause(self, position: int) -> bool:
        """Say whether a clause ends before the word at `position`."""
        return position == len(self.words) or position in self.breaks


def find_marks(
    words: tuple[str, ...], breaks: frozenset[int], phrases: Phrases
) -> tuple[Mark, ...]:
    """Return the phrases of a sentence from left to right; none overlaps another."""
    marks: list[Mark] = []
    position = 0
    while position < len(words):
        mark = _mark_at(words, position, breaks, phrases)
        if mark:
            marks.append(mark)
        position = mark.end if mark else position + 1
    return tuple(marks)


def _mark_at(
    words: tuple[str, ...], position: int, breaks: frozenset[int], phrases: Phrases
) -> Mark | None:
    for length in phrases.lengths.get(words[position], ()):
        end = min(position + length, len(words))
        says = phrases.says.get(words[position:end])
        # "I have" answers, "I have a dog" does not.
        if says and (says is not Says.ECHO or end == len(words) or end in breaks):
            return Mark(says, position, end)
    return None


_LONGEST = 200
_STOPS = frozenset(",.;:!?、。！？，．…—–\n")


def hear(sentence: str, tokens: Sequence[Token], book: AnswerBook) -> Heard:
    """Return the sentence as marks; only the first 200 words can hold an answer."""
    tokens = tokens[:_LONGEST]
    words = tuple([token.text for token in tokens])
    breaks = frozenset(
        position
        for position in range(1, len(tokens))
        if not _STOPS.isdisjoint(sentence[tokens[position - 1].end : tokens[position].start])
    ) | {0}
    marks = find_marks(words, breaks, book.phrases)
    known = frozenset(position for mark in marks for position in range(mark.start, mark.end))
    return Heard(words, breaks, marks, known)
