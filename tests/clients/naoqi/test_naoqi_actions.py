"""What a robot is asked for is done; what was not said is asked for; what fails is told."""

import datetime
import random

import pytest

from tests.clients.naoqi.walk import prepared, spoken

NOON = datetime.datetime(2026, 11, 21, 12, 0)  # noqa: DTZ001 - a robot's clock has no zone


FILMS = {"Totò": "http://x/toto.mp4", "Casablanca": "x/y"}


def test_what_was_not_said_is_asked_for(pepper, address, let_talk):
    let_talk(
        pepper, address, media={"playmovie": {"Totò": "http://x/toto.mp4", "Casablanca": "x/y"}}
    )
    pepper.person("Play a film")
    pepper.notes.wait_for("says: I have Casablanca and Totò. Which one would you like?")
    before = pepper.memory.times_opened
    pepper.person("Totò please")
    pepper.notes.wait_for("tablet: video http://x/toto.mp4")
    pepper.offered["ALTabletService"].videoFinished()
    pepper.notes.wait_for("tablet: dialogue")
    pepper.memory.wait_until_it_listens(before)


def test_a_question_nobody_answers_is_dropped_kindly(plain_pepper, address, let_talk):
    let_talk(plain_pepper, address, answer_seconds=0.4)
    plain_pepper.person("I want to register")
    plain_pepper.notes.wait_for("says: I would love to get to know you.")
    plain_pepper.notes.wait_for("says: Never mind, then.")


def test_somebody_new_registers_and_has_a_talk_of_their_own(
    plain_pepper, address, let_talk, tmp_path
):
    let_talk(plain_pepper, address)
    plain_pepper.person("I want to register")
    plain_pepper.notes.wait_for("says: I would love to get to know you.")
    plain_pepper.person("My name is Dorothy.")
    plain_pepper.notes.wait_for("tablet: dialogue")
    plain_pepper.notes.wait_for("says: ")
    plain_pepper.memory.wait_until_it_listens()
    files = {path.name for path in (tmp_path / "cair" / "talks").glob("*.json")}
    assert files == {"anna.json", "dorothy.json"}


def test_a_song_that_is_not_there_is_told_with_those_that_are(plain_pepper, address, let_talk):
    plain_pepper.behaviours.installed.discard("cair/playsong")
    let_talk(plain_pepper, address, media={"playsong": {"Volare": "songs/volare"}})
    lines = plain_pepper.turn("Play the song Hey Brother")
    assert "says: I am sorry, I do not have Hey Brother. But I do have Volare." in lines
    plain_pepper.behaviours.installed.add("songs/volare")
    assert "behaviour: songs/volare" in plain_pepper.turn("Play the song Volare")


def test_a_picture_is_shown_until_it_is_touched(plain_pepper, address, let_talk):
    shown = "http://198.18.0.1/apps/cair/knot.png"
    let_talk(plain_pepper, address, media={"showinstructions": {"tie a tie": shown}})
    plain_pepper.notes.when("tablet: picture", plain_pepper.touch_soon)
    lines = plain_pepper.turn("Show me how to tie a tie")
    assert "tablet: picture " + shown in lines


def test_any_song_is_one_of_those_there_are(plain_pepper, address, let_talk):
    songs = {"Volare": "songs/volare", "Azzurro": "songs/azzurro"}
    plain_pepper.behaviours.installed |= set(songs.values())
    let_talk(plain_pepper, address, media={"playsong": songs}, chance=random.Random(3))
    lines = plain_pepper.turn("Play a song")
    assert [line for line in lines if line.startswith("behaviour: songs/")]


@pytest.mark.parametrize(
    "pair",
    [
        ("Turn up the volume", "voice: volume 70"),
        ("Speak more slowly", "voice: speed 75"),
        ("Step to the left", "motion: 0.0 m ahead, 0.2 m left, turn 0.0"),
        ("This is the garden", None),
        ("You are in the kitchen", "navigation: is at 4.0 1.5"),
        ("Go to the garden", "says: I am sorry, I do not know yet where that is."),
        ("Forget the map", "navigation: no map"),
        ("Wake up", "dock: leaves"),
        ("What time is it?", "says: It is noon."),
        ("What day is it?", "says: Today is Saturday, the 21st of November."),
    ],
)
def test_what_a_person_says_is_done(plain_pepper, address, let_talk, tmp_path, pair):
    said, does = pair
    own = prepared(str(tmp_path / "cair"))
    let_talk(plain_pepper, address, now=lambda: NOON, **own)
    lines = plain_pepper.turn(said)
    assert spoken(lines)
    assert does is None or [line for line in lines if line.startswith(does)], lines


def test_a_place_that_was_learned_is_found(plain_pepper, address, let_talk):
    let_talk(plain_pepper, address)
    plain_pepper.turn("This is the garden")
    assert "navigation: to 1.0 2.0" in plain_pepper.turn("Go to the garden")


def test_a_person_in_the_way_is_waited_for_but_no_wall(plain_pepper, address, let_talk, tmp_path):
    let_talk(plain_pepper, address, **prepared(str(tmp_path / "cair")))
    navigation = plain_pepper.offered["ALNavigation"]
    navigation.blocked = 2
    assert plain_pepper.turn("Go to the kitchen").count("navigation: to 4.0 1.5") == 3
    navigation.blocked = 9
    assert "says: I am sorry, I cannot get there. Something is in my way." in plain_pepper.turn(
        "Go to the kitchen"
    )


def test_it_goes_until_it_is_touched(pepper, address, let_talk):
    let_talk(pepper, address)
    pepper.memory.wait_until_it_listens()
    pepper.notes.when("motion: sets out", pepper.touch_soon)
    lines = pepper.turn("Keep going forward")
    assert "motion: sets out 0.5 0.0" in lines
    assert "motion: stops" in lines


def test_a_timer_rings(plain_pepper, address, let_talk):
    let_talk(plain_pepper, address)
    plain_pepper.turn("Set a timer for one second")
    plain_pepper.notes.wait_for("says: Your time is up!")


def test_a_dock_that_is_not_found_is_told(plain_pepper, address, let_talk):
    plain_pepper.offered["ALRecharge"].there = False
    let_talk(plain_pepper, address, language="it")
    lines = plain_pepper.turn("Vai a caricarti")
    assert "says: Non trovo la mia base di ricarica. Mi ci accompagni, per favore?" in lines


def weather(parameters, language, settings):
    if parameters["city"] == "Atlantis":
        raise OSError("No such city")
    return "Sunny in {}.".format(parameters["city"])


def test_a_look_up_of_ones_own_answers(plain_pepper, address, let_talk):
    own = {"weather": f"{__name__}:weather", "wikisearch": "no_such_module:nothing"}
    let_talk(plain_pepper, address, lookups=own)
    assert "says: Sunny in Genoa." in plain_pepper.turn("What's the weather like in Genoa?")
    lines = plain_pepper.turn("What's the weather like in Atlantis?")
    assert [line for line in lines if "that did not work just now" in line]
    assert spoken(plain_pepper.turn("Look up Dante on Wikipedia"))  # left out: the server says so
