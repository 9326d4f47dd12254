# -*- coding: utf-8 -*-
"""Pepper's tablet: a page for each mode. NAO has none: its modes are in the log only."""

from __future__ import unicode_literals

import logging

from cair_pepper.services import native

try:
    from urllib.parse import urlencode  # novermin
except ImportError:  # Python 2.7
    from urllib import urlencode  # novermin

_log = logging.getLogger(__name__)

DIALOGUE, EXECUTION, PRIVACY = "dialogue", "execution", "privacy"


class Tablet(object):
    """Shows in which mode the robot is.

    pages -- the address of the folder `html` as the tablet sees it.
    """

    def __init__(self, services, pages):
        self._services = services
        self._pages = pages.rstrip("/") + "/"
        self._shown = None

    def show(self, mode, text=""):
        """Show a mode: DIALOGUE, EXECUTION or PRIVACY, with a few words below the picture."""
        if (mode, text) == self._shown:
            return
        self._shown = (mode, text)
        _log.info("tablet: %s%s", mode, " (%s)" % text if text else "")
        if self._services.has("ALTabletService"):
            address = "%s%s.html?%s" % (self._pages, mode, urlencode({"text": native(text)}))
            self._services.quietly("ALTabletService", "showWebview", address)

    def play(self, address):
        """Begin a video. Raises UnableError."""
        self._shown = None
        _log.info("tablet: video %s", address)
        if self._services.call("ALTabletService", "playVideo", address) is False:
            _log.warning("The tablet refused the video %s.", address)

    def picture(self, address):
        """Show a picture. Raises UnableError."""
        self._shown = None
        _log.info("tablet: picture %s", address)
        self._services.call("ALTabletService", "showImage", address)

    def stop(self):
        """Stop a video."""
        if self._services.has("ALTabletService"):
            self._services.quietly("ALTabletService", "stopVideo")

    def hide(self):
        """Show nothing of ours any more."""
        self._shown = None
        if self._services.has("ALTabletService"):
            self._services.quietly("ALTabletService", "hideWebview")
