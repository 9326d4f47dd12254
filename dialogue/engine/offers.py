"""An activity on offer: the answer yes brings its plan (paper, "Request to Dialogue Manager")."""

from collections.abc import Mapping

from dialogue.engine.answers import FAVOURABLE, UNFAVOURABLE
from dialogue.engine.saying import say_from_pool
from dialogue.engine.tree import Proposal
from dialogue.engine.turn import NO_WORDS, Turn
from languages.language import Attitude
from languages.templates import Template, TemplateError
from plans.engine.manager import carry_out


def answer_offer(turn: Turn, proposal: Proposal, attitude: Attitude) -> None:
    """Run the activity after a yes, let it be after a no; else it is an ordinary sentence."""
    if attitude in FAVOURABLE:
        _accept(turn, proposal)
    elif attitude in UNFAVOURABLE:
        turn.note("offer", f"{proposal.intent} refused")
        say_from_pool(turn, "goal_refused")


def _accept(turn: Turn, proposal: Proposal) -> None:
    parameters = {
        name: text
        for name, templates in proposal.parameters
        if (text := _filled(turn, templates)) is not None
    }
    turn.plan = carry_out(
        turn.content.catalogue,
        proposal.intent,
        parameters,
        turn.state.language,
        culture=turn.state.culture,
        chance=turn.chance,
        capabilities=turn.heard.capabilities,
    )
    turn.note("offer", f"{proposal.intent} accepted: {turn.plan.plan}")
    if not turn.plan.plan_sentence:
        say_from_pool(turn, "goal_accepted")


def _filled(turn: Turn, templates: Mapping[str, Template]) -> str | None:
    node, language = turn.node, turn.state.language
    if node is None or language not in node.names:
        return None
    variables = node.variables.get(language, NO_WORDS)
    try:
        return templates[language].fill({"hasName": node.names[language]}, variables)
    except TemplateError:
        return None
