"""Reads the templates of hassil, in which brackets may continue a word: `light[s]`.

A template is kept letter by letter, spaces included: pieces.py finds its words.
"""

import re
from dataclasses import dataclass

DEEPEST = 12
LONGEST = 2_000

_PIECES = re.compile(r"\\.|\s+|[\[\]()|;{}<>]|[^\[\]()|;{}<>\s\\]+|\\")
_CLOSING = {"[": "]", "(": ")"}
_END = frozenset(("", "|", ";", "]", ")"))
_LIST = re.compile(r"@?[^\[\](){}<>|;@]+(:@?[^\[\](){}<>|;@]+)?")


class TemplateError(ValueError):
    """A template that cannot be read; `position` counts characters from 0."""

    def __init__(self, message: str, position: int) -> None:
        super().__init__(f"{message} at position {position}")
        self.message = message
        self.position = position


@dataclass(frozen=True, slots=True)
class Space:
    """Blanks between two words."""


@dataclass(frozen=True, slots=True)
class Text:
    """Letters without blanks; they may be a piece of a word."""

    text: str


@dataclass(frozen=True, slots=True)
class ListUse:
    """`{list}` or `{list:slot}`."""

    name: str
    slot: str


@dataclass(frozen=True, slots=True)
class RuleUse:
    """`<rule>`."""

    name: str
    position: int


@dataclass(frozen=True, slots=True)
class Group:
    """A choice; one that may be left out has an empty option. `rule` is where it comes from."""

    options: "tuple[Items, ...]"
    rule: str = ""


@dataclass(frozen=True, slots=True)
class Permutation:
    """`(a;b)`: all of them, in any order, as words of their own."""

    options: "tuple[Items, ...]"


Item = Space | Text | ListUse | RuleUse | Group | Permutation
Items = tuple[Item, ...]


class _Reader:
    def __init__(self, text: str) -> None:
        self.text = text
        self.pieces = [(found[0], found.start()) for found in _PIECES.finditer(text)]
        self.next = 0

    def peek(self) -> str:
        return self.pieces[self.next][0] if self.next < len(self.pieces) else ""

    def take(self) -> tuple[str, int]:
        if self.next == len(self.pieces):
            return "", len(self.text)
        self.next += 1
        return self.pieces[self.next - 1]


def parse_template(text: str) -> Items:
    """Read a template, or raise TemplateError; `|` and `;` may stand outside brackets."""
    if len(text) > LONGEST:
        raise TemplateError(f"Longer than {LONGEST} characters", LONGEST)
    reader = _Reader(text)
    items = _options(reader, 0, 0)
    rest, position = reader.take()
    if rest:
        raise TemplateError(f"Closing {rest!r} without an opening one", position)
    return items


def _options(reader: _Reader, depth: int, opened: int, *, optional: bool = False) -> Items:
    if depth > DEEPEST:
        raise TemplateError(f"Brackets deeper than {DEEPEST}", opened)
    options = [_items(reader, depth)]
    signs: set[str] = set()
    while reader.peek() in ("|", ";"):
        sign, position = reader.take()
        signs.add(sign)
        if len(signs) > 1:
            raise TemplateError("'|' and ';' in one pair of brackets", position)
        options.append(_items(reader, depth))
    whole = tuple(options)
    if ";" in signs:
        whole = ((Permutation(whole),),)
    if optional:
        return (Group(((), *whole)),)
    return whole[0] if len(whole) == 1 else (Group(whole),)


def _items(reader: _Reader, depth: int) -> Items:
    items: list[Item] = []
    while reader.peek() not in _END:
        items += _item(reader, depth)
    return tuple(items)


def _item(reader: _Reader, depth: int) -> Items:
    piece, position = reader.take()
    if piece in _CLOSING:
        return _bracket(reader, depth + 1, piece, position)
    if piece == "{":
        return (_list_use(_name(reader, "}", position), position),)
    if piece == "<":
        return (RuleUse(_name(reader, ">", position), position),)
    if piece in "}>":
        raise TemplateError(f"Closing {piece!r} without an opening one", position)
    return (_letters(piece),)


def _bracket(reader: _Reader, depth: int, opened: str, position: int) -> Items:
    items = _options(reader, depth, position, optional=opened == "[")
    closed, place = reader.take()
    if not closed:
        raise TemplateError(f"Open {opened!r} without {_CLOSING[opened]!r}", position)
    if closed != _CLOSING[opened]:
        raise TemplateError(f"{closed!r} closes {opened!r}", place)
    return items


def _letters(piece: str) -> Item:
    """Return blanks, letters, or for an escaped bracket a blank: it is never heard."""
    text = piece.removeprefix("\\") if len(piece) <= 2 else piece
    if piece.isspace() or (text != piece and not text.isalnum()):
        return Space()
    return Text(text)


def _name(reader: _Reader, closing: str, opened: int) -> str:
    name = ""
    while reader.peek() not in ("", closing):
        name += reader.take()[0]
    if not reader.take()[0]:
        raise TemplateError(f"An opening bracket without {closing!r}", opened)
    return name.strip()


def _list_use(name: str, position: int) -> ListUse:
    if not _LIST.fullmatch(name):
        raise TemplateError(f"{name!r} is no name of a list", position)
    listed, _, slot = name.partition(":")
    listed = listed.removeprefix("@")
    return ListUse(listed, slot.removeprefix("@") or listed)
