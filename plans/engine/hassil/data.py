"""What a file of hassil says, before it is converted."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType


@dataclass(frozen=True, slots=True)
class Template:
    """A template as its author typed it; `line` counts from 1, 0 where there is no file."""

    text: str
    line: int = 0
    file: str = ""


@dataclass(frozen=True, slots=True)
class ListValue:
    """A value of a list: what is said, and what it means."""

    said: Template
    meaning: str


@dataclass(frozen=True, slots=True)
class HassilList:
    """What may stand in `{name}`: listed values, a range of numbers, or any words."""

    values: tuple[ListValue, ...] = ()
    number: bool = False
    wildcard: bool = False


@dataclass(frozen=True, slots=True)
class Block:
    """Templates of an intent that share rules, lists and fixed slots."""

    templates: tuple[Template, ...]
    fixed: Mapping[str, str] = field(default_factory=lambda: MappingProxyType({}))
    rules: Mapping[str, Template] = field(default_factory=lambda: MappingProxyType({}))
    lists: Mapping[str, HassilList] = field(default_factory=lambda: MappingProxyType({}))
    in_context: bool = False


@dataclass(frozen=True, slots=True)
class HassilFile:
    """Intents with the rules and lists they refer to, of one language."""

    intents: Mapping[str, tuple[Block, ...]]
    rules: Mapping[str, Template] = field(default_factory=lambda: MappingProxyType({}))
    lists: Mapping[str, HassilList] = field(default_factory=lambda: MappingProxyType({}))
    skip_words: tuple[Template, ...] = ()


@dataclass(frozen=True, slots=True)
class HassilProblem:
    """A template that cannot be converted; `position` counts characters of it from 0."""

    where: str
    template: Template
    position: int
    message: str

    def __str__(self) -> str:
        """Return `on.yaml:7: HassTurnOn: Open '(' without ')' at position 3 of 'on (a'`."""
        place = f"{self.template.file}:{self.template.line}: " if self.template.file else ""
        text = self.template.text
        return f"{place}{self.where}: {self.message} at position {self.position} of {text!r}"
