"""The shape of a language: words, folding, name forms, yes/no, and the person's words returned.

Nothing here knows a particular language: english.py, italian.py and japanese.py do.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum
from types import MappingProxyType
from typing import Protocol

import msgspec


class Token(msgspec.Struct, frozen=True, gc=False):
    """One word of a sentence.

    `text` is normalised (NFKC, casefold); `sentence[start:end]` is the person's own spelling.
    A Struct, not a dataclass: a turn makes hundreds, and a Struct is made five times faster.
    """

    text: str
    start: int
    end: int


class Attitude(Enum):
    """What the answer to a yes/no question says about the person's attitude."""

    YES_STRONG = "yes, strongly"
    YES = "yes"
    A_LITTLE = "a little"
    DEPENDS = "it depends"
    NOT_REALLY = "not really"
    NO = "no"
    NO_STRONG = "no, strongly"
    UNCLEAR = "no answer heard"


@dataclass(frozen=True, slots=True)
class NameForms:
    """The forms of one name; `forms[""]` is `$hasName`, `forms["di"]` is `$hasName.di`.

    A form that does not exist is absent: a sentence that asks for it cannot be said of this topic.
    """

    forms: Mapping[str, str]
    plural: bool = False
    feminine: bool = False

    def __post_init__(self) -> None:
        object.__setattr__(self, "forms", MappingProxyType(dict(self.forms)))


class FormError(ValueError):
    """A name whose fields are wrong; `field` is where, `hint` what to write instead."""

    def __init__(self, field: str, message: str, hint: str) -> None:
        super().__init__(f"{field}: {message} {hint}")
        self.field = field
        self.message = message
        self.hint = hint


class Language(Protocol):
    """All that the rest of the service asks of a language."""

    @property
    def code(self) -> str:
        """Return the short code, "en"."""

    @property
    def tag(self) -> str:
        """Return the BCP 47 tag for speech, "en-GB"."""

    @property
    def own_name(self) -> str:
        """Return the language's name in itself, "English"."""

    @property
    def spaced(self) -> bool:
        """Say whether words are separated by spaces."""

    @property
    def form_names(self) -> frozenset[str]:
        """Return the forms `$hasName` may be asked for; the plain form "" is not in it."""

    @property
    def name_fields(self) -> frozenset[str]:
        """Return the fields an author may write in a name: name, n, bare."""

    def tokens(self, sentence: str) -> tuple[Token, ...]:
        """Return the words of a sentence; case, width and punctuation are gone."""

    def inflections(self, word: str) -> frozenset[str]:
        """Return the regular forms of one normalised word, itself included: dog, dogs."""

    def name_forms(self, fields: Mapping[str, str]) -> NameForms:
        """Return every form of a name, or raise FormError where a field is wrong."""

    def attitude(self, sentence: str) -> Attitude:
        """Return what the answer to a yes/no question says; UNCLEAR where it is no answer."""

    def their_words(self, words: str) -> str:
        """Return the person's words as the agent says them: "my wife" becomes "your wife"."""

    def asks(self, sentence: str) -> bool:
        """Say whether the sentence is a question."""

    def listed(self, names: tuple[str, ...]) -> str:
        """Return names as a choice: "tea, the piano or Rome"."""

    def fold(self, text: str) -> str:
        """Return the text for a second look-up: without accents, so `caffe` finds `caffè`."""
