"""cair-chat: line by line through a pipe, and in a terminal of 80 columns."""

import os
import pty
import re
import select
import struct
import subprocess
import sys
import termios
import time
from fcntl import ioctl
from importlib.util import find_spec
from unicodedata import east_asian_width

import pytest
from cair_chat import __main__ as command
from cair_chat.chat import Chat
from cair_chat.screens import PlainScreen

from tests.clients.conftest import DOWN, PYTHON_CLIENT, answered, refused

ESCAPES = re.compile(r"\x1b\[[0-9;?]*[a-zA-Z]")
ACTIONS = [
    {"name": "playsong", "meaning": "Play a song.", "kb": False},
    {"name": "jump", "meaning": "Go to a topic.", "kb": True},
]
COMMAND = (sys.executable, "-W", "error", "-B", "-m", "cair_chat")


@pytest.fixture
def chat(hub, talk_with, pauses):
    """Return a chat that has begun."""
    hub.next = [answered(ACTIONS)]
    begun = Chat(talk_with(), PlainScreen())
    begun.begin()
    return begun


def test_a_plan_is_shown_and_simulated_but_not_spoken(chat, hub, capsys):
    hub.next = [hub.plan("playsong")]
    chat.hear("music")
    assert capsys.readouterr().out.splitlines() == [
        "plan:  playsong title: (nobody said)",
        "agent: Gladly.",
        "robot: (playsong title: (nobody said)) Play a song.",
        "agent: And so on.",
    ]
    assert hub.asked[-1][2]["capabilities"] == ["playsong"]


def test_a_turn_is_explained_from_the_state_before_it(chat, hub, capsys):
    chat.hear("tea")
    steps = [{"rule": "say", "text": "Tea.p1", "candidates": [{"topic": "Tea", "likeliness": 0.5}]}]
    hub.next = [answered({"steps": steps})]
    chat.hear("/explain")
    assert hub.asked[-1][2]["dialogue_state"] == "state 0"
    assert hub.asked[-1][2]["client_sentence"] == "tea"
    assert "Tea 0.50" in capsys.readouterr().out


def test_there_is_nothing_to_explain_before_the_first_turn(chat, capsys):
    chat.hear("/explain")
    assert "Nothing to explain yet" in capsys.readouterr().out


def test_a_language_the_server_lacks_leaves_the_talk_as_it_is(chat, hub, capsys):
    hub.next = [refused("language.unknown", 400)]
    chat.hear("/language xx")
    chat.hear("tea")
    assert "That went wrong. Mend it." in capsys.readouterr().out
    assert hub.asked[-1][2]["dialogue_state"] == "state 0"
    assert not chat.failed


def test_another_language_begins_a_new_talk(chat, hub):
    chat.hear("/language it")
    assert hub.asked[-1][1].endswith("/hub/?language=it")


def test_a_lost_network_is_told_and_the_talk_goes_on(chat, hub, capsys):
    hub.next = [DOWN] * 99
    assert chat.hear("tea")
    assert "Nothing is lost: say it again." in capsys.readouterr().out
    hub.next = []
    chat.hear("tea")
    assert "agent: You said tea." in capsys.readouterr().out
    assert chat.failed


def test_a_talk_is_written_once_and_not_over_another(chat, tmp_path, capsys):
    chat.hear("tea")
    for _ in range(2):
        chat.hear(f"/save {tmp_path}/talk.txt")
    saved = (tmp_path / "talk.txt").read_text()
    assert saved == "agent: Hello!\nyou:   tea\nagent: You said tea.\n"
    assert "Not written" in capsys.readouterr().out


def test_an_unknown_command_is_not_said_to_the_server(chat, hub, capsys):
    before = len(hub.asked)
    chat.hear("/dance now")
    assert len(hub.asked) == before
    assert "There is no /dance; /help lists what there is." in capsys.readouterr().out
    assert chat.hear("/quit") is False


def test_a_server_that_is_not_there_is_told_without_a_traceback(monkeypatch, capsys):
    monkeypatch.setattr(command, "_PATIENCE", 0.2)
    assert command.main(["--server", "http://127.0.0.1:9", "--plain"]) == 1
    assert capsys.readouterr().err.startswith("cair-chat: No answer from http://127.0.0.1:9/")


def width(line):
    return sum(2 if east_asian_width(letter) in "WF" else 1 for letter in line)


def piped(server, text, *options):
    address = f"http://127.0.0.1:{server.port}"
    return subprocess.run(
        [*COMMAND, "--server", address, "--seed", "5", *options],
        input=text.encode(),
        capture_output=True,
        check=False,
        timeout=60,
        cwd=PYTHON_CLIENT,
        env=os.environ | {"LC_ALL": "C"},
    )


@pytest.mark.server
@pytest.mark.parametrize(
    ("language", "sentence", "action"),
    [
        ("en", "play Danny Boy", "playsong title: Danny Boy"),
        ("it", "Suona la canzone Volare", "playsong title: Volare"),
        ("ja", "音楽をかけてください", "playsong title: (nobody said)"),
    ],
)
def test_a_pipe_is_answered_line_by_line(server, language, sentence, action):
    done = piped(server, f"{sentence}\n/state\n/explain", "--language", language)
    shown = done.stdout.decode()
    assert (done.returncode, done.stderr) == (0, b"")
    assert shown.count("agent: ") >= 2
    assert f"plan:  {action}\n" in shown
    assert f"robot: ({action}) Play a song.\n" in shown
    assert re.search(rf"language +{language}\n", shown)
    assert "Intent playsong" in shown


@pytest.mark.server
def test_a_chat_goes_on_from_its_state_file(server, tmp_path):
    kept = ("--state", str(tmp_path / "talk.json"))
    piped(server, "Mi piace il tè", "--language", "it", *kept)
    shown = piped(server, "/state", *kept).stdout.decode()
    assert re.search(r"language +it\n", shown)
    assert re.search(r"likeliness +\w*Tea\w* 1.00", shown)


class Terminal:
    """A chat in a terminal of 80 columns."""

    def __init__(self, *arguments):
        self.shown = ""
        self.process, self.end = pty.fork()
        if not self.process:  # pragma: no cover
            os.chdir(PYTHON_CLIENT)
            os.environ["TERM"] = "xterm"
            os.execv(COMMAND[0], [*COMMAND, *arguments])  # noqa: S606
        ioctl(self.end, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 80, 0, 0))

    def read(self, mark, seconds=20):
        """Read until a mark appears, or the end; say whether it has ended."""
        new, until, ended = b"", time.monotonic() + seconds, False
        while mark not in new and time.monotonic() < until:
            if select.select([self.end], [], [], 0.2)[0]:
                try:
                    new += os.read(self.end, 65536)
                except OSError:
                    ended = True
                    break
        self.shown += ESCAPES.sub("", new.decode(errors="replace"))
        return ended

    def type(self, keys):
        """Wait for the prompt, then type."""
        self.read(b"you:   ")
        time.sleep(0.3)  # readline makes itself ready after the prompt; a Ctrl-C before is lost
        os.write(self.end, keys.encode())

    def left(self, keys):
        """Type how to leave, again where a slow machine has lost it; return the exit code."""
        self.type(keys)
        for _ in range(10):
            if self.read(b"(no such mark)", seconds=3):
                break
            os.write(self.end, keys.encode())
        os.close(self.end)
        return os.waitstatus_to_exitcode(os.waitpid(self.process, 0)[1])


@pytest.mark.server
@pytest.mark.skipif(find_spec("rich") is None, reason="rich is not installed")
@pytest.mark.parametrize("goodbye", ["\x03", "\x04", "/quit\n"])
def test_a_terminal_shows_tables_that_fit_and_ends_kindly(server, goodbye):
    address = f"http://127.0.0.1:{server.port}"
    terminal = Terminal("--server", address, "--language", "ja", "--seed", "5")
    for line in ("音楽をかけてください\n", "[bold]猫\n", "/explain\n", "/help\n"):
        terminal.type(line)
    assert terminal.left(goodbye) == 0, terminal.shown
    lines = terminal.shown.splitlines()
    assert "│ playsong │" in terminal.shown
    assert terminal.shown.count("agent:") >= 4
    assert max(width(line) for line in lines) <= 80
    boxed = [line for line in lines if line.startswith("│")]
    assert {line.rstrip()[-1] for line in boxed} == {"│"}
    assert "Goodbye" in lines[-1]
