"""cair_client when things go wrong: nothing is half done, nothing lost, nobody waits for ever."""

import json
import zlib

import cair_client
import pytest
from cair_client import CairError, UnreachableError

from tests.clients.conftest import DOWN, answered, refused


@pytest.fixture
def kept(tmp_path):
    return tmp_path / "talks" / "anna.json"


def aside(kept):
    return [path.read_text() for path in sorted(kept.parent.glob("*.aside-*"))]


@pytest.mark.parametrize(
    "trouble",
    [
        DOWN,
        TimeoutError("timed out"),
        EOFError("The answer was cut off."),
        zlib.error("incomplete"),
        (502, {}, b"<html>Bad gateway</html>"),
        refused("content.not_published", 503),
        refused("key.too_often", 429),
    ],
)
def test_what_may_pass_is_tried_again(hub, talk_with, pauses, trouble):
    hub.next = [trouble, trouble]
    assert talk_with().start().text == "Hello!"
    assert len(pauses) == 2


def test_pauses_grow_are_not_all_alike_and_end(hub, talk_with, pauses):
    hub.next = [DOWN] * 100
    with pytest.raises(UnreachableError) as caught:
        talk_with(patience=60).start()
    assert caught.value.code == "client.unreachable"
    assert 0.25 <= pauses[0] <= 0.5
    assert 4 <= max(pauses) <= cair_client.LONGEST_PAUSE
    assert len(set(pauses)) == len(pauses)
    assert 40 < sum(pauses) < 60


def test_the_server_says_how_long_to_wait(hub, talk_with, pauses):
    hub.next = [refused("key.too_often", 429, **{"retry-after": "17"})]
    talk_with().start()
    assert pauses == [17.0]


def test_a_wait_beyond_patience_is_told_at_once(hub, talk_with, pauses):
    hub.next = [refused("key.too_often", 429, **{"retry-after": "60"})]
    with pytest.raises(UnreachableError) as caught:
        talk_with(patience=30).start()
    assert (caught.value.code, caught.value.status, pauses) == ("key.too_often", 429, [])


@pytest.mark.parametrize(
    "answer",
    [
        refused("language.unknown", 400),
        refused("server.error", 500),
        (404, {}, b"<html>"),
        (302, {"location": "http://other.example"}, b""),
        (200, {}, b"<html>Log in to the hotel's network</html>"),
        answered([]),
    ],
)
def test_what_will_not_pass_is_told_at_once(hub, talk_with, pauses, answer):
    hub.next = [answer]
    with pytest.raises(CairError) as caught:
        talk_with().start()
    assert not isinstance(caught.value, UnreachableError)
    assert pauses == []


ODD = (
    {"dialogue_state": "", "dialogue_sentence": "x"},
    {"dialogue_state": "s", "dialogue_sentence": None},
    {"dialogue_state": ["s"], "dialogue_sentence": "x"},
    {"dialogue_state": "s", "dialogue_sentence": "x", "plan_sentence": None},
    {"dialogue_state": "s", "dialogue_sentence": "x", "plan_actions": [{"action": "hug"}]},
    {"dialogue_state": "s", "dialogue_sentence": "x", "plan_actions": 7},
)


@pytest.mark.parametrize("answer", ODD)
def test_a_turn_that_failed_is_not_half_applied(hub, talk_with, kept, answer):
    talk = talk_with(state_file=str(kept))
    talk.say("one")
    before = kept.read_text()
    hub.next = [answered(answer)]
    with pytest.raises(CairError, match=r"client\.answer"):
        talk.say("two")
    assert (talk.dialogue_state, kept.read_text()) == ("state 1", before)
    assert talk.say("two").text == "You said two."


def test_the_state_goes_on_after_a_lost_network(hub, talk_with, pauses):
    talk = talk_with(patience=1)
    talk.say("one")
    hub.next = [DOWN] * 20
    with pytest.raises(UnreachableError):
        talk.say("two")
    hub.next = []
    talk.say("two")
    assert hub.asked[-1][2]["dialogue_state"] == "state 1"


def test_another_program_goes_on_where_the_first_left_off(hub, talk_with, kept):
    talk_with(state_file=str(kept)).say("one")
    later = talk_with(state_file=str(kept), language="en-GB", culture="en")
    later.start()
    assert hub.asked[-1][2] == {
        "client_sentence": "",
        "dialogue_state": "state 1",
        "capabilities": [],
    }
    assert kept.stat().st_mode & 0o777 == 0o600


@pytest.mark.parametrize("wanted", [{"language": "ja"}, {"culture": "IN"}])
def test_another_language_or_culture_begins_a_new_talk(hub, talk_with, kept, wanted):
    talk_with(state_file=str(kept)).say("one")
    old = kept.read_text()
    assert talk_with(state_file=str(kept), **wanted).start().restarted is False
    assert hub.asked[-1][0] == "GET"
    assert aside(kept) == [old]


def test_a_new_talk_that_cannot_begin_costs_nothing(hub, talk_with, kept, pauses):
    talk = talk_with(state_file=str(kept))
    talk.say("one")
    hub.next = [DOWN] * 50
    with pytest.raises(UnreachableError):
        talk.start(afresh=True)
    assert json.loads(kept.read_text())["dialogue_state"] == "state 1"
    assert aside(kept) == []


@pytest.mark.parametrize("spoiled", ["", "{", "[]", '{"dialogue_state": 7}', "\x00\ufffd" * 50])
def test_a_damaged_file_is_kept_aside_and_a_talk_begins(hub, talk_with, kept, spoiled):
    kept.parent.mkdir()
    kept.write_text(spoiled)
    assert talk_with(state_file=str(kept)).start().restarted is True
    assert aside(kept) == [spoiled]
    assert json.loads(kept.read_text())["dialogue_state"] == "state 0"


def test_a_state_the_server_cannot_read_begins_anew_with_the_same_sentence(hub, talk_with, kept):
    talk = talk_with(state_file=str(kept))
    talk.say("one")
    old = kept.read_text()
    hub.next = [refused("state.damaged", 400)]
    reply = talk.say("two")
    assert (reply.text, reply.restarted) == ("You said two.", True)
    assert hub.asked[-2][1].endswith("?language=en&culture=EN")
    assert aside(kept) == [old]


def test_states_the_server_never_reads_do_not_go_on_for_ever(hub, talk_with):
    talk = talk_with()
    talk.start()
    hub.next = [refused("state.version", 400), answered(hub.begun()), refused("state.version", 400)]
    with pytest.raises(CairError, match=r"state\.version"):
        talk.say("two")


@pytest.mark.parametrize("broken", ["fsync", "replace"])
def test_a_crash_while_saving_leaves_the_old_state(talk_with, kept, monkeypatch, broken, caplog):
    talk = talk_with(state_file=str(kept))
    talk.say("one")
    old = kept.read_text()

    def fail(*_):
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patched:
        patched.setattr(cair_client.os, broken, fail)
        assert talk.say("two").text == "You said two."
    assert kept.read_text() == old
    assert "No space left on device" in caplog.text
    talk.say("three")
    assert json.loads(kept.read_text())["dialogue_state"] == "state 3"


def test_a_state_file_that_cannot_be_written_is_told_at_the_start(talk_with, tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(CairError, match=r"client\.state_file"):
        talk_with(state_file=str(tmp_path / "file" / "talk.json")).start()


def test_an_answer_that_inflates_without_end_is_refused(hub, talk_with):
    hub.next = [(200, {}, zlib.compress(b" " * 10_000_000))]
    with pytest.raises(CairError, match=r"client\.answer_too_large"):
        talk_with().start()


def test_an_error_is_readable(hub, talk_with):
    hub.next = [refused("culture.unknown", 400)]
    with pytest.raises(CairError) as caught:
        talk_with().start()
    assert str(caught.value) == "culture.unknown: That went wrong. Mend it."
