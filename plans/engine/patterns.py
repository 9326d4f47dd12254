"""The grammar of trigger sentences: `(play|put on) [the song] {title}`.

Words stand for themselves, `[x]` may be left out, `(a|b)` and `[a|b]` offer a choice, `<x>` is a
phrase of the library and `{x}` a slot. In languages with spaces a bracket always starts a new word.
"""

import re
from collections.abc import Callable, Container, Iterator, Mapping
from dataclasses import dataclass
from functools import reduce
from random import Random

DEEPEST = 4
LONGEST = 600

_PIECES = re.compile(r"[\[\]()|{}<>]|[^\[\]()|{}<>\s]+")
_NAME = re.compile(r"[a-z][a-z0-9_]*")
_CLOSING = {"[": "]", "(": ")"}
_REFERENCES = {"{": "}", "<": ">"}


class PatternError(ValueError):
    """A trigger that cannot be read; `position` counts characters from 0."""

    def __init__(self, message: str, *, position: int, text: str) -> None:
        super().__init__(f"{message} at position {position} of {text!r}")
        self.message = message
        self.position = position
        self.text = text


@dataclass(frozen=True, slots=True)
class Word:
    """Text that stands for itself, as the author typed it, without blanks."""

    text: str


@dataclass(frozen=True, slots=True)
class SlotUse:
    """A `{name}`."""

    name: str


@dataclass(frozen=True, slots=True)
class PhraseUse:
    """A `<name>`."""

    name: str


@dataclass(frozen=True, slots=True)
class Choice:
    """`(a|b)`, or `[a|b]` where `optional`."""

    options: "tuple[Sequence, ...]"
    optional: bool


Part = Word | SlotUse | PhraseUse | Choice


@dataclass(frozen=True, slots=True)
class Sequence:
    """Parts one after another; a whole trigger is a sequence."""

    parts: tuple[Part, ...]


@dataclass(frozen=True, slots=True)
class _Piece:
    text: str
    position: int


class _Reader:
    """Reads pieces from left to right; every error knows its place."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.pieces = [_Piece(found[0], found.start()) for found in _PIECES.finditer(text)]
        self.next = 0

    def peek(self) -> str:
        """Return the next piece, or "" at the end."""
        return self.pieces[self.next].text if self.next < len(self.pieces) else ""

    def take(self) -> _Piece:
        """Return the next piece and move on; at the end an empty piece."""
        if self.next == len(self.pieces):
            return _Piece("", len(self.text))
        self.next += 1
        return self.pieces[self.next - 1]

    def error(self, message: str, position: int) -> PatternError:
        """Return an error at a position of this text."""
        return PatternError(message, position=position, text=self.text)


def parse_pattern(text: str) -> Sequence:
    """Read a trigger, or raise PatternError with the exact position."""
    reader = _Reader(text)
    if len(text) > LONGEST:
        raise reader.error(f"Longer than {LONGEST} characters", LONGEST)
    sequence = _sequence(reader, 0)
    rest = reader.take()
    if rest.text == "|":
        raise reader.error("A '|' outside brackets", rest.position)
    if rest.text:
        raise reader.error(f"Closing {rest.text!r} without an opening one", rest.position)
    if not sequence.parts:
        raise reader.error("Nothing is written", 0)
    return sequence


def parse_options(text: str) -> Sequence:
    """Read a phrase, where `|` may stand outside brackets: `please|could you`."""
    try:
        return parse_pattern(f"({text})")
    except PatternError as error:
        place = min(max(error.position - 1, 0), len(text))
        raise PatternError(error.message, position=place, text=text) from error


def _sequence(reader: _Reader, depth: int) -> Sequence:
    parts: list[Part] = []
    while reader.peek() not in ("", "|", "]", ")", "}", ">"):
        parts.append(_part(reader, depth))
    return Sequence(tuple(parts))


def _part(reader: _Reader, depth: int) -> Part:
    piece = reader.take()
    if piece.text in _CLOSING:
        return _choice(reader, piece, depth + 1)
    if piece.text in _REFERENCES:
        return _reference(reader, piece)
    return Word(piece.text)


def _choice(reader: _Reader, opened: _Piece, depth: int) -> Choice:
    if depth > DEEPEST:
        raise reader.error(f"Brackets deeper than {DEEPEST}", opened.position)
    options: list[Sequence] = []
    while not options or reader.peek() == "|":
        if options:
            reader.take()
        before = reader.peek()
        options.append(_sequence(reader, depth))
        if not options[-1].parts and before in ("|", _CLOSING[opened.text]):
            place = reader.take().position
            raise reader.error("An empty choice", place)
    closed = reader.take()
    if not closed.text:
        raise reader.error(
            f"Open {opened.text!r} without {_CLOSING[opened.text]!r}", opened.position
        )
    if closed.text != _CLOSING[opened.text]:
        raise reader.error(f"{closed.text!r} closes {opened.text!r}", closed.position)
    return Choice(tuple(options), optional=opened.text == "[")


def _reference(reader: _Reader, opened: _Piece) -> SlotUse | PhraseUse:
    closing = _REFERENCES[opened.text]
    name = reader.take()
    if not _NAME.fullmatch(name.text):
        if closing not in reader.text[opened.position :]:
            raise reader.error(f"Open {opened.text!r} without {closing!r}", opened.position)
        raise reader.error("A name is small letters, digits and '_'", name.position)
    if reader.take().text != closing:
        raise reader.error(f"Open {opened.text!r} without {closing!r}", opened.position)
    return SlotUse(name.text) if opened.text == "{" else PhraseUse(name.text)


def print_pattern(sequence: Sequence) -> str:
    """Return the canonical text; reading it again gives the same sequence."""
    return " ".join(_print_part(part) for part in sequence.parts)


def _print_part(part: Part) -> str:
    if isinstance(part, Word):
        return part.text
    if isinstance(part, SlotUse):
        return f"{{{part.name}}}"
    if isinstance(part, PhraseUse):
        return f"<{part.name}>"
    options = "|".join(print_pattern(option) for option in part.options)
    return f"[{options}]" if part.optional else f"({options})"


def parts_of(sequence: Sequence) -> Iterator[Part]:
    """Yield every part, also those inside brackets; phrases are not entered."""
    for part in sequence.parts:
        yield part
        if isinstance(part, Choice):
            for option in part.options:
                yield from parts_of(option)


def expansions(sequence: Sequence, phrases: Mapping[str, Sequence]) -> int:
    """Return how many different wordings a trigger stands for (a slot counts once)."""
    return reduce(lambda total, part: total * _ways(part, phrases), sequence.parts, 1)


def _ways(part: Part, phrases: Mapping[str, Sequence]) -> int:
    if isinstance(part, PhraseUse):
        return expansions(phrases[part.name], phrases)
    if isinstance(part, Choice):
        return sum(expansions(option, phrases) for option in part.options) + part.optional
    return 1


def always_literal(
    sequence: Sequence, phrases: Mapping[str, Sequence], listed: Container[str] = ()
) -> bool:
    """Say whether every wording contains words that are known beforehand.

    They are its own or those of a value list; `listed` names the slots that have one.
    """
    return any(_part_literal(part, phrases, listed) for part in sequence.parts)


def _part_literal(part: Part, phrases: Mapping[str, Sequence], listed: Container[str]) -> bool:
    if isinstance(part, PhraseUse):
        return always_literal(phrases[part.name], phrases, listed)
    if isinstance(part, Choice):
        inner = (always_literal(option, phrases, listed) for option in part.options)
        return not part.optional and all(inner)
    return isinstance(part, Word) or part.name in listed


def sample(
    sequence: Sequence,
    chance: Random,
    phrases: Mapping[str, Sequence],
    value: Callable[[str], str],
) -> list[str]:
    """Return the words of one possible sentence; `value` gives the words of a slot."""
    words: list[str] = []
    for part in sequence.parts:
        words += _sample_part(part, chance, phrases, value)
    return words


def _sample_part(
    part: Part,
    chance: Random,
    phrases: Mapping[str, Sequence],
    value: Callable[[str], str],
) -> list[str]:
    if isinstance(part, Word):
        return [part.text]
    if isinstance(part, SlotUse):
        return [value(part.name)]
    if isinstance(part, PhraseUse):
        return sample(phrases[part.name], chance, phrases, value)
    if part.optional and chance.random() < 0.5:
        return []
    return sample(chance.choice(part.options), chance, phrases, value)
