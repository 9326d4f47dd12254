"""Build the Dialogue Tree from a knowledge base."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from types import MappingProxyType

from dialogue.engine.concepts import ROOT, Frame, Knowledge, Topic
from dialogue.engine.lines import compile_line
from dialogue.engine.patterns import DEFAULT_PATTERN, parse_patterns
from dialogue.engine.tree import EMPTY_LINES, Line, Lines, Node, Pattern, Tree
from languages.known import LANGUAGES
from languages.language import NameForms


@dataclass(frozen=True, slots=True)
class _Inherited:
    """What a topic hands down to the topics below it."""

    lines: Lines
    patterns: tuple[Pattern, ...]
    variables: Mapping[str, Mapping[str, str]]
    gentle: bool = False


_Waiting = tuple[Topic, _Inherited, tuple[int, ...]]
_FROM_ROOT = _Inherited(EMPTY_LINES, (DEFAULT_PATTERN,), MappingProxyType({}))


def build_tree(knowledge: Knowledge) -> Tree:
    """Return the tree of a checked knowledge base.

    Raises ValueError (FormError, TemplateError) where a name or a sentence is wrong: run the
    checks first, they collect all such problems.
    """
    return _Builder(knowledge).build()


class _Builder:
    """Walks the topics from the root down, once."""

    def __init__(self, knowledge: Knowledge) -> None:
        self.knowledge = knowledge
        self.topics = {topic.key: topic for topic in knowledge.topics}
        self.below: dict[str, list[Topic]] = {}
        for topic in knowledge.topics:
            self.below.setdefault(topic.is_a, []).append(topic)
        self.own: dict[str, tuple[Line, ...]] = {}
        self.nodes: dict[int, Node] = {}

    def build(self) -> Tree:
        for topic in self.knowledge.topics:
            self.own[topic.key] = _compiled(topic.frames, topic.number)
        waiting: list[_Waiting] = [
            (topic, _FROM_ROOT, ()) for topic in reversed(self.below.get(ROOT, []))
        ]
        while waiting:
            topic, inherited, ancestors = waiting.pop()
            handed_down = self._add(topic, inherited, ancestors)
            above = (topic.number, *ancestors)
            waiting.extend((child, handed_down, above) for child in self._children(topic)[::-1])
        pools = {name: _compiled(frames, 0) for name, frames in self.knowledge.pools.items()}
        everything = [line for lines in (*self.own.values(), *pools.values()) for line in lines]
        return Tree(
            nodes=MappingProxyType(self.nodes),
            by_key=MappingProxyType({node.key: node for node in self.nodes.values()}),
            branches=tuple(topic.number for topic in self.below.get(ROOT, [])),
            pools=MappingProxyType(pools),
            lines=MappingProxyType({line.number: line for line in everything}),
        )

    def _children(self, topic: Topic) -> list[Topic]:
        return self.below.get(topic.key, [])

    def _add(self, topic: Topic, inherited: _Inherited, ancestors: tuple[int, ...]) -> _Inherited:
        own = self.own[topic.key]
        from_above = _without(inherited.lines, topic.stop)
        lent = tuple(line for key in topic.also for line in self.own.get(key, ()))
        variables = _joined_variables(inherited.variables, topic.variables)
        patterns = parse_patterns(topic.pattern) or inherited.patterns
        gentle = topic.gentle or inherited.gentle
        self.nodes[topic.number] = Node(
            number=topic.number,
            key=topic.key,
            parent=ancestors[0] if ancestors else 0,
            children=tuple(child.number for child in self._children(topic)),
            links=self._links(topic),
            ancestors=ancestors,
            gentle=gentle,
            patterns=patterns,
            likeliness=topic.likeliness,
            names=_names(topic),
            variables=variables,
            lines=_joined(from_above, (*_said(lent, below=True), *_said(own, below=False))),
        )
        handed_down = _joined(from_above, _said(own, below=True))
        return _Inherited(handed_down, patterns, variables, gentle)

    def _links(self, topic: Topic) -> tuple[int, ...]:
        return tuple(self.topics[key].number for key in topic.see if key in self.topics)


def _compiled(frames: Iterable[Frame], owner: int) -> tuple[Line, ...]:
    return tuple(compile_line(frame, owner) for frame in frames)


def _said(lines: tuple[Line, ...], *, below: bool) -> tuple[Line, ...]:
    """Return the lines whose scope lets them be said below their topic, or at it."""
    hidden = "self" if below else "below"
    return tuple(line for line in lines if line.scope != hidden)


def _without(lines: Lines, stop: str) -> Lines:
    if not stop:
        return lines
    return MappingProxyType({type_: these for type_, these in lines.items() if type_ not in stop})


def _joined(lines: Lines, more: tuple[Line, ...]) -> Lines:
    """Return both; the very same object where there is nothing more, to save memory."""
    if not more:
        return lines
    joined = dict(lines)
    for line in more:
        joined[line.type] = (*joined.get(line.type, ()), line)
    return MappingProxyType(joined)


def _joined_variables(
    above: Mapping[str, Mapping[str, str]], own: Mapping[str, Mapping[str, str]]
) -> Mapping[str, Mapping[str, str]]:
    if not own:
        return above
    return MappingProxyType(
        {code: MappingProxyType({**above.get(code, {}), **own.get(code, {})}) for code in LANGUAGES}
    )


def _names(topic: Topic) -> Mapping[str, NameForms]:
    return MappingProxyType(
        {
            code: LANGUAGES[code].name_forms(fields)
            for code, fields in topic.names.items()
            if code in LANGUAGES
        }
    )
