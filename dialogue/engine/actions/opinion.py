"""opinion: the person asks what the agent thinks of something."""

from collections.abc import Mapping

from dialogue.engine.find_topic import named_topic
from dialogue.engine.flow import begin
from dialogue.engine.saying import say_from_pool
from dialogue.engine.turn import Turn
from dialogue.engine.wishes import LONGEST_WISH, is_personal, stay_with


def opinion(turn: Turn, parameters: Mapping[str, str | None]) -> bool:
    """Speak about a known topic without a yes/no question; without one, about this topic."""
    words = parameters.get("topic") or ""
    node = named_topic(turn, words) if words else turn.node
    if node is None or is_personal(turn, words, node):
        if not 0 < len(words.strip()) <= LONGEST_WISH:
            return False  # "If you ask me" would be all there is to say.
        said = say_from_pool(turn, "opinion")
        return stay_with(turn, words, "q") or said
    turn.change(siblings=0, noes=0)
    if not turn.heard.plan_said and not node.gentle:
        say_from_pool(turn, "opinion")
    begin(turn, node, opinion=not node.gentle)
    return True
