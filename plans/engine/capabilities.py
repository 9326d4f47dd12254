"""What a client can do: the actions it names, else those that every client has."""

from collections.abc import Collection

from plans.engine.actions import COMMON_ACTIONS
from plans.engine.intents import Intent


def able(action: str, capabilities: Collection[str] | None) -> bool:
    """Say whether a client can do an action; None is a client that names none."""
    return action in (COMMON_ACTIONS if capabilities is None else capabilities)


def can_do(intent: Intent, capabilities: Collection[str] | None) -> bool:
    """Say whether a client can do all that an intent plans."""
    return all(able(item.action, capabilities) for item in intent.plan)
