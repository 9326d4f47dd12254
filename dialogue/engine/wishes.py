"""What the person wants wins: stay with them when they speak of someone or something of theirs."""

from dialogue.engine.flow import carry_on
from dialogue.engine.people import is_about_people
from dialogue.engine.saying import say_from_pool
from dialogue.engine.tree import ON_YOUR_MIND, Node
from dialogue.engine.turn import Turn

#: The pool for each way of bringing something up (the `startsentence` of the jump).
_POOLS = {"p": "fond", "n": "averse"}
LONGEST_WISH = 80


def is_personal(turn: Turn, words: str, node: Node | None) -> bool:
    """Say whether the words speak of someone of theirs: "my wife Margaret", not "my garden"."""
    if node is not None and not is_about_people(turn, node):
        return False
    return turn.language.their_words(words).casefold() != words.casefold()


def stay_with(turn: Turn, words: str, startsentence: str) -> bool:
    """Ask about what the person brought up, in their words, and go on listening.

    Followed in the next turns by remarks and open questions that presuppose nothing.
    """
    said = " ".join(words.split())
    if not said or len(said) > LONGEST_WISH:
        return False
    pool, returned = _POOLS.get(startsentence, "wish"), turn.language.their_words(said)
    if not say_from_pool(turn, pool, words={"what": returned}):
        return False
    turn.note("stay", f"Somebody of theirs, or nothing known: stay with the person ({pool}).")
    if returned.casefold() != said.casefold():
        listen(turn)
    elif pool == "averse":
        carry_on(turn)
    else:
        listen(turn, "w")
    return True


def listen(turn: Turn, ordering: str = "cwc") -> None:
    """Make listening the topic: c w c, without proposals."""
    node = turn.content.tree.by_key.get(ON_YOUR_MIND)
    if node:
        turn.state = turn.state.with_topic_started(node.number)
        turn.change(ordering=ordering, siblings=0, noes=0)
