"""Choose a sentence and say it: the unused ones first, never a frame heard just before."""

from collections.abc import Mapping, Sequence

from dialogue.engine.chance import draw
from dialogue.engine.content import Content
from dialogue.engine.sentence_types import SENTENCE_TYPES
from dialogue.engine.tree import Line, Node
from dialogue.engine.turn import NO_WORDS, Turn
from languages.language import NameForms
from languages.templates import TemplateError
from plans.engine.capabilities import can_do

# Own sentences of the topic before those of its class before those from further up.
OWN, FROM_CLASS, FROM_ABOVE = 4.0, 3.0, 1.0
NEVER_WHEN_GENTLE = frozenset({"q", "g"})  # "Do you like grief?"


def say_of_type(turn: Turn, node: Node, type_: str) -> bool:
    """Say a sentence of this type about a topic; False where it has none."""
    lines = sayable(turn, node, type_)
    if not lines:
        turn.note("skip", f"{node.key} has nothing of type {type_}.")
        return False
    line = choose(turn, node, lines)
    return _say_about(turn, node, line, {"hasName": node.names[turn.state.language]})


def say_transition(turn: Turn, old: Node, new: Node) -> bool:
    """Say how one topic leads to the other; False where the old one has no such sentence."""
    language = turn.state.language
    used = turn.state.used_slots(old.number)
    lines = [
        line
        for line in sayable(turn, old, "t")
        if line.number not in turn.state.frames and (line.slot < 0 or not used >> line.slot & 1)
    ]
    if not lines:
        return False
    names = {"hasName": old.names[language], "toName": new.names[language]}
    return _say_about(turn, old, choose(turn, old, lines), names)


def sayable(turn: Turn, node: Node, type_: str) -> list[Line]:
    """Return the topic's lines of a type for this language, culture and robot."""
    language, culture = turn.state.language, turn.state.culture
    if language not in node.names or (node.gentle and type_ in NEVER_WHEN_GENTLE):
        return []
    lines = [
        line
        for line in node.lines.get(type_, ())
        if line.fits(language, culture) and not _just_said(turn, node, line)
    ]
    if type_ == "g":
        return [line for line in lines if _can_do(turn, line)]
    return lines


def _just_said(turn: Turn, node: Node, line: Line) -> bool:
    """Say whether the person heard this very sentence last: it must not come twice in a row."""
    since_last_turn = turn.state.frames[-1 - len(turn.parts) :]
    if line.number not in since_last_turn:
        return False
    return line.slot < 0 or turn.state.has_used(node.number, line.slot)


def choose(turn: Turn, node: Node, lines: Sequence[Line]) -> Line:
    """Return one line: unused before used, not heard lately before heard, own before inherited."""
    used = turn.state.used_slots(node.number)
    unused = [line for line in lines if line.slot < 0 or not used >> line.slot & 1]
    if not unused:
        mask = sum(1 << line.slot for line in lines)
        turn.state = turn.state.without_used(node.number, mask)
    return _least_recent(
        turn, node, _but_the_last(turn, unused) or _but_the_last(turn, lines) or lines
    )


def _but_the_last(turn: Turn, lines: Sequence[Line]) -> Sequence[Line]:
    """Return the lines without the one said last, perhaps about another topic."""
    last = turn.state.frames[-1:]
    return [line for line in lines if line.number not in last]


def _least_recent(turn: Turn, node: Node, lines: Sequence[Line]) -> Line:
    heard = turn.state.frames
    fresh = [line for line in lines if line.number not in heard]
    if not fresh:
        return min(lines, key=lambda line: _last_heard(heard, line.number))
    own = [line for line in fresh if line.owner == node.number]
    if node.gentle and own:
        # What was written for this very grief comes first; of that, to begin with, the first: c1.
        fresh = own if turn.state.used_slots(node.number) else own[:1]
    chosen = draw([(line, _weight(node, line)) for line in fresh], turn.chance)
    return chosen or fresh[0]


def _last_heard(heard: tuple[int, ...], number: int) -> int:
    return len(heard) - 1 - heard[::-1].index(number)


def _weight(node: Node, line: Line) -> float:
    if line.owner == node.number:
        return OWN
    return FROM_CLASS if line.owner == node.parent else FROM_ABOVE


def _can_do(turn: Turn, line: Line) -> bool:
    """Say whether the activity of a proposal exists and the client can do all of it."""
    intent = turn.content.catalogue.intents.get(line.proposal.intent) if line.proposal else None
    return intent is not None and can_do(intent, turn.heard.capabilities)


def _say_about(turn: Turn, node: Node, line: Line, names: Mapping[str, NameForms]) -> bool:
    variables = node.variables.get(turn.state.language, NO_WORDS)
    if not _speak(turn, line, names, variables):
        return False
    if line.slot >= 0:  # In a draft new sentences have none yet.
        turn.state = turn.state.with_used(node.number, line.slot)
    turn.note("say", f"{line.key} ({SENTENCE_TYPES[line.type].name}) about {node.key}")
    return True


def say_from_pool(
    turn: Turn,
    pool: str,
    names: Mapping[str, NameForms] = {},
    words: Mapping[str, str] = NO_WORDS,
) -> bool:
    """Say a sentence of a pool; False where it has none in this language."""
    state = turn.state
    lines = [
        line
        for line in turn.content.tree.pools.get(pool, ())
        if line.fits(state.language, state.culture)
    ]
    fresh = [line for line in lines if line.number not in state.frames]
    if not lines:
        return False
    line = (
        fresh[turn.chance.randrange(len(fresh))]
        if fresh
        else min(lines, key=lambda line: _last_heard(state.frames, line.number))
    )
    turn.note("pool", f"{line.key}, from the pool {pool}")
    return _speak(turn, line, names, words)


def _speak(
    turn: Turn, line: Line, names: Mapping[str, NameForms], words: Mapping[str, str]
) -> bool:
    try:
        text = line.templates[turn.state.language].fill(names, words)
    except TemplateError as error:  # Publishing refuses such lines; an old one must not end a talk.
        turn.note("unfilled", f"{line.key}: {error}")
        return False
    if turn.parts and text.startswith(turn.parts[-1]):
        turn.parts[-1] = ""  # Not "Take your time. Take your time. I am listening."
    turn.parts.append(text)
    turn.last_line = line
    turn.state = turn.state.with_frame(line.number)
    return True


def apology(content: Content, language: str) -> str:
    """Return words for a turn that could not be had at all; "" where there are none."""
    for line in content.tree.pools.get("apology", ()):
        if language in line.templates:
            return line.templates[language].fill({}, NO_WORDS)
    return ""
