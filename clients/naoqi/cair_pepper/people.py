# -*- coding: utf-8 -*-
"""Whom the robot talks with, and the file of each person's talk. Nothing of it leaves the robot."""

from __future__ import unicode_literals

import io
import json
import logging
import os

_log = logging.getLogger(__name__)


class People(object):
    """The person who registered last, else the one of the settings.

    folder -- where the files are kept.
    """

    def __init__(self, folder, person):
        self._folder = folder
        self._person = person
        self._path = os.path.join(folder, "person.json")

    def present(self):
        """Return the person's name, "" for nobody known."""
        try:
            with io.open(self._path, encoding="utf-8") as file:
                return json.loads(file.read())["person"] or ""
        except (EnvironmentError, ValueError, LookupError, TypeError):
            return self._person

    def keep(self, person):
        """Remember who registered; a full disk does no harm."""
        try:
            if not os.path.isdir(self._folder):
                os.makedirs(self._folder)
            with io.open(self._path, "wb") as file:
                file.write(json.dumps({"person": person}).encode("ascii"))
        except EnvironmentError as error:
            _log.error("The person's name is not kept: %s", error)

    def talk_file(self, person):
        """Return the path of a person's state, for names in any letters."""
        letters = [one if _is_plain(one) else "-%x" % ord(one) for one in person.lower()]
        return os.path.join(self._folder, "talks", ("".join(letters) or "talk") + ".json")

    def has_talked(self, person):
        """Say whether there is a talk to go on with."""
        return os.path.exists(self.talk_file(person))


def _is_plain(letter):
    return letter.isalnum() and ord(letter) < 128
