"""YAML as entries that know their line, so that every error says where it is."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

import yaml

NO_ENTRY: Mapping[str, "Value"] = MappingProxyType({})


@dataclass(frozen=True, slots=True)
class Problem:
    """One thing wrong in a file: where it is and what to do."""

    file: str
    line: int
    message: str

    def __str__(self) -> str:
        return f"{self.file}:{self.line}: {self.message}"


class ContentError(ValueError):
    """Files that cannot be read; `problems` are all that were found."""

    def __init__(self, problems: list[Problem]) -> None:
        super().__init__("\n".join(map(str, problems)))
        self.problems = problems


@dataclass(slots=True)
class Problems:
    """Collects what is wrong in one file."""

    file: str
    found: list[Problem] = field(default_factory=list)

    def add(self, line: int, message: str) -> None:
        """Remember a problem at a line (counted from 1)."""
        self.found.append(Problem(self.file, line, message))


@dataclass(frozen=True, slots=True)
class Value:
    """A node of a file, read as what the format expects there; wrong shapes are problems."""

    node: yaml.Node
    problems: Problems

    @property
    def line(self) -> int:
        """Return the line the value begins on, counted from 1."""
        return int(self.node.start_mark.line) + 1

    @property
    def is_text(self) -> bool:
        """Say whether this is a scalar."""
        return isinstance(self.node, yaml.ScalarNode)

    def text(self) -> str:
        """Return a scalar as it is written: `no` and `12:30` are texts too."""
        if isinstance(self.node, yaml.ScalarNode):
            return str(self.node.value)
        self.problems.add(self.line, "Write a text here, not a list or a mapping.")
        return ""

    def items(self) -> list["Value"]:
        """Return the values of a list."""
        if isinstance(self.node, yaml.SequenceNode):
            return [Value(node, self.problems) for node in self.node.value]
        self.problems.add(self.line, "Write a list here, e.g. [Tea, Milk].")
        return []

    def texts(self) -> tuple[str, ...]:
        """Return the texts of a list."""
        return tuple(item.text() for item in self.items())

    def entries(self) -> dict[str, "Value"]:
        """Return the values of a mapping by key; a key written twice is a problem."""
        if not isinstance(self.node, yaml.MappingNode):
            self.problems.add(self.line, "Write a mapping here, e.g. {name: tea}.")
            return {}
        entries: dict[str, Value] = {}
        for key, node in self.node.value:
            name = str(key.value)
            if name in entries:
                self.problems.add(key.start_mark.line + 1, f"{name!r} stands here twice.")
            entries[name] = Value(node, self.problems)
        return entries

    def text_entries(self) -> dict[str, str]:
        """Return a mapping of texts."""
        return {key: value.text() for key, value in self.entries().items()}

    def known_entries(self, allowed: frozenset[str]) -> dict[str, "Value"]:
        """Return a mapping's values; a key that is not allowed is a problem."""
        entries = self.entries()
        for key in entries.keys() - allowed:
            self.problems.add(
                entries[key].line, f"{key!r} is not known here; use {', '.join(sorted(allowed))}."
            )
        return entries


def parse(text: str, problems: Problems) -> Mapping[str, Value]:
    """Return the top entries of a file; a syntax error is one problem with its line."""
    try:
        node = yaml.compose(text, Loader=_LOADER)
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark
        problems.add(mark.line + 1 if mark else 1, f"This is no YAML: {error.problem}.")
        return NO_ENTRY
    except yaml.YAMLError as error:
        problems.add(1, f"This is no YAML: {error}.")
        return NO_ENTRY
    return Value(node, problems).entries() if node is not None else NO_ENTRY


def each(entries: Mapping[str, Value], key: str) -> Iterator[Value]:
    """Yield the items of a list that may be absent."""
    if key in entries:
        yield from entries[key].items()


_LOADER = getattr(yaml, "CBaseLoader", yaml.BaseLoader)
