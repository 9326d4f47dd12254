"""Check that every sentence can be filled for every topic that inherits it."""

from collections.abc import Iterator, Mapping

from dialogue.engine.build import build_tree
from dialogue.engine.concepts import Frame, Knowledge
from dialogue.engine.findings import Finding
from dialogue.engine.pools import POOLS
from dialogue.engine.tree import Line, Node, Tree
from languages.known import LANGUAGES
from languages.language import NameForms
from languages.templates import NAMES, Template, TemplateError, compile_template


def check_sentences(knowledge: Knowledge) -> list[Finding]:
    """Return an error for each sentence that cannot be read, or not be filled somewhere."""
    found = [finding for frame in _all_frames(knowledge) for finding in _check_template(frame)]
    if found:
        return found
    tree = build_tree(knowledge)
    for node in tree.nodes.values():
        for lines in node.lines.values():
            for line in lines:
                found += _check_filled(node, line)
    for name, lines in tree.pools.items():
        for line in lines:
            found += _check_pool_line(name, line, tree)
    return found


def _all_frames(knowledge: Knowledge) -> Iterator[Frame]:
    for topic in knowledge.topics:
        yield from topic.frames
    for frames in knowledge.pools.values():
        yield from frames


def _check_template(frame: Frame) -> Iterator[Finding]:
    for code in [code for code in LANGUAGES if frame.texts.get(code, "").strip()]:
        try:
            compile_template(frame.texts[code], code)
        except TemplateError as error:
            yield Finding("D021", frame.key, f"In {code}: {error}", "Correct it at that place.")


def _check_filled(node: Node, line: Line) -> Iterator[Finding]:
    for code, template in line.templates.items():
        names = {"hasName": node.names[code]}
        if line.type == "t":
            names["toName"] = node.names[code]
        problem = _problem(template, names, node.variables.get(code, {}))
        if problem:
            yield _unfilled(node, line, code, problem)
    for name, templates in line.proposal.parameters if line.proposal else ():
        for code, template in templates.items():
            problem = _problem(
                template, {"hasName": node.names[code]}, node.variables.get(code, {})
            )
            if problem:
                yield _unfilled(node, line, code, f"activity, {name}: {problem}")


def _unfilled(node: Node, line: Line, code: str, problem: str) -> Finding:
    return Finding(
        "D022",
        node.key,
        f"{line.key} cannot be said of it in {code}: {problem}",
        "Add the form or the variable, or limit the sentence (scope: below).",
    )


def _problem(
    template: Template, names: Mapping[str, NameForms], variables: Mapping[str, str]
) -> str:
    try:
        template.fill(names, variables)
    except TemplateError as error:
        return str(error)
    return ""


def _check_pool_line(pool: str, line: Line, tree: Tree) -> Iterator[Finding]:
    allowed = POOLS[pool].variables
    for code, template in line.templates.items():
        used = {variable.partition(".")[0] for variable in template.variables}
        if used - allowed:
            yield Finding(
                "D023",
                line.key,
                f"In {code} it uses ${', $'.join(sorted(used - allowed))}.",
                f"This pool knows {', '.join(sorted(allowed)) or 'no variables'}.",
            )
        elif any("." in variable for variable in template.variables):
            yield from _check_forms(line, code, template, tree)


def _check_forms(line: Line, code: str, template: Template, tree: Tree) -> Iterator[Finding]:
    """Find the first topic that lacks a form: any topic may come where a pool is used."""
    words = dict.fromkeys(template.variables, "")
    for node in tree.nodes.values():
        problem = _problem(template, dict.fromkeys(NAMES, node.names[code]), words)
        if problem:
            message = f"In {code} it cannot be said of {node.key}: {problem}"
            yield Finding("D024", line.key, message, "Use a form that every topic has.")
            return
