# -*- coding: utf-8 -*-
"""The program on the robot: python2.7 -m cair_pepper settings.json."""

from __future__ import unicode_literals

import argparse
import io
import logging
import os
import sys

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "python"))

from cair_client import CairError
from cair_pepper.places import Places
from cair_pepper.robot import Robot
from cair_pepper.services import Services, UnableError
from cair_pepper.settings import SettingsError, read_settings

TROUBLE = (EnvironmentError, RuntimeError, ImportError, SettingsError, CairError, UnableError)
ABOUT = "Talk with people through a CAIR server, on Pepper or NAO."


def _options(arguments):
    parser = argparse.ArgumentParser(str("cair_pepper"), description=ABOUT)
    parser.add_argument("settings", help="settings file (JSON); README.md names what it may hold")
    parser.add_argument("--naoqi", default="tcp://127.0.0.1:9559", help="[%(default)s]")
    parser.add_argument("--explore", type=float, metavar="METRES", help="make a map, then end")
    parser.add_argument("--verbose", action="store_true", help="log more")
    return parser.parse_args(arguments)


def _connected(address):
    import qi

    session = qi.Session()
    session.connect(str(address))
    return session


def main(arguments=None):
    """Talk until Ctrl-C; return 0, or 1 where it cannot begin."""
    options = _options(arguments)
    level = logging.DEBUG if options.verbose else logging.INFO
    logging.basicConfig(level=level, format="%(asctime)s %(levelname)s %(name)s: %(message)s")
    try:
        with io.open(options.settings, encoding="utf-8") as file:
            settings = read_settings(file.read())
        session = _connected(options.naoqi)
        if options.explore:
            places = Places(settings["folder"], Services(session))
            logging.info("The map is in %s.", places.explore(options.explore))
            return 0
        robot = Robot(session, settings)
    except (
        EnvironmentError,
        RuntimeError,
        ImportError,
        SettingsError,
        CairError,
        UnableError,
    ) as error:
        logging.error("%s", error)
        return 1
    try:
        robot.run()
    except KeyboardInterrupt:
        robot.end()
    return 0


if __name__ == "__main__":
    sys.exit(main())
