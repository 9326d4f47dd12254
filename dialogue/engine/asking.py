"""Questions before a plan: a missing parameter, or whether something was meant.

Asked once, the bare answer understood, "never mind" is the way out.
"""

from collections.abc import Mapping

from dialogue.engine.answers import FAVOURABLE, UNFAVOURABLE
from dialogue.engine.saying import say_from_pool
from dialogue.engine.state import Pending
from dialogue.engine.turn import Asking, Turn
from languages.language import Attitude
from plans.engine.bare_answer import bare_value
from plans.engine.intents import Intent
from plans.engine.manager import carry_out

LONGEST_ANSWER = 200  # characters


def ask(turn: Turn) -> bool:
    """Ask for the parameter that the Plan Manager misses; the plan waits for the answer."""
    asking = turn.heard.asking
    if asking is None or not asking.pending.slot:
        return False
    turn.note("ask", f"{asking.pending.slot} is missing: asked for.")
    _ask(turn, asking)
    return True


def suggest(turn: Turn) -> bool:
    """Ask whether something nearly understood was meant, unless the sentence answered us."""
    asking = turn.heard.asking
    if asking is None or turn.parts or turn.plan or turn.waiting:
        return False
    if turn.state.last_type == "q" and _attitude(turn) is not Attitude.UNCLEAR:
        return False
    turn.note("suggest", "Nearly understood: asked whether it was meant.")
    _ask(turn, asking)
    return True


def _ask(turn: Turn, asking: Asking) -> None:
    turn.change(pending=asking.pending.cut_to_fit(), last_type="e", offer=0)
    turn.parts.append(asking.question)


def _attitude(turn: Turn) -> Attitude:
    return turn.language.attitude(turn.heard.sentence)


def take_answer(turn: Turn) -> bool:
    """Carry out what was waiting for this answer, unless the person asks for something else."""
    pending = turn.waiting
    if pending is None:
        return False
    intent = turn.content.catalogue.by_number.get(pending.intent)
    if intent is None or turn.heard.plan_matched or turn.heard.kbplan_actions:
        return False
    if not pending.slot:
        return _confirmed(turn, pending, intent)
    words = turn.heard.sentence.strip(" .。!！?？")[:LONGEST_ANSWER]
    refused = not words or _attitude(turn) in UNFAVOURABLE
    value = None if refused else _value(turn, intent, pending.slot, words)
    if value is None:
        turn.note("ask", f"No {pending.slot}: {intent.key} is let be.")
        say_from_pool(turn, "goal_refused")
        return False
    return _carry_out(turn, intent, {**dict(pending.parameters), pending.slot: value})


def _value(turn: Turn, intent: Intent, name: str, words: str) -> str | None:
    for slot in intent.slots:
        if slot.name == name:
            return bare_value(turn.content.catalogue, slot, words, turn.state.language)
    return None


def _confirmed(turn: Turn, pending: Pending, intent: Intent) -> bool:
    """Act after a yes to "Did you want me to ...?"; a no and anything else let it be."""
    attitude = _attitude(turn)
    if attitude in FAVOURABLE:
        return _carry_out(turn, intent, dict(pending.parameters))
    turn.note("ask", f"{intent.key} was not meant.")
    if attitude in UNFAVOURABLE:
        say_from_pool(turn, "goal_refused")
    return False


def _carry_out(turn: Turn, intent: Intent, parameters: Mapping[str, str]) -> bool:
    turn.plan = carry_out(
        turn.content.catalogue,
        intent.key,
        parameters,
        turn.state.language,
        culture=turn.state.culture,
        chance=turn.chance,
        capabilities=turn.heard.capabilities,
    )
    turn.note("ask", f"{intent.key}: {turn.plan.plan}")
    asks = turn.plan.question
    if asks:
        _ask(turn, Asking(Pending(intent.number, asks.slot, tuple(parameters.items())), asks.text))
        turn.plan = None
    return bool(asks)
