"""Sentence texts with gaps: "Ti {piace|piacciono} $hasName?" compiled once, filled in microseconds.

`$hasName.di` is a form of the topic's name, `$unit` an inherited variable, `{is|are}` agrees with
`$hasName`, `{o|a|i|e}` (Italian) too: masculine, feminine, plural masculine, plural feminine.
"""

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import lru_cache

from languages.known import LANGUAGES
from languages.language import NameForms

#: Variables that stand for a name; a switch agrees with the first.
NAMES = ("hasName", "toName")
#: Placeholders of the clients; they pass through untouched.
CLIENT_PLACEHOLDERS = frozenset({"name", "desspk", "prevspk"})

Names = Mapping[str, NameForms]
Variables = Mapping[str, str]
Part = str | Callable[[Names, Variables], str]

_PIECES = re.compile(
    r"\$(?P<variable>[A-Za-z][A-Za-z0-9_]*)(?:\.(?P<form>[A-Za-z][A-Za-z0-9_]*))?"
    r"|\{(?P<switch>[^{}$]*)\}"
    r"|(?P<text>[^${}|]+)"
)
_STARTS = re.compile(r"(?:^|(?<!\.)[.!?][\"'”’»)]*\s)[\"'“‘«(¿¡\s]*", re.MULTILINE)


class TemplateError(ValueError):
    """A text that cannot be compiled or filled; `position` counts characters from 0."""

    def __init__(self, message: str, *, position: int, text: str) -> None:
        super().__init__(f"{message} At position {position} of {text!r}.")
        self.message = message
        self.position = position
        self.text = text


@dataclass(frozen=True, slots=True)
class Template:
    """A compiled text; `variables` names its gaps: {"hasName.di", "unit"}."""

    text: str
    variables: frozenset[str]
    _parts: tuple[Part, ...] = field(repr=False)

    def fill(self, names: Names, variables: Variables) -> str:
        """Return the sentence; TemplateError where a form or a variable is missing.

        A variable's own text may hold `$hasName` in turn: {"when": "during $hasName"}.
        """
        return "".join(
            [part if isinstance(part, str) else part(names, variables) for part in self._parts]
        )


@lru_cache(maxsize=4096)
def compile_template(text: str, language: str, *, sentence: bool = True) -> Template:
    """Return the compiled text, or raise TemplateError with the position of what is wrong.

    `sentence=False` is for parts of speech and for `do` lines: nothing gets a capital.
    """
    return _Compiler(text, language, capitals=sentence and language != "ja").template()


@dataclass(frozen=True, slots=True)
class _Place:
    """Where a gap stands; all that is needed to fill it or to say what is missing."""

    text: str
    position: int
    language: str
    capital: bool

    def missing(self, message: str) -> TemplateError:
        return TemplateError(message, position=self.position, text=self.text)


class _Compiler:
    def __init__(self, text: str, language: str, *, capitals: bool) -> None:
        self.text = text
        self.language = language
        self.form_names = LANGUAGES[language].form_names
        self.starts = _sentence_starts(text) if capitals else frozenset()
        self.variables: set[str] = set()

    def template(self) -> Template:
        if not self.text.strip():
            raise self._error("The text is empty.", 0)
        parts = tuple(_without_seams(self._parts()))
        return Template(self.text, frozenset(self.variables), parts)

    def _parts(self) -> Iterator[Part]:
        position = 0
        while position < len(self.text):
            piece = _PIECES.match(self.text, position)
            if piece is None:
                raise self._error(_why_unreadable(self.text, position), position)
            yield self._part(piece)
            position = piece.end()

    def _part(self, piece: re.Match[str]) -> Part:
        position = piece.start()
        if piece["text"] is not None:
            return self._literal(piece["text"], position)
        if piece["switch"] is not None:
            return self._switch(piece["switch"].split("|"), position)
        if piece["variable"] in NAMES:
            return self._name(piece["variable"], piece["form"] or "", position)
        if piece["form"]:
            raise self._error(f"${piece['variable']} has no forms.", position)
        if piece["variable"] in CLIENT_PLACEHOLDERS:
            return piece.group()
        self.variables.add(piece["variable"])
        return _variable_part(piece["variable"], self._place(position))

    def _literal(self, text: str, position: int) -> str:
        for start in sorted(self.starts, reverse=True):
            at = start - position
            if 0 <= at < len(text):
                text = text[:at] + capital(text[at:])
        return text

    def _name(self, name: str, form: str, position: int) -> Part:
        if form and form not in self.form_names:
            known = ", ".join(f".{known}" for known in sorted(self.form_names))
            raise self._error(f"${name}.{form} is no form; use one of {known}.", position)
        self.variables.add(f"{name}.{form}" if form else name)
        return _name_part(name, form, self._place(position))

    def _switch(self, options: list[str], position: int) -> Part:
        allowed = {"en": (2,), "it": (2, 4), "ja": ()}[self.language]
        if len(options) not in allowed:
            raise self._error(_why_no_switch(len(options), allowed), position)
        self.variables.add(NAMES[0])
        if position in self.starts:
            options = [capital(option) for option in options]
        return _switch_part(options, self._place(position))

    def _place(self, position: int) -> _Place:
        return _Place(self.text, position, self.language, position in self.starts)

    def _error(self, message: str, position: int) -> TemplateError:
        return TemplateError(message, position=position, text=self.text)


def capital(text: str) -> str:
    """Return text with its first character as a capital, the rest untouched."""
    return text[:1].upper() + text[1:]


def _sentence_starts(text: str) -> frozenset[int]:
    return frozenset(found.end() for found in _STARTS.finditer(text))


def _without_seams(parts: Iterator[Part]) -> Iterator[Part]:
    """Join neighbouring literals, so that filling has fewer pieces to put together."""
    literal = ""
    for part in parts:
        if isinstance(part, str):
            literal += part
            continue
        if literal:
            yield literal
        literal = ""
        yield part
    if literal:
        yield literal


def _why_unreadable(text: str, position: int) -> str:
    reasons = {
        "$": "'$' without the name of a variable.",
        "{": "'{' without '}', or with a variable or another '{' inside.",
        "}": "'}' without '{'.",
        "|": "'|' outside of '{...}'.",
    }
    return reasons[text[position]]


def _why_no_switch(count: int, allowed: tuple[int, ...]) -> str:
    if not allowed:
        return "A switch {...|...} is not used in Japanese."
    wanted = " or ".join(str(number) for number in allowed)
    return f"A switch with {count} options; it takes {wanted}."


def _name_part(name: str, form: str, place: _Place) -> Part:
    shown = f"${name}.{form}" if form else f"${name}"

    def say(names: Names, _variables: Variables) -> str:
        try:
            said = names[name].forms[form]
        except KeyError:
            raise place.missing(f"This topic has no {shown}.") from None
        return capital(said) if place.capital else said

    return say


def _variable_part(variable: str, place: _Place) -> Part:
    def say(names: Names, variables: Variables) -> str:
        try:
            said = variables[variable]
        except KeyError:
            raise place.missing(f"The variable ${variable} has no value here.") from None
        if "$" in said or "{" in said:
            # Names only: a variable inside a variable inside … could go round in circles.
            said = compile_template(said, place.language, sentence=False).fill(names, {})
        return capital(said) if place.capital else said

    return say


def _switch_part(options: list[str], place: _Place) -> Part:
    by_number = len(options) == 2

    def say(names: Names, _variables: Variables) -> str:
        try:
            name = names[NAMES[0]]
        except KeyError:
            raise place.missing("A switch needs $hasName.") from None
        if by_number:
            return options[name.plural]
        return options[2 * name.plural + name.feminine]

    return say
