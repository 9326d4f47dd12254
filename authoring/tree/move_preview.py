"""What a move in the tree changes in what is said: by the moved topics and all below them.

It is taken from the trees that the engine builds before and after, of just the topics concerned:
the moved ones, those above the old and the new place, and their lenders.
"""

import hashlib
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import reduce
from operator import or_

import msgspec
from django.db.models import Q
from django.utils.translation import gettext as _

from authoring.topic_page.said import hearing, said_line
from authoring.topic_page.shape import Shape
from authoring.topic_page.sound import sound
from authoring.topic_page.words import KINDS, LANGUAGE_NAMES, own_language
from dialogue.content import read_part
from dialogue.engine.build import build_tree
from dialogue.engine.concepts import ROOT, Knowledge
from dialogue.engine.sentence_types import REACTION
from dialogue.engine.tree import Line, Node, Pattern, Tree
from dialogue.models import Sentence, Topic, Variable
from languages.templates import TemplateError

#: So many topics below a moved one are read with all they say, whether it matters or not.
FEW = 200


@dataclass(frozen=True, slots=True)
class SentenceChange:
    """A sentence gained or lost: filled for the topic it is shown for, and by how many topics.

    `itself` says whether the moved topic is among them.
    """

    key: str
    owner: str
    kind: str
    text: str
    topics: int
    itself: bool


@dataclass(frozen=True, slots=True)
class VariableChange:
    """A word of sentences that becomes another one; "" where it is not there."""

    name: str
    language: str
    old: str
    new: str


@dataclass(frozen=True, slots=True)
class Broken:
    """A sentence that could be said before and cannot afterwards, and why."""

    key: str
    topic: str
    reason: str


@dataclass(frozen=True, slots=True)
class Preview:
    """What a move brings. `old` and `new` are keys of parents, "" the root; `moved` counts."""

    key: str
    old: str
    new: str
    moved: int
    gained: tuple[SentenceChange, ...]
    lost: tuple[SentenceChange, ...]
    variables: tuple[VariableChange, ...]
    old_pattern: str
    new_pattern: str
    becomes_gentle: bool
    no_longer_gentle: bool
    broken: tuple[Broken, ...]

    @property
    def fingerprint(self) -> str:
        """Return what all of this comes to: 64 letters, equal for equal previews."""
        return hashlib.sha256(repr(self).encode("utf-8", "surrogatepass")).hexdigest()

    @property
    def changes_nothing(self) -> bool:
        """Say whether everything is said as before."""
        return not (
            self.gained
            or self.lost
            or self.variables
            or self.broken
            or self.old_pattern != self.new_pattern
            or self.becomes_gentle
            or self.no_longer_gentle
        )


def compare(shape: Shape, number: int, target: int | None) -> Preview:
    """Return what a move that is possible would bring; about fifteen queries."""
    moved = (number, *shape.below(number))
    before = _knowledge(shape, moved, number, target)
    key, goal = shape.keys[number], shape.keys[target] if target is not None else ROOT
    topics = tuple(
        msgspec.structs.replace(topic, is_a=goal) if topic.key == key else topic
        for topic in before.topics
    )
    after = msgspec.structs.replace(before, topics=topics)
    return _Compared(build_tree(before), build_tree(after), moved).preview(goal)


def _knowledge(shape: Shape, moved: tuple[int, ...], number: int, target: int | None) -> Knowledge:
    """Return the moved topics with those above the old and the new place, and lenders."""
    around = dict.fromkeys(shape.above(number))
    if target is not None:
        around |= dict.fromkeys((target, *shape.above(target)))
    lenders = Topic.also.through.objects.filter(from_topic__in=moved)
    around |= dict.fromkeys(lenders.values_list("to_topic_id", flat=True))
    speaking = {*around, number, *_users_of_lost_words(shape, moved, number, target)}
    silent = [one for one in moved if one not in speaking]
    if len(silent) <= FEW:  # Fewer questions to the database, though some answers are not needed.
        speaking, silent = {*speaking, *silent}, []
    known = read_part(speaking, shape.keys)
    topics = known.topics
    if silent:
        topics += read_part(silent, shape.keys, frames=False).topics
    sane, _found = sound(msgspec.structs.replace(known, topics=topics))
    return sane


def _users_of_lost_words(
    shape: Shape, moved: tuple[int, ...], number: int, target: int | None
) -> Iterable[int]:
    """Return the moved topics with own sentences that use words of the old place; two queries."""
    kept = () if target is None else (target, *shape.above(target))
    left = set(shape.above(number)).difference(kept)
    names = Variable.objects.filter(topic__in=left).values_list("name", flat=True).distinct()
    using = reduce(or_, (Q(text__contains=f"${name}") for name in names), Q(pk__in=()))
    rows = Sentence.objects.filter(using, frame__topic__in=moved).order_by()
    return rows.values_list("frame__topic", flat=True).distinct()


class _Compared:
    """Two trees, before and after."""

    def __init__(self, before: Tree, after: Tree, moved: tuple[int, ...]) -> None:
        self.before, self.after = before, after
        self.pairs = [(before.nodes[one], after.nodes[one]) for one in moved]

    def preview(self, goal: str) -> Preview:
        old, new = self.pairs[0]
        parent = self.before.nodes.get(old.parent)
        return Preview(
            key=old.key,
            old=parent.key if parent else "",
            new="" if goal == ROOT else goal,
            moved=len(self.pairs),
            gained=tuple(self._changed(self.after, self.pairs)),
            lost=tuple(self._changed(self.before, [(b, a) for a, b in self.pairs])),
            variables=tuple(_variables(old, new)),
            old_pattern=_words(old.patterns),
            new_pattern=_words(new.patterns),
            becomes_gentle=new.gentle and not old.gentle,
            no_longer_gentle=old.gentle and not new.gentle,
            broken=tuple(self._broken()),
        )

    def _changed(self, tree: Tree, pairs: list[tuple[Node, Node]]) -> Iterator[SentenceChange]:
        """Yield what the second nodes say and the first ones do not; `tree` is theirs."""
        who: dict[int, list[Node]] = {}
        lines: dict[int, Line] = {}
        for without, node in pairs:
            for number, line in _new_lines(without, node).items():
                lines[number] = line
                who.setdefault(number, []).append(node)
        for number, nodes in who.items():
            yield _told(tree, lines[number], nodes, itself=nodes[0] is pairs[0][1])

    def _broken(self) -> Iterator[Broken]:
        for old, new in self.pairs:
            gone = frozenset(
                name
                for code, texts in old.variables.items()
                for name in texts
                if name not in new.variables.get(code, {})
            )
            gained = _new_lines(old, new)
            for lines in new.lines.values():
                for line in lines:
                    if line.number in gained or _uses(line, gone):
                        yield from self._cannot_say(old, new, line)

    def _cannot_say(self, old: Node, new: Node, line: Line) -> Iterator[Broken]:
        reason = _reason(self.after, new, line)
        if reason and not _was_broken(self.before, old, line):
            yield Broken(line.key, new.key, reason)


def _uses(line: Line, names: frozenset[str]) -> bool:
    return bool(names) and any(names & one.variables for one in line.templates.values())


def _new_lines(without: Node, node: Node) -> Mapping[int, Line]:
    known = {line.number for lines in without.lines.values() for line in lines}
    return {
        line.number: line
        for lines in node.lines.values()
        for line in lines
        if line.number not in known
    }


def _told(tree: Tree, line: Line, nodes: list[Node], *, itself: bool) -> SentenceChange:
    node, language = nodes[0], own_language()
    above = tree.nodes.get(node.parent)
    said = said_line(line, hearing(tree, node, language, "", above.key if above else ""))
    owner = tree.nodes.get(line.owner)
    return SentenceChange(
        key=line.key,
        owner=owner.key if owner else line.key.partition(".")[0],
        kind=str(KINDS[line.type].name) if line.type in KINDS else line.type,
        text=said.text,
        topics=len(nodes),
        itself=itself,
    )


def _variables(old: Node, new: Node) -> Iterator[VariableChange]:
    for code, language in LANGUAGE_NAMES.items():
        had, has = old.variables.get(code, {}), new.variables.get(code, {})
        for name in dict.fromkeys((*had, *has)):
            if had.get(name) != has.get(name):
                yield VariableChange(name, str(language), had.get(name, ""), has.get(name, ""))


def _words(patterns: Iterable[Pattern]) -> str:
    """Return patterns in words; what may be left out stands in brackets."""
    called = {letter: str(kind.name) for letter, kind in KINDS.items()}
    called[REACTION] = _("after a yes or a no")
    between = _("or")
    return f" {between} ".join(
        " · ".join(f"({called[one]})" if optional else called[one] for one, optional in pattern)
        for pattern in patterns
    )


def _was_broken(tree: Tree, node: Node, line: Line) -> bool:
    said = any(one.number == line.number for one in node.lines.get(line.type, ()))
    return said and bool(_reason(tree, node, line))


def _reason(tree: Tree, node: Node, line: Line) -> str:
    for code, template in line.templates.items():
        if code not in node.names:
            continue
        heard = hearing(tree, node, code, "")
        try:
            template.fill({"toName": node.names[code], **heard.names}, heard.variables)
        except TemplateError as error:
            return f"{LANGUAGE_NAMES.get(code, code)}: {error.message}"
    return ""
