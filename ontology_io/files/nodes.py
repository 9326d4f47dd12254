"""YAML as values that know their line, so that every error says where it is."""

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

import yaml

#: Far more than the format or an expert needs; what is beyond was not written by one.
DEEPEST, LONGEST_TEXT = 20, 2000
NO_ENTRY: Mapping[str, "Value"] = MappingProxyType({})

_CONTROL = re.compile(r"[\x00-\x08\x0b-\x1f\x7f\ud800-\udfff\ufffe\uffff]")
_LOADER = getattr(yaml, "CBaseLoader", yaml.BaseLoader)


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


Content = str | list["Value"] | tuple[tuple["Value", "Value"], ...]


@dataclass(frozen=True, slots=True)
class Value:
    """A value of a file, read as what the format expects there; wrong shapes are problems.

    `line` counts from 1; the value of a key stands at the line of its key.
    """

    content: Content
    line: int
    problems: Problems

    @property
    def is_text(self) -> bool:
        """Say whether this is a scalar."""
        return isinstance(self.content, str)

    def text(self, longest: int = LONGEST_TEXT) -> str:
        """Return a scalar as it is written: `no` and `12:30` are texts too."""
        if not isinstance(self.content, str):
            self.problems.add(self.line, "Write a text here, not a list or a mapping.")
            return ""
        if len(self.content) > longest:
            length = len(self.content)
            self.problems.add(self.line, f"This text has {length} characters; {longest} at most.")
        if _CONTROL.search(self.content):
            self.problems.add(self.line, "Remove the invisible control characters of this text.")
        return self.content

    def items(self) -> list["Value"]:
        """Return the values of a list; nothing written after the key is an empty one."""
        if isinstance(self.content, list):
            return self.content
        if self.content == "":
            return []
        self.problems.add(self.line, "Write a list here, e.g. [Tea, Milk].")
        return []

    def texts(self, longest: int = LONGEST_TEXT) -> tuple[str, ...]:
        """Return the texts of a list."""
        return tuple(item.text(longest) for item in self.items())

    def entries(self) -> dict[str, "Value"]:
        """Return the values of a mapping by key; a key written twice is a problem."""
        if self.content == "":
            return {}
        if not isinstance(self.content, tuple):
            self.problems.add(self.line, "Write a mapping here, e.g. {name: tea}.")
            return {}
        entries: dict[str, Value] = {}
        for key, value in self.content:
            name = key.text()
            if name in entries:
                self.problems.add(key.line, f"{name!r} stands here twice.")
            entries[name] = Value(value.content, key.line, self.problems)
        return entries

    def text_entries(self, longest: int = LONGEST_TEXT) -> dict[str, str]:
        """Return a mapping of texts."""
        return {key: value.text(longest) for key, value in self.entries().items()}

    def known_entries(self, allowed: frozenset[str]) -> dict[str, "Value"]:
        """Return a mapping's values; a key that is not allowed is a problem."""
        entries = self.entries()
        for key, value in entries.items():
            if key not in allowed:
                known = ", ".join(sorted(allowed))
                self.problems.add(value.line, f"{key!r} is not known here; use {known}.")
        return entries


def parse(text: str, problems: Problems, sections: Iterable[str]) -> Mapping[str, Value]:
    """Return the top entries of a file; a syntax error is one problem with its line."""
    try:
        root = _root(text, problems)
    except _RefusedError as error:
        problems.add(*error.args)
        return NO_ENTRY
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark
        problems.add(mark.line + 1 if mark else 1, f"This is no YAML: {error.problem}.")
        return NO_ENTRY
    except yaml.reader.ReaderError as error:
        line = text.encode()[: error.position].count(b"\n") + 1
        problems.add(line, "This is no YAML: an invisible control character stands here.")
        return NO_ENTRY
    return root.known_entries(frozenset(sections)) if root else NO_ENTRY


def _root(text: str, problems: Problems) -> Value | None:
    """Return the value of the whole file, None where there is none.

    Built from events, not by PyYAML's composer: that overflows the stack on a deep file.
    """
    opened: list[tuple[int, list[Value]]] = [(1, [])]
    for event in yaml.parse(text, Loader=_LOADER):
        line = event.start_mark.line + 1 if event.start_mark else 1
        _refuse(event, len(opened), line)
        if isinstance(event, yaml.ScalarEvent):
            opened[-1][1].append(Value(event.value, line, problems))
        elif isinstance(event, yaml.CollectionStartEvent):
            opened.append((line, []))
        elif isinstance(event, yaml.CollectionEndEvent):
            begun, values = opened.pop()
            in_pairs = isinstance(event, yaml.MappingEndEvent)
            content = tuple(zip(values[::2], values[1::2], strict=True)) if in_pairs else values
            opened[-1][1].append(Value(content, begun, problems))
    _, roots = opened[0]
    if len(roots) > 1:
        problems.add(roots[1].line, "Write one document in a file, without --- lines.")
    return roots[0] if roots else None


def _refuse(event: yaml.Event, depth: int, line: int) -> None:
    """Stop at what a file of content never holds and what could be used to exhaust memory."""
    if isinstance(event, yaml.NodeEvent) and event.anchor is not None:
        name = event.anchor
        raise _RefusedError(line, f"&{name} and *{name} cannot be used; write the text out.")
    if depth > DEEPEST:
        raise _RefusedError(line, f"Lists and mappings stand more than {DEEPEST} deep here.")


class _RefusedError(Exception):
    """What YAML allows and this format does not: the line, and why."""


def each(entries: Mapping[str, Value], key: str) -> Iterator[Value]:
    """Yield the items of a list that may be absent."""
    if key in entries:
        yield from entries[key].items()
