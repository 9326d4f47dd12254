"""listen: the person speaks of a feeling or a need; the talk turns to them."""

from collections.abc import Mapping

from dialogue.engine.find_topic import topic_of_sentence
from dialogue.engine.flow import begin, carry_on
from dialogue.engine.saying import say_from_pool
from dialogue.engine.turn import Turn
from dialogue.engine.wishes import listen


def listen_now(turn: Turn, parameters: Mapping[str, str | None]) -> bool:
    """Stay with the person: say that we are here (c), or ask to hear more (w).

    A hard subject that they name, such as loneliness, is listened to as such.
    """
    turn.note("listen", "Stay with the person.")
    if parameters.get("startsentence") == "w":
        node = topic_of_sentence(turn, turn.heard.sentence)
        if node and node.gentle:
            begin(turn, node)
            return True
        listen(turn, "wcw")
        carry_on(turn)
        return True
    listen(turn)
    return say_from_pool(turn, "urgent")
