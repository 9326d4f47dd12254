# -*- coding: utf-8 -*-
"""What the robot can do: one Skill for each action of docs/plans.md."""

from __future__ import unicode_literals

from collections import namedtuple


class Skill(namedtuple(str("Skill"), (str("able"), str("do")))):
    """able() says whether the robot can do it now; do(parameters) does it.

    `parameters` has a text for each name, None where nobody said it. A text that do() returns is
    said. It may raise UnableError.
    """

    __slots__ = ()


def all_skills(body):
    """Return the skills of a robot by action. `body` is a Body."""
    from cair_pepper.skills import clock, gestures, lookups, motion, people, places, voice

    skills = {}
    for module in (gestures, voice, motion, places, clock, lookups, people):
        skills.update(module.skills(body))
    return skills
