"""How the talk flows: begin a topic, carry on with it, move on to the next (lines 25 and 29-37)."""

from dialogue.engine.next_topic import Step, another_branch, next_topic
from dialogue.engine.saying import say_from_pool, say_of_type, say_transition, sayable
from dialogue.engine.sentence_types import REACTION, SENTENCE_TYPES
from dialogue.engine.tree import Node, Pattern
from dialogue.engine.turn import Turn

PROPOSE = 0.3  # in about one topic of four the [g] of a pattern is kept
MOST_QUESTIONS = 2  # in a row
MOST_TOPICS_A_TURN = 4
LOVED = 1.0


def begin(turn: Turn, node: Node, *, start: str = "", opinion: bool = False) -> None:
    """Make this the topic and say its first sentence.

    `start` is the type to begin with ("p": the person said that they like it); likeliness exactly
    1.0 or an opinion leaves out the yes/no question.
    """
    ordering = _ordering(turn, node)
    if start == "n":
        ordering = "n"
    elif start:
        ordering = start + _after_start(ordering, start)
    elif opinion or turn.likeliness(node) == LOVED:
        ordering = _without_question(ordering)
    if node.gentle and ordering[:1] != "c":
        ordering = f"c{ordering}"  # A hard subject is heard before it is asked about.
    turn.state = turn.state.with_topic_started(node.number)
    turn.change(ordering=ordering)
    turn.note("begin", f"Topic {node.key}, ordering {' '.join(ordering) or 'empty'}")
    carry_on(turn)


def _ordering(turn: Turn, node: Node) -> str:
    pattern: Pattern = node.patterns[turn.chance.randrange(len(node.patterns))]
    return "".join(
        letter for letter, optional in pattern if not optional or turn.chance.random() < PROPOSE
    )


def _after_start(ordering: str, start: str) -> str:
    """Return what follows when a topic begins with a type of the person's choosing."""
    done = {"p": "qr", "q": "q"}.get(start, start)
    return "".join(letter for letter in ordering if letter not in done)


def _without_question(ordering: str) -> str:
    if "q" not in ordering:
        return ordering.replace(REACTION, "")
    return "p" + ordering.replace("q", "").replace(REACTION, "")


def carry_on(turn: Turn) -> None:
    """Say the next types of the ordering until one ends the turn; then the topic is completed."""
    for _ in range(MOST_TOPICS_A_TURN):
        if _say_ordering(turn) or _hand_over(turn):
            return
        if not _enter_next(turn):
            break
    say_from_pool(turn, "initiative")


def _hand_over(turn: Turn) -> bool:
    """After a hard subject the person says what comes next; True where something was said."""
    node = turn.node
    if node is None or not node.gentle or turn.moving:
        return False
    if turn.state.last_type == "e":
        turn.note("stay", f"Nothing else was named: go on listening about {node.key}.")
        turn.change(ordering="cw")
        return _say_ordering(turn)
    turn.note("hand over", f"{node.key} is a hard subject: the person chooses how to go on.")
    return say_from_pool(turn, "stay_or_go") or say_from_pool(turn, "initiative")


def _say_ordering(turn: Turn) -> bool:
    """Say sentences of the current topic; True where one of them ended the turn."""
    node = turn.node
    while node and turn.state.ordering:
        letter = _next_letter(turn, node)
        if letter in SENTENCE_TYPES and say_of_type(turn, node, letter):
            if SENTENCE_TYPES[letter].ends_turn:
                return True
            if letter == "n":
                turn.change(ordering="")
    return False


def _next_letter(turn: Turn, node: Node) -> str:
    """Take the next type off the ordering; a remark first where questions are too many."""
    letter, rest = turn.state.ordering[0], turn.state.ordering[1:]
    asks = letter in SENTENCE_TYPES and SENTENCE_TYPES[letter].asks
    if asks and turn.state.questions >= MOST_QUESTIONS and sayable(turn, node, "c"):
        turn.note("pause", "Two questions in a row are enough: a remark first.")
        turn.change(ordering=letter + rest.replace("c", "", 1))
        return "c"
    turn.change(ordering=rest)
    return letter


def _enter_next(turn: Turn) -> bool:
    """Go to the next topic, announced; False where there is none."""
    node = turn.node
    step = _next(turn, node)
    while step is None and len(turn.state.topics) > 1:
        # All has been talked about: the older half may come again.
        turn.change(topics=turn.state.topics[-(len(turn.state.topics) // 2) :])
        step = _next(turn, node)
    if step is None:
        turn.note("next", "No topic is left to propose.")
        return False
    announce(turn, node, step)
    enter(turn, step)
    return True


def _next(turn: Turn, node: Node | None) -> Step | None:
    if node and turn.state.noes >= 2:
        return another_branch(turn, node)
    return next_topic(turn, node)


def enter(turn: Turn, step: Step) -> None:
    """Make the step's topic the current one, without saying anything about it yet."""
    siblings = turn.state.siblings + 1 if step.way == "sibling" else 0
    ordering = _ordering(turn, step.node)
    if turn.likeliness(step.node) == LOVED:
        ordering = _without_question(ordering)
    turn.state = turn.state.with_topic_started(step.node.number)
    turn.change(ordering=ordering, siblings=siblings)
    if turn.state.noes >= 2:
        turn.change(noes=0)
    turn.note("begin", f"Topic {step.node.key} ({step.way}), ordering {' '.join(ordering)}")


def _is_unwelcome(turn: Turn, old: Node) -> bool:
    """Say whether the old topic is better not named again: refused just now, avoided, or hard."""
    refused = turn.state.noes or turn.state.avoids((old.number, *old.ancestors))
    return old.gentle or bool(refused)


def announce(turn: Turn, old: Node | None, step: Step) -> None:
    """Say a transition: the topic's own, else one that names both, else a change of subject."""
    if turn.announced:
        return
    language = turn.state.language
    names = {"toName": step.node.names[language]}
    if old is None:
        say_from_pool(turn, "begin", names)
        return
    if step.way == "far" or _is_unwelcome(turn, old) or language not in old.names:
        say_from_pool(turn, "change", names)
        return
    if turn.chance.random() < 0.5 and say_transition(turn, old, step.node):
        return
    say_from_pool(turn, "transition", {**names, "hasName": old.names[language]})
