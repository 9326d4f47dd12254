"""What the panel "What the robot says" holds, in names and words for its template."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from django.utils.translation import gettext as _

from authoring.topic_page.said import Group, Said, Section, hearing, what_is_said
from authoring.topic_page.shape import Shape, path_of
from authoring.topic_page.small_knowledge import Small, read_small_with_next
from authoring.topic_page.words import (
    KINDS,
    LANGUAGE_NAMES,
    SCOPES,
    Kind,
    in_own_language,
    own_language,
)
from dialogue.engine.concepts import Culture
from languages.known import LANGUAGES


@dataclass(frozen=True, slots=True)
class Choice:
    """A way to look at the topic: a language for people of a culture; `here` is this one."""

    culture: str
    language: str
    name: str
    here: bool


@dataclass(frozen=True, slots=True)
class Row:
    """The choices of one culture."""

    name: str
    choices: tuple[Choice, ...]


@dataclass(frozen=True, slots=True)
class Shown:
    """One sentence with its restrictions in words."""

    said: Said
    cultures: tuple[str, ...]
    where: str


@dataclass(frozen=True, slots=True)
class ShownGroup:
    """The sentences of one owner, who has a name."""

    group: Group
    name: str
    sentences: tuple[Shown, ...]


@dataclass(frozen=True, slots=True)
class ShownSection:
    """One kind of sentence."""

    section: Section
    kind: Kind
    groups: tuple[ShownGroup, ...]
    elsewhere: tuple[Shown, ...]


@dataclass(frozen=True, slots=True)
class Panel:
    """Everything the panel shows; `name` is what the topic is called in the language heard."""

    number: int
    key: str
    name: str
    culture: str
    culture_name: str
    language: str
    language_name: str
    unnamed: bool
    gentle: bool
    path: tuple[tuple[int, str], ...]
    rows: tuple[Row, ...]
    sections: tuple[ShownSection, ...]
    problems: tuple[str, ...]

    @property
    def count(self) -> int:
        """Return how many sentences can be said."""
        return sum(one.section.count for one in self.sections)


def read_panel(shape: Shape, number: int, culture: str, language: str) -> Panel:
    """Return the panel of a topic; a culture or language that is not known gives the usual one."""
    small, following = read_small_with_next(shape, number)
    cultures = small.knowledge.cultures
    home = next(topic.of for topic in small.knowledge.topics if topic.number == number)
    heard_by = _culture(cultures, culture, home)
    code = language if language in LANGUAGES else heard_by.language if heard_by else "en"
    return _panel(small, shape, number, (heard_by, code, following))


def _culture(cultures: Sequence[Culture], wanted: str, home: str) -> Culture | None:
    by_code = {one.code: one for one in cultures}
    return by_code.get(wanted) or by_code.get(home) or next(iter(cultures), None)


def _panel(
    small: Small, shape: Shape, number: int, asked: tuple[Culture | None, str, int | None]
) -> Panel:
    heard_by, code, following = asked
    node = small.node(number)
    culture = heard_by.code if heard_by else ""
    heard = hearing(small.tree, node, code, culture, shape.keys.get(following or 0, ""))
    sections = what_is_said(small.knowledge, small.tree, node, heard, small.findings)
    called = {one.code: in_own_language(one.names, one.code) for one in small.knowledge.cultures}
    names = {
        topic.number: topic.names.get(own_language(), {}).get("name", topic.key)
        for topic in small.knowledge.topics
    }
    unnamed = code not in node.names
    return Panel(
        number=number,
        key=node.key,
        name=node.key if unnamed else node.names[code].forms[""],
        culture=culture,
        culture_name=called.get(culture, culture),
        language=code,
        language_name=str(LANGUAGE_NAMES[code]),
        unnamed=unnamed,
        gentle=node.gentle,
        path=tuple(path_of(shape, number)),
        rows=_rows(small.knowledge.cultures, called, (culture, code)),
        sections=tuple(_section(one, names, called) for one in sections),
        problems=_own_problems(small, node.key),
    )


def _own_problems(small: Small, key: str) -> tuple[str, ...]:
    return tuple(f"{one.message} {one.hint}" for one in small.findings if one.where == key)


def _rows(
    cultures: Sequence[Culture], called: Mapping[str, str], here: tuple[str, str]
) -> tuple[Row, ...]:
    return tuple(
        Row(
            called[one.code],
            tuple(
                Choice(one.code, code, str(LANGUAGE_NAMES[code]), (one.code, code) == here)
                for code in LANGUAGES
            ),
        )
        for one in cultures
    )


def _section(section: Section, names: Mapping[int, str], called: Mapping[str, str]) -> ShownSection:
    groups = tuple(
        ShownGroup(group, names[group.owner], _of_group(group, names, called))
        for group in section.groups
    )
    elsewhere = tuple(_shown(one, called) for one in section.elsewhere)
    return ShownSection(section, KINDS[section.letter], groups, elsewhere)


def _of_group(
    group: Group, names: Mapping[int, str], called: Mapping[str, str]
) -> tuple[Shown, ...]:
    owner = "" if group.own else names[group.owner]
    return tuple(_shown(one, called, owner) for one in group.sentences)


def _shown(said: Said, called: Mapping[str, str], owner: str = "") -> Shown:
    cultures = tuple(called.get(code, code) for code in said.only)
    if owner and said.scope == "below":
        return Shown(said, cultures, _("only below %s") % owner)
    return Shown(said, cultures, str(SCOPES[said.scope]) if said.scope else "")
