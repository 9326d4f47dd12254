"""A talk when things are not as one would like: missing behaviours, no network, touches, alerts."""

import datetime
import json
import threading
from http.server import BaseHTTPRequestHandler, HTTPServer

import pytest

from tests.clients.naoqi.walk import done, spoken
from tests.clients.network import Network
from tests.server.conftest import wait_for

NOON = datetime.datetime(2026, 11, 21, 12, 0)  # noqa: DTZ001 - a robot's clock has no zone
NOT_LEARNED = {
    "en": "says: I am sorry, I have not learned how to do that yet.",
    "it": "says: Mi dispiace, questo non l'ho ancora imparato.",
    "ja": "says: ごめんなさい、それはまだ覚えていないんです。",
}
HUG = {"en": "Give me a hug", "it": "Dammi un abbraccio", "ja": "ハグして"}


@pytest.fixture
def network(server):
    between = Network(server.port)
    between.up()
    yield between
    between.down()


def test_a_new_talk_begins_with_the_robots_name_and_the_persons(pepper, address, let_talk):
    let_talk(pepper, address, robot_name="Nao", person="Mrs Smith")
    pepper.memory.wait_until_it_listens()
    lines = pepper.notes.lines
    assert "voice: English" in lines
    assert "voice: speed 85" in lines
    assert "voice: volume 60" in lines
    assert spoken(lines)[0] == "says: I am Nao."
    assert not [line for line in lines if "$" in line]


@pytest.mark.parametrize("language", list(HUG))
def test_a_behaviour_that_is_not_installed_is_told_by_the_server(
    plain_pepper, address, let_talk, language
):
    plain_pepper.behaviours.installed.clear()
    let_talk(plain_pepper, address, language=language)
    lines = plain_pepper.turn(HUG[language])
    assert spoken(lines)
    assert done(lines) == []


@pytest.mark.parametrize("language", list(HUG))
def test_a_behaviour_that_vanished_meanwhile_is_told_politely(pepper, address, let_talk, language):
    let_talk(pepper, address, language=language)
    pepper.memory.wait_until_it_listens()
    pepper.notes.when("says: ", pepper.behaviours.installed.clear)
    lines = pepper.turn(HUG[language])
    assert NOT_LEARNED[language] in lines
    assert done(lines) == []
    assert spoken(pepper.turn({"en": "yes", "it": "sì", "ja": "はい"}[language]))


def test_a_behaviour_that_fails_does_not_end_the_talk(pepper, address, let_talk):
    pepper.behaviours.broken.add("cair/hug")
    let_talk(pepper, address)
    lines = pepper.turn("Give me a hug")
    assert (
        "says: I am sorry, that did not work just now. Shall we try again a little later?" in lines
    )
    assert spoken(pepper.turn("I love music"))


def test_a_robot_without_most_services_still_talks(plain_pepper, address, let_talk):
    for name in list(plain_pepper.offered):
        if name not in ("ALMemory", "ALAnimatedSpeech"):
            del plain_pepper.offered[name]
    let_talk(plain_pepper, address)
    for sentence in ("I love music", "Go to the kitchen", "Speak louder", "Give me a hug"):
        assert spoken(plain_pepper.turn(sentence))


def test_the_network_is_lost_and_the_talk_goes_on_where_it_was(pepper, network, let_talk):
    let_talk(pepper, network.address, person="", patience=2)
    pepper.turn("I love music")
    network.down()
    pepper.person("Play the song Hey Brother")
    pepper.notes.wait_for("says: Just a moment, please.")
    pepper.person("And what about tea?")  # while it waits it still hears
    threading.Timer(1.5, network.up).start()
    assert pepper.notes.wait_for('memory: CAIR/Parameters = {"title": "Hey Brother"}')
    pepper.notes.wait_for("behaviour: cair/playsong")
    pepper.notes.wait_for("tablet: dialogue")
    pepper.notes.wait_for("says: ")
    moments = [line for line in pepper.notes.lines if "Just a moment" in line]
    assert len(moments) == 1


def test_a_robot_that_begins_without_network_begins_when_it_is_there(pepper, network, let_talk):
    network.down()
    let_talk(pepper, network.address, patience=0.5)
    pepper.notes.wait_for("says: Just a moment, please.")
    network.up()
    pepper.notes.wait_for("says: I am Pepper.")
    pepper.notes.wait_for("says: ")


def test_a_new_start_of_the_robot_is_a_welcome_back(plain_pepper, address, let_talk):
    first = let_talk(plain_pepper, address)
    plain_pepper.turn("I love music")
    first.end()
    plain_pepper.notes.wait_for("tablet: nothing")
    before = len(plain_pepper.notes.lines)
    let_talk(plain_pepper, address)
    plain_pepper.memory.wait_until_it_listens(plain_pepper.memory.times_opened)
    begun = spoken(plain_pepper.notes.lines[before:])
    assert begun
    assert begun[0] != "says: I am Pepper."


def test_help_is_called_before_all_words(pepper, address, let_talk):
    let_talk(pepper, address, alert={"event": "Staff/Call"})
    lines = pepper.turn("Help me, I have fallen")
    called = 'event: Staff/Call {"person": "Anna", "robot": "Pepper"}'
    assert called in lines
    assert lines.index(called) < lines.index(spoken(lines)[0])


def test_an_alert_that_reaches_nobody_is_told_at_once(plain_pepper, address, let_talk):
    let_talk(plain_pepper, address, alert={"url": "http://127.0.0.1:9/"})
    lines = plain_pepper.turn("Help me, I have fallen")
    assert spoken(lines)[0].startswith("says: I could not reach anybody.")


class _Staff(BaseHTTPRequestHandler):
    def do_POST(self):
        self.server.called.append(json.loads(self.rfile.read(int(self.headers["Content-Length"]))))
        self.send_response(204)
        self.end_headers()

    def log_message(self, *_):
        pass


@pytest.fixture
def staff(loopback):
    server = HTTPServer(("127.0.0.1", 0), _Staff)
    server.called = []
    thread = threading.Thread(target=server.serve_forever)
    thread.start()
    yield server
    server.shutdown()
    thread.join()
    server.server_close()


def test_an_alert_is_posted(plain_pepper, address, let_talk, staff):
    url = f"http://127.0.0.1:{staff.server_port}/"
    let_talk(plain_pepper, address, alert={"url": url}, robot_name="ペッパー")
    lines = plain_pepper.turn("Help me, I have fallen")
    assert staff.called == [{"person": "Anna", "robot": "ペッパー"}]
    assert not [line for line in lines if "could not reach" in line]


def test_a_robot_that_can_call_nobody_does_not_promise_it(plain_pepper, address, let_talk):
    let_talk(plain_pepper, address)
    lines = plain_pepper.turn("Help me, I have fallen")
    assert "call" in " ".join(spoken(lines))
    assert done(lines) == []


def test_a_touch_stops_what_is_going_on_and_the_next_one_pauses(pepper, address, let_talk, caplog):
    caplog.set_level("INFO")
    pepper.behaviours.long.add("cair/hug")
    let_talk(pepper, address)
    pepper.memory.wait_until_it_listens()
    pepper.notes.when("behaviour: cair/hug", pepper.touch_soon)
    lines = pepper.turn("Give me a hug")
    assert "behaviour stopped: cair/hug" in lines
    assert spoken(lines[lines.index("behaviour: cair/hug") :]) == []
    pepper.notes.wait_for("behaviour stopped")
    pepper.touch()
    pepper.notes.wait_for("says: I will be quiet now.")
    before = len(pepper.notes.lines)
    pepper.person("I love music")
    assert wait_for(lambda: "told to be quiet" in caplog.text, 20)
    pepper.touch()
    pepper.notes.wait_for("says: Here I am. I am listening.")
    assert len(spoken(pepper.notes.lines[before:])) == 1
    assert spoken(pepper.turn("I love music"))


def test_it_does_not_hear_itself(pepper, address, let_talk):
    let_talk(pepper, address)
    pepper.memory.wait_until_it_listens()
    heard = pepper.memory.subscriber("CAIR/Heard").signal
    pepper.notes.when("says: ", lambda: heard("Give me a hug"))
    lines = pepper.turn("I love music")
    assert spoken(lines)
    assert "behaviour: cair/hug" not in pepper.notes.lines + pepper.turn("yes")


@pytest.mark.parametrize(
    "recogniser",
    [
        ("words", "WordRecognized", "ears: 11 phrases"),
        ("dialog", "Dialog/LastInput", "ears: topic cair"),
    ],
)
def test_it_hears_through_naoqis_own_recognisers(pepper, address, let_talk, recogniser):
    ears, event, begins = recogniser
    program = let_talk(pepper, address, ears=ears)
    pepper.notes.wait_for(begins)
    pepper.notes.wait_for("says: I am Pepper.")
    pepper.notes.wait_for("says: ")
    heard = pepper.memory.subscriber(event).signal
    for _ in range(100):
        heard(["<...> give me a hug <...>", 0.8] if ears == "words" else "give me a hug")
        if any(line == "behaviour: cair/hug" for line in pepper.notes.lines):
            break
        threading.Event().wait(0.1)
    pepper.notes.wait_for("behaviour: cair/hug")
    program.end()
    pepper.notes.wait_for("ears: end")


def test_a_refusal_of_the_server_is_told_kindly_and_logged(plain_pepper, address, let_talk, caplog):
    let_talk(plain_pepper, address + "/nowhere")
    plain_pepper.notes.wait_for("says: I am sorry, something is wrong with me.")
    assert [one for one in caplog.records if one.levelname == "ERROR"]
