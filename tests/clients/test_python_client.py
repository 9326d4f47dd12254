"""cair_client against a made-up server: what is sent, what a robot says and does."""

import pytest
from cair_client import SILENCE, Action, CairError, Conversation, _filled

from tests.clients.conftest import answered

HUB = "http://robot.example/api/v1/hub/"


def test_a_talk_starts_and_its_state_goes_along(hub, talk_with):
    talk = talk_with(language="it", culture="IT", seed=7)
    assert talk.start().dialogue_sentence == "Hello!"
    assert talk.say("tea").dialogue_sentence == "You said tea."
    assert hub.asked == [
        ("GET", f"{HUB}?language=it&culture=IT&seed=7", {}),
        ("POST", HUB, {"client_sentence": "tea", "dialogue_state": "state 0", "capabilities": []}),
    ]


def test_a_sentence_begins_the_talk_where_nobody_did(hub, talk_with):
    talk = talk_with()
    assert talk.say("tea").text == "You said tea."
    assert [method for method, _, _ in hub.asked] == ["GET", "POST"]
    assert talk.dialogue_state == "state 1"


def test_where_nothing_was_heard_nothing_is_said(hub, talk_with):
    assert talk_with().say("  \n") == SILENCE
    assert hub.asked == []


def test_half_a_letter_does_not_reach_the_server(hub, talk_with):
    talk_with().say("tea \ud83d please")
    assert hub.asked[-1][2]["client_sentence"] == "tea \ufffd please"


def test_the_key_and_the_encoding_are_told(hub, talk_with):
    talk_with(key=" abc\n").say("tea")
    assert hub.headers[-1]["X-Api-Key"] == "abc"
    assert hub.headers[-1]["Content-Encoding"] == "deflate"
    assert "Content-Encoding" not in hub.headers[0]


def test_capabilities_are_the_actions_with_a_handler(hub, talk_with):
    talk = talk_with()
    talk.on("playsong", print)
    talk.on("hug", print)
    talk.say("tea")
    assert hub.asked[-1][2]["capabilities"] == ["hug", "playsong"]


def test_a_handler_for_all_leaves_the_capabilities_to_the_server(hub, talk_with):
    talk = talk_with()
    talk.on("*", print)
    talk.say("tea")
    assert "capabilities" not in hub.asked[-1][2]


def test_capabilities_that_are_named_count(hub, talk_with):
    talk = talk_with(capabilities={"hug", "date"})
    talk.on("*", print)
    talk.say("tea")
    assert hub.asked[-1][2]["capabilities"] == ["date", "hug"]


def performed(talk):
    """Return what a robot did for one sentence, in its order, and what it could not do."""
    log = []
    for name in ("playsong", "alert"):
        talk.on(name, lambda action: log.append(action))
    talk.start()
    undone = talk.perform(talk.say("please"), log.append)
    return log, undone


def test_a_robot_speaks_acts_and_speaks_in_order(hub, talk_with):
    talk = talk_with()
    hub.next = [answered(hub.begun()), hub.plan("playsong", "fly")]
    log, undone = performed(talk)
    assert log == ["Gladly.", Action("playsong", {"title": None}), "And so on."]
    assert undone == [Action("fly", {"title": None})]


def test_an_alert_does_not_wait_for_words(hub, talk_with):
    talk = talk_with()
    hub.next = [answered(hub.begun()), hub.plan("playsong", "alert")]
    log, _ = performed(talk)
    assert [getattr(one, "name", one) for one in log] == [
        "alert",
        "Gladly.",
        "playsong",
        "And so on.",
    ]


def test_a_handler_that_fails_does_not_end_the_talk(hub, talk_with, caplog):
    talk, said = talk_with(), []

    @talk.on("playsong")
    def play(action):
        raise OSError("no speaker")

    hub.next = [answered(hub.begun()), hub.plan("playsong")]
    assert [one.name for one in talk.perform(talk.say("music"), said.append)] == ["playsong"]
    assert said == ["Gladly.", "And so on."]
    assert "The action playsong failed." in caplog.text


def test_what_a_handler_returns_is_said(hub, talk_with):
    talk, said = talk_with(), []
    talk.on("date", lambda action: "It is Sunday.")
    hub.next = [answered(hub.begun()), hub.plan("date")]
    talk.perform(talk.say("what day is it"), said.append)
    assert said == ["Gladly.", "It is Sunday.", "And so on."]


@pytest.mark.parametrize(
    ("sentence", "named", "nameless"),
    [
        ("Hello, $name!", "Hello, Anna!", "Hello!"),
        ("Hello, $name, how are you?", "Hello, Anna, how are you?", "Hello, how are you?"),
        ("$name, how are you?", "Anna, how are you?", "How are you?"),
        ("Well. $name, come in.", "Well. Anna, come in.", "Well. Come in."),
        ("È bello, $name.", "È bello, Anna.", "È bello."),
        ("$nameさんは、お元気ですか。", "Annaさんは、お元気ですか。", "お元気ですか。"),
        ("$nameさん、こんにちは。", "Annaさん、こんにちは。", "こんにちは。"),
        ("$desspk and $prevspk", "Anna and Anna", "And"),
        ("It costs $5, $names.", "It costs $5, $names.", "It costs $5, $names."),
    ],
)
def test_a_name_is_filled_in_or_goes_with_its_comma(sentence, named, nameless):
    assert _filled(sentence, "Anna", None, "en") == named
    assert _filled(sentence, " ", None, "en") == nameless


def test_a_name_keeps_its_own_honorific_and_its_signs():
    assert _filled("$nameさん、どうぞ。", "和子先生", None, "ja") == "和子先生さん、どうぞ。"
    assert _filled("$nameさん、どうぞ。", "和子様", None, "ja") == "和子様、どうぞ。"
    assert _filled("Hi, $name.", r"\1 $name", None, "en") == r"Hi, \1 $name."


def test_gender_forms_are_italian_and_need_a_gender():
    assert _filled("Carə amicə", None, "f", "it-IT") == "Cara amica"
    assert _filled("Carə amicə", None, "m", "it") == "Caro amico"
    assert _filled("Carə amicə", None, None, "it") == "Carə amicə"
    assert _filled("the sound ə", None, "f", "en") == "the sound ə"


@pytest.mark.parametrize(
    "address", ["", "robot:8000", "ftp://robot", "http://", "http://a b", "http://me:secret@robot"]
)
def test_an_address_that_is_none_is_refused(address):
    with pytest.raises(CairError) as caught:
        Conversation(address)
    assert caught.value.code == "client.address"


def test_the_address_may_be_that_of_the_api(hub):
    Conversation("https://robot.example/cair/api/v1/", transport=hub).start()
    assert hub.asked[0][1] == "https://robot.example/cair/api/v1/hub/"


def test_a_key_no_header_can_hold_is_refused(talk_with):
    with pytest.raises(CairError, match="API key"):
        talk_with(key="a\r\nHost: b")


def test_other_calls_are_at_hand(hub, talk_with):
    hub.next = [answered([{"name": "hug"}])]
    assert talk_with().call("GET", "actions/") == [{"name": "hug"}]
