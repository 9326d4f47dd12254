"""Try a sentence that is being written: as the robot will say it, and what stands in the way."""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from authoring.topic_page.said import Hearing, Warned, hearing, warned
from authoring.topic_page.small_knowledge import Small, saying
from dialogue.engine.pools import POOLS
from dialogue.engine.tree import Line, Node
from languages.known import LANGUAGES
from languages.language import FormError, NameForms
from languages.templates import NAMES, Template, TemplateError, compile_template

LONGEST = 400
MOST_NAMED = 3
_HIDDEN = re.compile(r"[\x00-\x08\x0b-\x1f\x7f\ud800-\udfff\ufffe\uffff]")


@dataclass(frozen=True, slots=True)
class Problem:
    """Why a sentence is refused: in which language, at which character (or -1), what to do."""

    language: str
    message: str
    position: int = -1


@dataclass(frozen=True, slots=True)
class Tried:
    """One sentence as said about one topic; `problem` where it cannot be."""

    about: str
    text: str
    problem: str
    warnings: tuple[Warned, ...]


def unreadable(texts: Mapping[str, str]) -> list[Problem]:
    """Return what makes texts unreadable wherever they are said."""
    return [
        problem
        for code, text in texts.items()
        if code in LANGUAGES and text and (problem := _unreadable(code, text))
    ]


def _unreadable(code: str, text: str) -> Problem | None:
    if len(text) > LONGEST:
        message = f"It has {len(text)} characters. Use at most {LONGEST}."
        return Problem(code, message, LONGEST)
    hidden = _HIDDEN.search(text)
    if hidden:
        message = (
            f"Remove the invisible control characters, the first at position {hidden.start()}."
        )
        return Problem(code, message, hidden.start())
    try:
        compile_template(text, code)
    except TemplateError as error:
        return Problem(code, str(error), error.position)
    return None


def unsayable(small: Small, number: int, among: Sequence[int]) -> list[Problem]:
    """Return for each language why the frame cannot be said of topics that would say it."""
    nodes = saying(small, number, among) or [small.tree.nodes[among[0]]]
    line = small.tree.lines[number]
    found = []
    for code, template in line.templates.items():
        failing = [
            (node, error)
            for node in nodes
            if code in node.names and (error := _failure(template, node, code))
        ]
        if failing:
            found.append(_told(code, failing))
    return [*found, *_unsayable_activity(line, nodes)]


def _failure(template: Template, node: Node, code: str) -> TemplateError | None:
    names = dict.fromkeys(NAMES, node.names[code])
    try:
        template.fill(names, node.variables.get(code, {}))
    except TemplateError as error:
        return error
    return None


def _told(code: str, failing: Sequence[tuple[Node, TemplateError]]) -> Problem:
    first = failing[0][1]
    keys = ", ".join(node.key for node, _ in failing[:MOST_NAMED])
    more = len(failing) - MOST_NAMED
    where = f"{keys} and {more} more" if more > 0 else keys
    advice = "Add the form or the variable there, use another, or limit where it is said."
    return Problem(code, f"It cannot be said of {where}: {first} {advice}", first.position)


def _unsayable_activity(line: Line, nodes: Sequence[Node]) -> Iterator[Problem]:
    for name, templates in line.proposal.parameters if line.proposal else ():
        for code, template in templates.items():
            for node in nodes:
                error = _failure(template, node, code) if code in node.names else None
                if error:
                    message = f"Activity, {name}: it cannot be made for {node.key}: {error}"
                    yield Problem("", message)
                    return


def tried(small: Small, number: int, node: Node, code: str, culture: str) -> Tried:
    """Return the frame as said about one topic; a transition leads to the topic above it."""
    above = small.tree.nodes[node.parent].key if node.parent in small.tree.nodes else ""
    heard = hearing(small.tree, node, code, culture, above)
    line = small.tree.lines[number]
    about = node.names[code].forms[""] if code in node.names else node.key
    if code not in line.templates:
        return Tried(about, "", "", ())
    return _filled(line.templates[code], line.type, heard, about)


def _filled(template: Template, letter: str, heard: Hearing, about: str) -> Tried:
    try:
        text = template.fill(heard.names, heard.variables)
    except TemplateError as error:
        return Tried(about, "", str(error), ())
    return Tried(about, text, "", warned(text, letter, heard))


def pool_problems(pool: str, texts: Mapping[str, str]) -> list[Problem]:
    """Return what a line of a pool asks for that the pool does not know."""
    known = POOLS[pool].variables if pool in POOLS else frozenset()
    found = []
    for code, text in texts.items():
        template = compile_template(text, code)
        used = {one.partition(".")[0] for one in template.variables}
        if used - known:
            asked = ", ".join(f"${one}" for one in sorted(used - known))
            offered = ", ".join(f"${one}" for one in sorted(known)) or "none"
            message = f"This pool does not know {asked}. Variables it knows: {offered}."
            found.append(Problem(code, message, text.find("$")))
    return found


def pool_misfits(
    texts: Mapping[str, str], names: Mapping[str, Mapping[str, Mapping[str, str]]]
) -> list[Problem]:
    """Return for each language the first topic that lacks a form which a pool line asks for.

    `names` are the fields of every topic's name by language and key; any topic may come there.
    """
    found = []
    for code, text in texts.items():
        template = compile_template(text, code)
        if not any("." in one for one in template.variables):
            continue
        for key, fields in names.get(code, {}).items():
            error = _misfit(template, code, fields)
            if error:
                message = f"It cannot be said of {key}: {error} Use a form that every topic has."
                found.append(Problem(code, message, error.position))
                break
    return found


def _misfit(template: Template, code: str, fields: Mapping[str, str]) -> TemplateError | None:
    try:
        forms: NameForms = LANGUAGES[code].name_forms(fields)
        template.fill(dict.fromkeys(NAMES, forms), dict.fromkeys(template.variables, "..."))
    except FormError:
        return None
    except TemplateError as error:
        return error
    return None


def pool_tried(pool: str, code: str, text: str, fields: Mapping[str, str]) -> Tried:
    """Return a pool line as said where the topic of this name comes."""
    forms = LANGUAGES[code].name_forms(fields)
    template = compile_template(text, code)
    words = dict.fromkeys(template.variables, "…")
    heard = Hearing(code, "", dict.fromkeys(NAMES, forms), words)
    return _filled(template, pool, heard, forms.forms[""])
