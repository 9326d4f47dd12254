# -*- coding: utf-8 -*-
"""The walk of docs and tests: greet, play a song, go to the kitchen, charge, privacy, hug.

Run as a program by any Python: arguments are the server's address and a folder; prints the log.
"""

# ruff: noqa: RUF005, UP009, UP010

from __future__ import unicode_literals

import json
import os
import sys
import threading

KITCHEN = {"position": [4.0, 1.5, 0.0], "names": ["cucina", "台所"]}
SAID = {
    "en": ("Hello", "Play the song Hey Brother", "Go to the kitchen", "Go to charge", "Wake up")
    + ("Give me some privacy", "Give me a hug"),
    "it": ("Ciao", "Suona la canzone Hey Brother", "Vai in cucina", "Vai a caricarti", "Svegliati")
    + ("Dammi un po' di privacy", "Dammi un abbraccio"),
    "ja": ("ハロー", "Hey Brotherという曲をかけて", "台所に行って", "充電して", "起きて")
    + ("見ないで", "ハグして"),
}
PRIVACY = 5  # its place among what is said


def prepared(folder):
    """Write the places the robot knows; return the settings of the walk."""
    if not os.path.isdir(folder):
        os.makedirs(folder)
    with open(os.path.join(folder, "places.json"), "wb") as file:
        file.write(json.dumps({"places": {"kitchen": KITCHEN}}).encode("ascii"))
    return {"folder": folder, "media": {"playsong": {"Hey Brother": "cair/playsong"}}}


def walk(pepper, language):
    """Let a person say it all; return the log."""
    pepper.memory.wait_until_it_listens()
    for place, sentence in enumerate(SAID[language]):
        if place == PRIVACY:
            pepper.notes.when("tablet: privacy", pepper.touch_soon)
        pepper.turn(sentence)
    return list(pepper.notes.lines)


def masked(lines):
    """Return what the robot does: sentences of the server are not what is compared."""
    kept = []
    for line in lines:
        line = "says" if line.startswith("says: ") else line
        if line != "says" or kept[-1:] != ["says"]:
            kept.append(line)
    return kept


def spoken(lines):
    """Return what the robot says."""
    return [line for line in lines if line.startswith("says: ")]


def done(lines):
    """Return what the robot does."""
    return [line for line in lines if not line.startswith(("says: ", "tablet: "))]


def main(address, folder, language):
    """Print the log as JSON."""
    here = os.path.dirname(os.path.abspath(__file__))
    clients = os.path.join(here, "..", "..", "..", "clients")
    sys.path[:0] = [here, os.path.join(clients, "naoqi"), os.path.join(clients, "python")]
    from cair_pepper.robot import Robot
    from cair_pepper.settings import read_settings
    from fake_robot import without_qi

    pepper = without_qi()
    own = dict(prepared(folder), server=address, language=language, seed=7, echo=0, person="Anna")
    robot = Robot(pepper.session, read_settings(json.dumps(own)))
    thread = threading.Thread(target=robot.run)
    thread.start()
    try:
        log = walk(pepper, language)
    finally:
        robot.end()
        thread.join(20)
    sys.stdout.write(json.dumps(log))


if __name__ == "__main__":
    main(*sys.argv[1:])
