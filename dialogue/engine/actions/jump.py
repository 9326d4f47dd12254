"""jump: the person brought a topic up (Algorithm 1, lines 9-14)."""

from collections.abc import Mapping

from dialogue.engine.find_topic import named_topic
from dialogue.engine.flow import begin
from dialogue.engine.sentence_types import SENTENCE_TYPES
from dialogue.engine.turn import Turn
from dialogue.engine.wishes import is_personal, stay_with


def jump(turn: Turn, parameters: Mapping[str, str | None]) -> bool:
    """Go to a known topic and say a sentence of the type asked for.

    Someone's own ("my wife") and the unknown are listened to instead of being overridden.
    """
    words = parameters.get("topic") or ""
    start = parameters.get("startsentence") or ""
    start = start if start in SENTENCE_TYPES else ""
    node = named_topic(turn, words)
    if node and not node.gentle and not is_personal(turn, words, node):
        # Who asks for a topic wants to be asked about it: the count of questions begins anew.
        turn.change(siblings=0, noes=0, questions=0)
        begin(turn, node, start=start, opinion=start == "p")
        return True
    if node and node.gentle:
        begin(turn, node)
        return True
    return stay_with(turn, words, start)
