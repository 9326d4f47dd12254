# -*- coding: utf-8 -*-
"""The robot's map and the places on it, in a small file one may edit.

{"map": "/home/….explo", "places": {"kitchen": {"position": [1.5, 0, 0], "names": ["cucina"]}}}

`names` are other names of the same place, in any language.
"""

from __future__ import unicode_literals

import io
import json
import logging
import os
import re

from cair_pepper.services import UnableError

_log = logging.getLogger(__name__)

ATTEMPTS = 3  # a person in the way has often gone by the next
ARTICLES = r"(?i)^(?:the|my|our|your|il|lo|la|i|le|gli|mia|mio)\s+|^l'"


class Places(object):
    """Known places, through ALNavigation.

    folder -- where places.json is kept.
    """

    def __init__(self, folder, services):
        self._path = os.path.join(folder, "places.json")
        self._services = services
        self._kept = {"map": "", "places": {}}

    def load(self):
        """Read the file, and let the robot find itself on the map, if there is one."""
        try:
            with io.open(self._path, encoding="utf-8") as file:
                kept = json.loads(file.read())
            self._kept = {"map": kept.get("map", ""), "places": dict(kept.get("places", {}))}
        except (EnvironmentError, ValueError, AttributeError, TypeError) as error:
            _log.info("No places yet: %s", error)
        if self._kept["map"]:
            navigation = "ALNavigation"
            self._services.quietly(navigation, "loadExploration", self._kept["map"])
            self._services.quietly(navigation, "relocalizeInMap", [0.0, 0.0, 0.0])
            self._services.quietly(navigation, "startLocalization")

    def explore(self, metres):
        """Go around, make a map, return its path. It begins at the dock. Raises UnableError."""
        self._services.call("ALNavigation", "explore", float(metres))
        path = self._services.call("ALNavigation", "saveExploration")
        self._save({"map": path, "places": {}})
        return path

    def names(self):
        """Return the names of the places."""
        return sorted(self._kept["places"])

    def learn(self, name):
        """Store under this name where the robot is. Raises UnableError where it does not know."""
        position = self._services.call("ALNavigation", "getRobotPositionInMap")[0]
        places = dict(self._kept["places"])
        known = self._key(name) or _plain(name)
        names = places.get(known, {}).get("names", [])
        places[known] = {"position": [float(one) for one in position], "names": names}
        self._save({"map": self._kept["map"], "places": places})

    def be_at(self, name):
        """Take it that the robot is here; False for an unknown place. Raises UnableError."""
        position = self._position(name)
        if position is None:
            return False
        self._services.call("ALNavigation", "relocalizeInMap", position)
        self._services.quietly("ALNavigation", "startLocalization")
        return True

    def knows(self, name):
        """Say whether there is such a place."""
        return self._key(name) is not None

    def go(self, name, given_up):
        """Go there; False where it was not reached. given_up() says that nobody wants it now."""
        position = self._position(name)
        for _ in range(ATTEMPTS):
            if given_up():
                return False
            if _arrived(self._services.call("ALNavigation", "navigateToInMap", position)):
                return True
        return False

    def forget(self):
        """Forget the map and all places."""
        self._services.quietly("ALNavigation", "stopLocalization")
        self._save({"map": "", "places": {}})

    def _position(self, name):
        key = self._key(name)
        return (
            None if key is None else [float(one) for one in self._kept["places"][key]["position"]]
        )

    def _key(self, name):
        wanted = _plain(name)
        for key, place in self._kept["places"].items():
            if wanted in [_plain(one) for one in [key] + list(place.get("names", []))]:
                return key
        return None

    def _save(self, kept):
        folder = os.path.dirname(self._path)
        try:
            if not os.path.isdir(folder):
                os.makedirs(folder)
            with io.open(self._path + ".new", "wb") as file:
                file.write(json.dumps(kept, indent=1, sort_keys=True).encode("ascii"))
                file.flush()
                os.fsync(file.fileno())
            os.rename(self._path + ".new", self._path)
        except EnvironmentError as error:
            raise UnableError("%s: %s" % (self._path, error))
        self._kept = kept


def _arrived(answer):
    """Say what the answer of navigateToInMap means: an error code, 0 is well; older: a bool."""
    if answer is None or isinstance(answer, bool):
        return answer is not False
    return answer == 0


def _plain(name):
    return re.sub(ARTICLES, "", (name or "").strip().lower(), flags=re.UNICODE).strip()
