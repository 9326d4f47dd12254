# -*- coding: utf-8 -*-
"""Steps, walks, and turning away for privacy. NAOqi's own collision protection stays on."""

from __future__ import unicode_literals

import logging
import math

from cair_pepper.labels import privacy_label
from cair_pepper.services import UnableError
from cair_pepper.skills import Skill
from cair_pepper.tablet import PRIVACY
from cair_pepper.words import DIRECTIONS, meant

_log = logging.getLogger(__name__)

STEP = 0.2  # metres
SPEED = 0.5  # of the fastest
LONGEST_WALK = 20.0  # seconds
WAYS = {"forward": (1, 0), "back": (-1, 0), "left": (0, 1), "right": (0, -1)}
BOWED = 0.4  # radians: the head looks down
FACE = "FaceLeds"


def skills(body):
    """Return them by action."""

    def has_legs():
        return body.services.has("ALMotion")

    def move(parameters):
        way = _way(body, parameters)
        if way is None:
            return body.text("never_mind")
        moved = body.services.call("ALMotion", "moveTo", STEP * way[0], STEP * way[1], 0.0)
        return body.text("blocked") if moved is False and not body.touched.is_set() else None

    def go(parameters):
        way = _way(body, parameters)
        return body.text("never_mind") if way is None else _walk(body, way)

    return {
        "move": Skill(has_legs, move),
        "go": Skill(has_legs, go),
        "privacy": Skill(has_legs, lambda parameters: _look_away(body)),
    }


def _way(body, parameters):
    where = parameters.get("where") or meant(body.ask(body.text("ask_direction")), DIRECTIONS)
    return WAYS.get(where)


def _walk(body, way):
    """Walk until touched or blocked."""
    body.services.call("ALMotion", "moveToward", SPEED * way[0], SPEED * way[1], 0.0)
    waited, walking = 0.0, True
    try:
        while waited < LONGEST_WALK and walking and not body.touched.wait(0.2):
            waited += 0.2
            walking = body.services.call("ALMotion", "moveIsActive")
    finally:
        body.services.quietly("ALMotion", "stopMove")
    return None if walking else body.text("blocked")


def _look_away(body):
    """Turn around, cover the eyes, hear nothing, until somebody touches the head."""
    services = body.services
    services.quietly("ALBasicAwareness", "setEnabled", False)
    body.looks_away = True
    try:
        services.call("ALMotion", "moveTo", 0.0, 0.0, math.pi)
        services.quietly("ALLeds", "fadeRGB", FACE, 0x000000, 0.5)
        services.quietly("ALMotion", "setAngles", ["HeadPitch"], [BOWED], 0.1)
        if body.behaviour("privacy"):
            _cover_eyes(body)
        body.tablet.show(PRIVACY, privacy_label(body.language))
        while not body.touched.wait(1.0):
            pass
    finally:
        body.touched.clear()  # It meant: look at me again.
        services.quietly("ALLeds", "fadeRGB", FACE, 0xFFFFFF, 0.5)
        services.quietly("ALMotion", "setAngles", ["HeadPitch"], [0.0], 0.1)
        services.quietly("ALMotion", "moveTo", 0.0, 0.0, math.pi)
        services.quietly("ALBasicAwareness", "setEnabled", True)
        body.looks_away = False


def _cover_eyes(body):
    try:
        body.run(body.behaviour("privacy"))
    except UnableError as unable:
        _log.warning("Eyes not covered: %s", unable)
