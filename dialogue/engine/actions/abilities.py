"""abilities: the person asks what the agent can do."""

from collections.abc import Mapping

from dialogue.engine.saying import say_from_pool
from dialogue.engine.turn import Turn
from plans.engine.capabilities import can_do

HOW_MANY = 4


def abilities(turn: Turn, parameters: Mapping[str, str | None]) -> bool:
    """Name a few things this robot can do, of different kinds, and ask what the person wants."""
    language = turn.state.language
    found: dict[str, list[str]] = {}
    for intent in turn.content.catalogue.intents.values():
        if language in intent.abilities and can_do(intent, turn.heard.capabilities):
            found.setdefault(intent.family, []).append(intent.abilities[language])
    families = turn.chance.sample(sorted(found), min(HOW_MANY, len(found)))
    names = tuple(turn.chance.choice(found[family]) for family in families)
    turn.note("abilities", f"{len(names)} of {sum(map(len, found.values()))} abilities named.")
    if not names:
        return False
    return say_from_pool(turn, "abilities", words={"list": turn.language.listed(names)})
