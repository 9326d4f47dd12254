# -*- coding: utf-8 -*-
"""What must be looked up elsewhere: a function of your own for each, named in the settings.

    "lookups": {"weather": "my_lookups:weather"}

    def weather(parameters, language, settings):
        return "It is sunny in " + (parameters["city"] or settings["city"])

It returns the text to be said, "" where it found nothing, and may raise what it likes. An action
without a function is left out of `capabilities`: the server then says that the robot cannot do it.
"""

from __future__ import unicode_literals

import importlib
import logging

from cair_pepper.skills import Skill

_log = logging.getLogger(__name__)

#: action -> what is asked for where nobody said it: (parameter, question)
NEEDED = {
    "weather": (),
    "news": (),
    "wikisearch": (("what", "ask_what"),),
    "dictionary": (("what", "ask_what"),),
    "translate": (("what", "ask_translate"), ("language", "ask_language")),
}


def skills(body):
    """Return them by action."""
    found = {}
    for action in NEEDED:
        function = _function(body.settings["lookups"].get(action, ""))
        if function is not None:
            found[action] = _skill(body, action, function)
    return found


def _skill(body, action, function):
    def do(parameters):
        parameters = dict(parameters)
        for name, question in NEEDED[action]:
            parameters[name] = body.asked(parameters.get(name), question)
            if not parameters[name]:
                return body.text("never_mind")
        return function(parameters, body.language, body.settings) or body.text("nothing_found")

    return Skill(lambda: True, do)


def _function(named):
    """Return the function of "module:function", None where there is none: logged."""
    module, _, name = named.partition(":")
    if not module or not name:
        if named:
            _log.error('"%s" names no look-up. Example: my_lookups:weather', named)
        return None
    try:
        return getattr(importlib.import_module(str(module)), str(name))
    except Exception:  # noqa: BLE001 - logged; a look-up that is broken must not stop the robot
        _log.exception("There is no look-up %s.", named)
        return None
