"""cair_client against a real gunicorn, over networks that come and go."""

import json
import os
import shutil
import ssl
import subprocess
import threading

import cair_client
import pytest
from cair_client import CairError, Conversation, UnreachableError

from tests.clients.conftest import PYTHON_CLIENT
from tests.clients.network import Network, answering

pytestmark = pytest.mark.server
SENTENCES = ("I love music", "yes", "play Danny Boy", "what about tea?")


@pytest.fixture
def network(server):
    between = Network(server.port)
    between.up()
    yield between
    between.down()


def address(server):
    return f"http://127.0.0.1:{server.port}"


def undisturbed(server):
    """Return the replies of a talk without trouble."""
    talk = Conversation(address(server), language="en", seed=11, capabilities=["playsong"])
    return [talk.start(), *(talk.say(sentence) for sentence in SENTENCES)]


@pytest.mark.parametrize(
    ("language", "sentence", "title"),
    [
        ("en", "Play the song Hey Brother", "Hey Brother"),
        ("it", "Suona la canzone Volare", "Volare"),
        ("ja", "さくらという曲をかけてください", None),
    ],
)
def test_a_robot_talks_and_plays_in_each_language(server, language, sentence, title):
    talk, said = Conversation(address(server), language=language, person="Anna"), []
    played = []
    talk.on("playsong", played.append)
    assert talk.perform(talk.start(), said.append) == []
    assert talk.perform(talk.say(sentence), said.append) == []
    assert [action.name for action in played] == ["playsong"]
    assert title in (None, played[0].parameters["title"])
    assert len(said) >= 2
    assert not [text for text in said if "$" in text or "#" in text]


def test_the_robot_of_the_page_works_as_it_stands(server, tmp_path, monkeypatch, capsys):
    page = (PYTHON_CLIENT / "README.md").read_text(encoding="utf-8")
    code = page.split("```python\n")[1].split("```")[0]
    code = code.replace("http://127.0.0.1:8000", address(server))
    lines = iter(["play Danny Boy", "what day is it today?"])
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("builtins.input", lambda _: next(lines))
    with pytest.raises(StopIteration):
        exec(code, {})  # noqa: S102
    shown = capsys.readouterr().out
    assert "Anna" in shown.splitlines()[0]
    assert "playing Danny Boy" in shown
    assert "It is Sunday." in shown
    assert "Sorry" not in shown


def test_what_a_robot_cannot_do_is_said_and_not_planned(server):
    reply = Conversation(address(server), language="en").say("Give me a hug")
    assert reply.actions == ()
    assert reply.plan_sentence


def test_the_talk_goes_on_where_it_was_after_the_network_was_lost(server, network, tmp_path):
    kept = str(tmp_path / "talk.json")
    settings = {"seed": 11, "capabilities": ["playsong"], "state_file": kept, "patience": 0.5}
    talk = Conversation(network.address, language="en", **settings)
    replies = [talk.start(), talk.say(SENTENCES[0])]
    network.down()
    with pytest.raises(UnreachableError):
        talk.say(SENTENCES[1])
    network.up()
    replies.append(talk.say(SENTENCES[1]))
    network.down()
    restarted = Conversation(network.address, **settings)  # the robot was switched off meanwhile
    with pytest.raises(UnreachableError):
        restarted.say(SENTENCES[2])
    network.up()
    replies += [restarted.say(sentence) for sentence in SENTENCES[2:]]
    assert replies == undisturbed(server)


def test_a_turn_waits_for_the_network_to_come_back(server, network):
    talk = Conversation(network.address, language="en", seed=11, capabilities=["playsong"])
    replies = [talk.start()]
    network.down()
    back = threading.Timer(0.6, network.up)
    back.start()
    replies += [talk.say(sentence) for sentence in SENTENCES]
    back.join()
    assert replies == undisturbed(server)


def test_an_answer_that_was_cut_off_is_asked_for_again(server, network):
    talk = Conversation(network.address, language="en", seed=11, capabilities=["playsong"])
    network.answers_to_lose = 2
    replies = [talk.start()]
    network.answers_to_lose = 1
    replies += [talk.say(sentence) for sentence in SENTENCES]
    assert network.answers_to_lose == 0
    assert replies == undisturbed(server)


def test_a_talk_survives_a_new_start_of_the_server(serve, own_var, tmp_path):
    kept = str(tmp_path / "talk.json")
    first = serve(own_var)
    Conversation(address(first), language="it", state_file=kept).say("Mi piace il tè")
    first.stop()
    with pytest.raises(UnreachableError):
        Conversation(address(first), state_file=kept, patience=0.3).start()
    talk = Conversation(address(serve(own_var)), state_file=kept)
    assert talk.start().restarted is False
    state = talk.call("POST", "dialogue/inspect/", {"dialogue_state": talk.dialogue_state})
    assert state["language"] == "it"
    assert state["likeliness"]


def test_a_state_of_another_server_is_kept_aside(server, tmp_path):
    kept = tmp_path / "talk.json"
    talk = Conversation(address(server), language="it", state_file=str(kept))
    talk.start()
    foreign = dict(json.loads(kept.read_text()), dialogue_state="A" * 70)
    kept.write_text(json.dumps(foreign))
    reply = Conversation(address(server), state_file=str(kept)).say("Mi piace il tè")
    assert reply.restarted
    assert reply.dialogue_sentence
    assert json.loads(kept.read_text())["language"] == "it"
    assert len(list(tmp_path.glob("talk.json.aside-*"))) == 1


def test_refusals_of_the_server_arrive_as_they_are(server):
    with pytest.raises(CairError) as caught:
        Conversation(address(server), language="xx").start()
    assert (caught.value.code, caught.value.status) == ("language.unknown", 400)


def test_a_redirect_gets_neither_the_sentence_nor_the_key(loopback):
    with (
        answering(200, {}, b"{}") as (other, keys),
        answering(302, {"Location": f"http://127.0.0.1:{other}/"}, b"") as (port, _),
        pytest.raises(CairError, match=r"client\.redirected"),
    ):
        Conversation(f"http://127.0.0.1:{port}", key="secret").start()
    assert keys == []


def test_an_answer_without_end_is_refused(loopback, monkeypatch):
    monkeypatch.setattr(cair_client, "LONGEST_ANSWER", 100_000)
    with (
        answering(200, {}, b" " * 300_000) as (port, _),
        pytest.raises(CairError, match=r"client\.answer_too_large"),
    ):
        Conversation(f"http://127.0.0.1:{port}").start()


START = {"dialogue_state": "s", "first_sentence": "Hello.", "language": "en", "culture": "EN"}


@pytest.fixture(scope="module")
def certificate(tmp_path_factory):
    """Return (certificate, key) of a server called localhost that nobody has signed."""
    if not shutil.which("openssl"):
        pytest.skip("openssl makes the certificate, and is not here")
    folder = tmp_path_factory.mktemp("tls")
    cert, key = str(folder / "cert.pem"), str(folder / "key.pem")
    command = [
        "openssl",
        "req",
        "-x509",
        "-newkey",
        "rsa:2048",
        "-nodes",
        "-days",
        "2",
        "-subj",
        "/CN=localhost",
    ]
    command += ["-addext", "subjectAltName=DNS:localhost", "-keyout", key, "-out", cert]
    subprocess.run(command, check=True, capture_output=True, timeout=30)
    return cert, key


@pytest.fixture
def tls_port(certificate, loopback):
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    context.load_cert_chain(*certificate)
    with answering(200, {}, json.dumps(START).encode(), context) as (port, _):
        yield port


def test_a_certificate_nobody_signed_is_refused_at_once(tls_port):
    with pytest.raises(CairError, match=r"client\.tls"):
        Conversation(f"https://localhost:{tls_port}").start()


def test_a_certificate_one_trusts_oneself_is_taken(tls_port, certificate):
    talk = Conversation(f"https://localhost:{tls_port}", ca_file=certificate[0])
    assert talk.start().text == "Hello."


def test_a_certificate_of_another_name_is_refused(tls_port, certificate):
    with pytest.raises(CairError, match=r"client\.tls"):
        Conversation(f"https://127.0.0.1:{tls_port}", ca_file=certificate[0]).start()


def test_certificates_that_are_not_there_are_told(loopback):
    with pytest.raises(CairError, match=r"client\.tls"):
        Conversation("https://localhost:1", ca_file=os.devnull + "/none")
