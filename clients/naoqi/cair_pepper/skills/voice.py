# -*- coding: utf-8 -*-
"""Volume, speed of the voice, brightness of the tablet."""

from __future__ import unicode_literals

from cair_pepper.skills import Skill
from cair_pepper.words import LEVELS, meant

STEP = 0.2


def skills(body):
    """Return them by action."""

    def volume(parameters):
        body.voice.set_volume(parameters.get("level") or "louder")

    def voicespeed(parameters):
        body.voice.set_speed(parameters.get("level") or "slower")

    def brightness(parameters):
        level = parameters.get("level") or meant(body.ask(body.text("ask_brightness")), LEVELS)
        if level not in ("higher", "lower"):
            return body.text("never_mind")
        now = body.services.call("ALTabletService", "getBrightness")
        wanted = now + (STEP if level == "higher" else -STEP)
        body.services.call("ALTabletService", "setBrightness", max(0.2, min(1.0, wanted)))
        return None

    return {
        "volume": Skill(lambda: body.services.has("ALAudioDevice"), volume),
        "voicespeed": Skill(lambda: body.services.has("ALTextToSpeech"), voicespeed),
        "brightness": Skill(lambda: body.services.has("ALTabletService"), brightness),
    }
