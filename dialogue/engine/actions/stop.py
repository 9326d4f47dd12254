"""stop: the person wants to end the talk."""

from collections.abc import Mapping

from dialogue.engine.saying import say_from_pool
from dialogue.engine.turn import Turn


def stop(turn: Turn, parameters: Mapping[str, str | None]) -> bool:
    """Say goodbye; the state keeps everything for the next time."""
    say_from_pool(turn, "end")
    turn.change(ended=True, questions=0)
    turn.note("stop", "The person ended the talk.")
    return True
