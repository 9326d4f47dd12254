# -*- coding: utf-8 -*-
"""New people, photos, and calling for help."""

from __future__ import unicode_literals

import json
import logging
import threading
import time

from cair_pepper.skills import Skill
from cair_pepper.words import NAMES, without_frame

try:
    from urllib.request import Request, urlopen  # novermin
except ImportError:  # Python 2.7
    from urllib2 import Request, urlopen  # novermin

_log = logging.getLogger(__name__)

SECONDS = 4.0  # for one attempt to call somebody
PAUSES = (2.0, 5.0, 10.0, 20.0)  # seconds between further attempts
LONGEST_NAME = 40


def skills(body):
    """Return them by action."""

    def alerts():
        wanted = body.settings["alert"]
        return bool(wanted["event"] or wanted["url"] or body.behaviour("alert"))

    return {
        "alert": Skill(alerts, lambda found: _alert(body)),
        "registration": Skill(lambda: True, lambda found: _register(body)),
        "photo": Skill(lambda: body.services.has("ALPhotoCapture"), lambda found: _photo(body)),
    }


def _alert(body):
    """Tell whoever is to be told; that nobody could be told is said."""
    wanted = body.settings["alert"]
    told = {"robot": body.settings["robot_name"], "person": body.settings["person"]}
    done = []
    if wanted["event"]:
        done.append(_raised(body, wanted["event"], told))
    if wanted["url"]:
        done.append(_posted(wanted["url"], told))
        if not done[-1]:
            _post_later(wanted["url"], told)
    behaviour = body.behaviour("alert")
    if behaviour:
        body.run(behaviour, told)
        done.append(True)
    return None if any(done) else body.text("alert_failed")


def _raised(body, event, told):
    try:
        body.services.call("ALMemory", "raiseEvent", event, json.dumps(told, sort_keys=True))
    except Exception:  # noqa: BLE001 - the other ways to call somebody must still be tried
        _log.exception("The alert was not raised.")
        return False
    return True


def _posted(url, told):
    data = json.dumps(told, sort_keys=True).encode("ascii")
    request = Request(str(url), data, {str("Content-Type"): str("application/json")})
    try:
        urlopen(request, timeout=SECONDS).close()
    except Exception as error:  # noqa: BLE001 - whatever it is, it is tried again
        _log.error("The alert was not delivered: %s", error)
        return False
    _log.info("alert delivered")
    return True


def _post_later(url, told):
    def again():
        for pause in PAUSES:
            time.sleep(pause)
            if _posted(url, told):
                return

    thread = threading.Thread(target=again)
    thread.daemon = True
    thread.start()


def _register(body):
    answer = body.ask(body.text("ask_name"))
    name = without_frame(answer, NAMES, body.language)[:LONGEST_NAME] if answer else ""
    if not name:
        return body.text("never_mind")
    body.meet(name if name != name.lower() else name.title())
    return None


def _photo(body):
    folder, name = (
        "/home/nao/recordings/cameras/",
        "cair_" + body.now().strftime(str("%Y%m%d_%H%M%S")),
    )
    body.services.call("ALPhotoCapture", "takePicture", folder, name)
    return
