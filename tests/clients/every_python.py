# -*- coding: utf-8 -*-
"""A short talk, as any Python can have it, told as JSON. Arguments: server, state file."""

# ruff: noqa: UP003, UP009, UP010, UP012, UP018

from __future__ import unicode_literals

import json
import os
import ssl
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "..", "clients", "python"))

import cair_client
from cair_client import CairError, Conversation, UnreachableError


def code_of(call):
    """Return the code of the error a call raises."""
    try:
        call()
    except UnreachableError as error:
        return "unreachable " + error.code
    except CairError as error:
        str(error), repr(error)
        return error.code
    return ""


def talked(address, kept):
    """Return what a robot said, did and kept."""
    log = []
    talk = Conversation(address, str("it"), state_file=kept, person="Zoë", seed=7)
    talk.on(str("playsong"), lambda action: "Ecco " + (action.parameters["title"] or "-"))
    talk.perform(talk.start(), log.append)
    log.extend(talk.perform(talk.say("Suona la canzone Perché no"), log.append))
    again = Conversation(address, state_file=kept, person="Zoë".encode("utf-8"))
    log.append(again.start().text)
    log.append(again.say("Mi piace il tè".encode("utf-8")).text)
    with open(kept, "w") as spoiled:
        spoiled.write(str("{"))
    log.append(Conversation(address, "ja", state_file=kept, seed=7).start())
    return log


def main(address, kept):
    """Print a report."""
    log = talked(address, kept)
    texts = [type(text) is type("") for text in log[:-1]]
    unreachable = Conversation("http://127.0.0.1:9", patience=0.2)
    wrong = Conversation(address, language="xx")
    report = {
        "log": log,
        "all unicode": all(texts),
        "kept": sorted(name.split("-")[0] for name in os.listdir(os.path.dirname(kept))),
        "errors": [code_of(unreachable.start), code_of(wrong.start)],
        "no tls": without_tls(),
    }
    sys.stdout.write(json.dumps(report, sort_keys=True))


def without_tls():
    """Return what a Python says that cannot verify certificates, as those of old robots."""
    kept = ssl.create_default_context
    del ssl.create_default_context
    try:
        Conversation("http://127.0.0.1")
        return code_of(lambda: cair_client.Conversation("https://127.0.0.1"))
    finally:
        ssl.create_default_context = kept


main(sys.argv[1], sys.argv[2])
