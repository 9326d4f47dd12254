"""repeat: the person did not hear the last sentence."""

from collections.abc import Mapping

from dialogue.engine.saying import say_from_pool
from dialogue.engine.turn import NO_WORDS, Turn
from languages.templates import TemplateError


def repeat(turn: Turn, parameters: Mapping[str, str | None]) -> bool:
    """Say the last sentence again; the talk stays where it was."""
    before = turn.state
    line = turn.content.tree.lines.get(before.frames[-1]) if before.frames else None
    text = _filled(turn, line.number) if line else ""
    if line is None or not text:
        say_from_pool(turn, "nothing_to_repeat")
        return True
    if not turn.heard.plan_said:
        say_from_pool(turn, "repeat")
        turn.state = before  # What was repeated is still the last thing said.
    turn.parts.append(text)
    turn.last_line = line
    turn.note("repeat", f"{line.key} again")
    return True


def _filled(turn: Turn, number: int) -> str:
    line, node = turn.content.tree.lines[number], turn.node
    template = line.templates.get(turn.state.language)
    if template is None:
        return ""
    names = {"hasName": node.names[turn.state.language]} if node else {}
    variables = node.variables.get(turn.state.language, NO_WORDS) if node else NO_WORDS
    try:
        return template.fill(names, variables)
    except TemplateError:  # A transition or a wish: its other words are gone.
        return ""
