# -*- coding: utf-8 -*-
"""Places, the map and the dock."""

from __future__ import unicode_literals

import logging

from cair_pepper.services import UnableError
from cair_pepper.skills import Skill
from cair_pepper.words import PLACES, without_frame

_log = logging.getLogger(__name__)

DOCK = "docking station"


def skills(body):
    """Return them by action."""

    def navigates():
        return body.services.has("ALNavigation")

    def has_dock():
        return body.services.has("ALRecharge")

    return {
        "goto": Skill(lambda: navigates() or has_dock(), lambda found: _go(body, found)),
        "learnplace": Skill(navigates, lambda found: _learn(body, found)),
        "setposition": Skill(navigates, lambda found: _be_at(body, found)),
        "forgetmap": Skill(navigates, lambda found: body.places.forget()),
        "rest": Skill(lambda: body.services.has("ALMotion"), lambda found: _rest(body)),
        "wakeup": Skill(lambda: body.services.has("ALMotion"), lambda found: _wake_up(body)),
    }


def _go(body, parameters):
    where = parameters.get("where") or _place(body, "ask_where")
    if not where:
        return body.text("never_mind")
    if body.places.knows(where):
        arrived = body.places.go(where, body.touched.is_set)
        return None if arrived or body.touched.is_set() else body.text("not_arrived")
    if where != DOCK:
        return body.text("unknown_place")
    return None if _stand_before_dock(body) else body.text("no_dock")


def _place(body, question):
    answer = body.ask(body.text(question))
    return without_frame(answer, PLACES, body.language) if answer else None


def _stand_before_dock(body):
    """Say whether the robot stands before its dock."""
    try:
        found = body.services.call("ALRecharge", "lookForStation")
        seen = found[0] if isinstance(found, list) and found else found
        return bool(seen) and bool(body.services.call("ALRecharge", "moveInFrontOfStation"))
    except UnableError as unable:
        _log.warning("The dock was not found: %s", unable)
        return False


def _learn(body, parameters):
    where = parameters.get("where") or _place(body, "ask_place")
    if not where:
        return body.text("never_mind")
    try:
        body.places.learn(where)
    except UnableError as unable:
        _log.warning("The place was not learned: %s", unable)
        return body.text("no_map")
    return None


def _be_at(body, parameters):
    where = parameters.get("where") or _place(body, "ask_place")
    if not where:
        return body.text("never_mind")
    return None if body.places.be_at(where) else body.text("unknown_place")


def _rest(body):
    """Dock, or at least sit down: a robot that cannot find its dock should not fall."""
    if body.services.has("ALRecharge"):
        try:
            docked = body.services.call("ALRecharge", "dockOnStation")
        except UnableError as unable:
            _log.warning("Not docked: %s", unable)
            docked = False
        return None if docked else body.text("no_dock")
    body.services.call("ALMotion", "rest")
    return None


def _wake_up(body):
    if body.services.has("ALRecharge"):
        body.services.quietly("ALRecharge", "leaveStation")
    body.services.call("ALMotion", "wakeUp")
