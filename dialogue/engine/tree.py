"""The Dialogue Tree: topics with all they can say, immutable, for every culture and language.

Subclasses become children, hasTopic becomes a link; sentences are inherited down the classes
(paper, "Dialogue Tree").
"""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from languages.language import NameForms
from languages.templates import Template

#: The topic that holds what the agent says when the person talks about something unknown.
ON_YOUR_MIND = "OnYourMind"


@dataclass(frozen=True, slots=True)
class Proposal:
    """The activity a g sentence offers: an intent and its parameters as templates a language."""

    intent: str
    parameters: tuple[tuple[str, Mapping[str, Template]], ...]


@dataclass(frozen=True, slots=True)
class Line:
    """One frame, compiled: what can be said, where, and for whom. `owner` 0 means a pool."""

    number: int
    key: str
    type: str
    slot: int
    owner: int
    only: frozenset[str]
    scope: str
    templates: Mapping[str, Template]
    proposal: Proposal | None = None

    def fits(self, language: str, culture: str) -> bool:
        """Say whether the line can be said in this language to people of this culture."""
        return language in self.templates and (not self.only or culture in self.only)


#: The group of relatives and friends: who speaks of theirs is listened to.
PEOPLE = "People"

#: A pattern: sentence types in order, each with whether it may be left out.
Pattern = tuple[tuple[str, bool], ...]
Lines = Mapping[str, tuple[Line, ...]]


@dataclass(frozen=True, slots=True)
class Node:
    """One topic of the tree. Topics are named by number; `parent` 0 is the root."""

    number: int
    key: str
    parent: int
    children: tuple[int, ...]
    links: tuple[int, ...]
    ancestors: tuple[int, ...]
    gentle: bool
    patterns: tuple[Pattern, ...]
    likeliness: Mapping[str, float]
    names: Mapping[str, NameForms]
    variables: Mapping[str, Mapping[str, str]]
    lines: Lines

    @property
    def branch(self) -> int:
        """Return the branch (the topic directly below the root) this topic belongs to."""
        return self.ancestors[-1] if self.ancestors else self.number

    @property
    def is_leaf(self) -> bool:
        """Say whether nothing is more special than this topic."""
        return not self.children


@dataclass(frozen=True, slots=True)
class Tree:
    """All topics by number and by key, the branches, and the pools."""

    nodes: Mapping[int, Node]
    by_key: Mapping[str, Node]
    branches: tuple[int, ...]
    pools: Mapping[str, tuple[Line, ...]]
    lines: Mapping[int, Line]

    def node(self, number: int) -> Node | None:
        """Return the topic of this number, or None where it is gone."""
        return self.nodes.get(number)

    def siblings(self, node: Node) -> tuple[int, ...]:
        """Return the other children of the topic's parent."""
        around = self.nodes[node.parent].children if node.parent else self.branches
        return tuple([number for number in around if number != node.number])

    def is_same_or_below(self, number: int, above: int) -> bool:
        """Say whether the first topic is the second one or lies below it."""
        node = self.nodes.get(number)
        return number == above or (node is not None and above in node.ancestors)


EMPTY_LINES: Lines = MappingProxyType({})
