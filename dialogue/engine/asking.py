"""A missing parameter: asked for once, the bare answer understood, "never mind" the way out."""

from dialogue.engine.answers import UNFAVOURABLE
from dialogue.engine.saying import say_from_pool
from dialogue.engine.turn import Turn
from plans.engine.manager import carry_out

LONGEST_ANSWER = 200  # characters


def ask(turn: Turn) -> bool:
    """Ask for the parameter that the Plan Manager misses; the plan waits for the answer."""
    asking = turn.heard.asking
    if asking is None:
        return False
    turn.note("ask", f"{asking.pending.slot} is missing: asked for.")
    turn.change(pending=asking.pending.cut_to_fit(), last_type="e", offer=0)
    turn.parts.append(asking.question)
    return True


def take_answer(turn: Turn) -> bool:
    """Carry out what was waiting for this answer, unless the person asks for something else."""
    pending = turn.waiting
    if pending is None:
        return False
    intent = turn.content.catalogue.by_number.get(pending.intent)
    if intent is None or turn.heard.plan_matched or turn.heard.kbplan_actions:
        return False
    words = turn.heard.sentence.strip(" .。!！?？")[:LONGEST_ANSWER]
    if not words or turn.language.attitude(words) in UNFAVOURABLE:
        turn.note("ask", f"No {pending.slot}: {intent.key} is let be.")
        say_from_pool(turn, "goal_refused")
        return False
    turn.plan = carry_out(
        turn.content.catalogue,
        intent.key,
        {**dict(pending.parameters), pending.slot: words},
        turn.state.language,
        culture=turn.state.culture,
        chance=turn.chance,
        capabilities=turn.heard.capabilities,
    )
    turn.note("ask", f"{pending.slot} is given: {turn.plan.plan}")
    return False
