"""The table of KBplan actions."""

from dialogue.engine.actions.table import ACTIONS
from plans.engine.kb_actions import KB_ACTIONS_BY_NAME


def test_every_action_that_experts_can_write_is_carried_out():
    assert set(ACTIONS) == set(KB_ACTIONS_BY_NAME)
