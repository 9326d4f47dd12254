"""What the robot says about a topic to people of a culture in a language, as it says it."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from dialogue.engine.concepts import Frame, Knowledge, Topic
from dialogue.engine.findings import Finding
from dialogue.engine.saying import NEVER_WHEN_GENTLE
from dialogue.engine.sentence_types import SENTENCE_TYPES
from dialogue.engine.tree import Line, Node, Tree
from languages.language import NameForms
from languages.lints import lint_gentle_sentence, lint_health_sentence, lint_sentence
from languages.templates import TemplateError

HEALTH = "Health"


@dataclass(frozen=True, slots=True)
class Warned:
    """A reason to look at a sentence: what, and what to do; `error` stops a publication."""

    message: str
    hint: str
    error: bool


@dataclass(frozen=True, slots=True)
class Said:
    """One sentence: filled where it can be, or why not; `here` says whether it is said here."""

    number: int
    key: str
    text: str
    only: tuple[str, ...]
    scope: str
    activity: str
    here: bool
    warnings: tuple[Warned, ...]


@dataclass(frozen=True, slots=True)
class Group:
    """The sentences that one topic gives: the topic itself, one above it, or a lender."""

    owner: int
    key: str
    own: bool
    lent: bool
    sentences: tuple[Said, ...]


@dataclass(frozen=True, slots=True)
class Section:
    """All of one kind: own ones first, then inherited ones from near to far.

    `elsewhere` are those for other cultures or without words in this language; `silent` says
    that a gentle topic never says this kind; `stopped` that inherited ones are left out.
    """

    letter: str
    groups: tuple[Group, ...]
    elsewhere: tuple[Said, ...]
    silent: bool
    stopped: bool

    @property
    def count(self) -> int:
        """Return how many sentences can be said here."""
        return sum(one.here for group in self.groups for one in group.sentences)


@dataclass(frozen=True, slots=True)
class Hearing:
    """Who hears it: `language` and `culture`; `names` are those of the topic and of a next one."""

    language: str
    culture: str
    names: Mapping[str, NameForms]
    variables: Mapping[str, str]
    gentle: bool = False
    health: bool = False


def hearing(tree: Tree, node: Node, language: str, culture: str, next_key: str = "") -> Hearing:
    """Return how a topic is heard; `next_key` is the topic that a transition leads to."""
    following = tree.by_key.get(next_key, node)
    names = {}
    if language in node.names:
        names["hasName"] = node.names[language]
    if language in following.names:
        names["toName"] = following.names[language]
    return Hearing(
        language,
        culture,
        names,
        node.variables.get(language, {}),
        gentle=node.gentle,
        health=tree.nodes[node.branch].key == HEALTH,
    )


def what_is_said(
    knowledge: Knowledge, tree: Tree, node: Node, heard: Hearing, found: Iterable[Finding] = ()
) -> tuple[Section, ...]:
    """Return one section for each kind of sentence, in the order of the kinds."""
    topics = {topic.key: topic for topic in knowledge.topics}
    page = _Page(tree, node, heard, topics, tuple(found))
    return tuple(page.section(letter) for letter in SENTENCE_TYPES)


def said_line(line: Line, heard: Hearing, *, here: bool = True) -> Said:
    """Return one sentence filled; where it cannot be said, the reason stands in its warnings."""
    text = ""
    warnings: tuple[Warned, ...] = ()
    template = line.templates.get(heard.language)
    if template is None:
        here = False
    else:
        try:
            text = template.fill(heard.names, heard.variables)
            warnings = warned(text, line.type, heard)
        except TemplateError as error:
            hint = "Add the form or the variable, or limit the sentence."
            text, warnings = template.text, (Warned(str(error), hint, error=True),)
    return Said(
        number=line.number,
        key=line.key,
        text=text,
        only=tuple(sorted(line.only)),
        scope=line.scope,
        activity=_activity(line, heard),
        here=here,
        warnings=warnings,
    )


def warned(text: str, letter: str, heard: Hearing) -> tuple[Warned, ...]:
    """Return what is worth a look in a filled sentence."""
    found = [*lint_sentence(text, letter, heard.language)]
    if heard.gentle:
        found += lint_gentle_sentence(text, heard.language)
    if heard.health:
        found += lint_health_sentence(text, heard.language)
    return tuple(Warned(one.message, one.hint, one.error) for one in found)


def _activity(line: Line, heard: Hearing) -> str:
    if line.proposal is None:
        return ""
    words = [line.proposal.intent]
    for name, templates in line.proposal.parameters:
        try:
            value = templates[heard.language].fill(heard.names, heard.variables)
        except TemplateError as error:
            value = str(error)
        words.append(f"{name}={value}")
    return " ".join(words)


class _Page:
    def __init__(
        self,
        tree: Tree,
        node: Node,
        heard: Hearing,
        topics: Mapping[str, Topic],
        found: tuple[Finding, ...],
    ) -> None:
        self.tree, self.node, self.heard, self.topics = tree, node, heard, topics
        self.found: dict[str, list[Warned]] = {}
        for one in found:
            self.found.setdefault(one.where, []).append(Warned(one.message, one.hint, one.error))

    def section(self, letter: str) -> Section:
        topic = self.topics[self.node.key]
        silent = self.node.gentle and letter in NEVER_WHEN_GENTLE
        lines = list(self.node.lines.get(letter, ()))
        shown = {line.number for line in lines}
        own = [frame for frame in topic.frames if frame.type == letter]
        lines += [self.tree.lines[one.number] for one in own if one.number not in shown]
        groups: dict[int, list[Said]] = {}
        elsewhere: list[Said] = []
        for line in lines:
            fits = line.fits(self.heard.language, self.heard.culture)
            one = self._said(line, here=fits and not silent and line.number in shown)
            if fits:
                groups.setdefault(line.owner, []).append(one)
            else:
                elsewhere.append(one)
        stopped = letter in topic.stop
        return Section(letter, self._in_order(groups), tuple(elsewhere), silent, stopped)

    def _said(self, line: Line, *, here: bool) -> Said:
        one = said_line(line, self.heard, here=here)
        broken = tuple(self.found.get(line.key, ()))
        if not broken:
            return one
        return Said(
            one.number,
            one.key,
            one.text or self._as_written(line),
            one.only,
            one.scope,
            one.activity,
            one.here,
            broken + one.warnings,
        )

    def _as_written(self, line: Line) -> str:
        return next((template.text for template in line.templates.values()), "")

    def _in_order(self, groups: Mapping[int, list[Said]]) -> tuple[Group, ...]:
        near = (self.node.number, *self.node.ancestors)
        lenders = [number for number in groups if number not in near]
        return tuple(
            Group(
                owner=number,
                key=next((t.key for t in self.topics.values() if t.number == number), ""),
                own=number == self.node.number,
                lent=number in lenders,
                sentences=tuple(groups[number]),
            )
            for number in (*near, *lenders)
            if number in groups
        )


def frames_of(knowledge: Knowledge) -> dict[int, Frame]:
    """Return all frames of topics by number."""
    return {frame.number: frame for topic in knowledge.topics for frame in topic.frames}
