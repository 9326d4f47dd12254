# -*- coding: utf-8 -*-
"""Behaviours and media: greetings, hugs, songs, films."""

from __future__ import unicode_literals

import logging
import threading

from cair_pepper.services import UnableError
from cair_pepper.skills import Skill
from cair_pepper.words import LEVELS, listed, meant

_log = logging.getLogger(__name__)

GESTURES = ("hello", "namaste", "konnichiwa", "attention", "hug", "handshake", "followme")
GESTURES += ("dance", "quiz")
MEDIA = ("playsong", "playkaraoke", "playmovie", "showinstructions", "showexercise")
LET_CHOOSE = ("playkaraoke", "playmovie")
ASKED = {"call": ("who", "ask_whom"), "light": ("level", "ask_light")}
LONGEST_LIST = 4
PICTURES = (".png", ".jpg", ".jpeg", ".gif")
SECONDS_FOR_A_PICTURE = 20.0
LONGEST_VIDEO = 3 * 3600.0  # seconds


def skills(body):
    """Return them by action."""
    found = {}
    for action in GESTURES:
        found[action] = _gesture(body, action)
    for action in ASKED:
        found[action] = _asking(body, action)
    for action in MEDIA:
        found[action] = _media(body, action)
    return found


def _gesture(body, action):
    def do(parameters):
        return _run(body, action, parameters)

    return Skill(lambda: bool(body.behaviour(action)), do)


def _asking(body, action):
    """Return a behaviour that needs its parameter."""
    name, question = ASKED[action]

    def do(parameters):
        value = parameters.get(name)
        if value is None:
            value = body.ask(body.text(question))
            value = meant(value, LEVELS) if action == "light" else value
        if not value:
            return body.text("never_mind")
        return _run(body, action, {name: value})

    return Skill(lambda: bool(body.behaviour(action)), do)


def _run(body, action, parameters):
    behaviour = body.behaviour(action)
    if not behaviour:  # It was there when the plan was asked for.
        _log.warning("The behaviour of %s is not installed.", action)
        return body.text("not_learned")
    body.run(behaviour, parameters)
    return None


def _media(body, action):
    """Titles of the settings; others are left to the behaviour, which sees the title."""

    def titles():
        return body.settings["media"].get(action, {})

    def able():
        return bool(titles() or body.behaviour(action))

    def do(parameters):
        wanted = parameters.get("title") or parameters.get("what")
        if not titles():
            return _run(body, action, parameters)
        return _play_one(body, action, wanted, titles())

    return Skill(able, do)


def _play_one(body, action, wanted, titles):
    shown = listed(sorted(titles)[:LONGEST_LIST], body.language)
    if wanted is None and action in LET_CHOOSE:
        wanted = body.ask(body.text("ask_title", titles=shown))
        if wanted is None:
            return body.text("never_mind")
    title = body.chance.choice(sorted(titles)) if wanted is None else _like(wanted, titles)
    if title is not None:
        return _play(body, titles[title], {"title": title})
    if body.behaviour(action):
        return _run(body, action, {"title": wanted})
    return body.text("no_title", title=wanted, titles=shown)


def _like(wanted, titles):
    """Return the title that is meant, None where there is none: "volare" is "Nel blu (Volare)"."""
    wanted = wanted.lower().strip()
    for title in sorted(titles):
        known = title.lower()
        if wanted == known or wanted in known or known in wanted:
            return title
    return None


def _play(body, where, parameters):
    if where.lower().endswith(PICTURES):
        body.tablet.picture(where)
        body.touched.wait(SECONDS_FOR_A_PICTURE)
    elif where.startswith(("http://", "https://")):
        _watch(body, where)
    elif where.startswith("/"):
        _log.info("plays: %s", where)
        body.services.call("ALAudioPlayer", "playFile", where)
    elif body.installed(where):
        body.run(where, parameters)
    else:
        _log.warning("The behaviour %s is not installed.", where)
        return body.text("not_learned")
    return None


def _watch(body, address):
    """Show a video to its end, or until somebody touches the head."""
    ended = threading.Event()
    try:
        forget = body.services.on_signal("ALTabletService", "videoFinished", ended.set)
    except UnableError as unable:
        _log.info("Nobody will say when the video ends: %s", unable)
        body.tablet.play(address)
        return
    try:
        body.tablet.play(address)
        waited = 0.0
        while waited < LONGEST_VIDEO and not ended.is_set() and not body.touched.is_set():
            ended.wait(0.2)
            waited += 0.2
    finally:
        forget()
        body.tablet.stop()
