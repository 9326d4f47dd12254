"""What people say is nowhere on the server: a thousand turns with planted words, then a search."""

import base64
import json
import re
import socket
import sqlite3
import zlib
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path
from urllib.parse import quote, urlencode

import pytest

from tests.server import conftest
from tests.server.conftest import Server, start_server

WORDS = ("Zebulonia", "Quackenbosch", "Fibrolupitis", "Morbusquatico", "佐々木兵衛太", "骨髄蛇病")
SENTENCES = (
    "My name is Zebulonia Quackenbosch and I have Fibrolupitis",
    "Mi chiamo Zebulonia e ho il Morbusquatico",
    "私の名前は佐々木兵衛太です。骨髄蛇病があります。",
    "play the song Zebulonia by Quackenbosch",
    "search the internet for Morbusquatico",
    "Remind me to call Zebulonia about the Fibrolupitis at nine",
)
TURNS = 1000


@pytest.fixture
def watched(own_var: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Server]:
    """Return a server that logs and counts all it can."""
    plain = conftest.environment
    temporary = tmp_path / "temporary"
    temporary.mkdir()
    settings = {
        "TMPDIR": str(temporary),
        "CAIR_LOG_FORMAT": "json",
        "CAIR_LOG_LEVEL": "DEBUG",
        "CAIR_ACCESS_LOG": "yes",
        "CAIR_SLOW_MS": "1",
        "CAIR_SLOW_A_MINUTE": "10000",
    }
    monkeypatch.setattr(conftest, "environment", lambda var: plain(var) | settings)
    server = start_server(own_var, tmp_path / "log")
    yield server
    server.stop()


def talk(server: Server, turns: int) -> set[str]:
    """Take turns at all doors; return the beginnings of the states that went to and fro."""
    states, state = set(), ""
    for number in range(turns):
        said = SENTENCES[number % len(SENTENCES)]
        language = ("en", "it", "ja")[number % 3]
        message = {"client_sentence": said, "language": language, "dialogue_state": state}
        path = ("hub/", "hub/", "dialogue/", "plan/", "dialogue/explain/")[number % 5]
        answer = server.ask("POST", f"/api/v1/{path}", json.dumps(message).encode())
        assert answer.status == 200, answer.body
        if number % 40 == 0:
            state = ""
        elif "dialogue_state" in answer.json():
            state = answer.json()["dialogue_state"]
            states.add(state[:48])
    return states


def old_client(server: Server) -> None:
    for said in SENTENCES:
        for body in ({"client_sentence": said}, {"sentence": said, "dialogue_state": said}):
            packed = zlib.compress(json.dumps(body).encode())
            assert server.ask("PUT", "/CAIR_hub", packed).status == 200
        spoken = f'<response><profile_id value="Quackenbosch">{said}<speaking_time>3'
        server.ask("PUT", "/CAIR_hub", json.dumps({"client_sentence": spoken}).encode())


def trouble(server: Server) -> None:
    """Send what is refused: words in fields, addresses, headers, and where they never belong."""
    for said in SENTENCES:
        for wrong in (
            {"client_sentence": [said]},
            {"client_sentence": said, "seed": said},
            {"client_sentence": said, "dialogue_state": said},
            {"client_sentence": said, "language": said},
            {"client_sentence": said, "culture": said},
            {"client_sentence": said, "capabilities": said},
        ):
            server.ask("POST", "/api/v1/hub/", json.dumps(wrong).encode())
        for body in (said.encode(), b"\x78" + said.encode(), b'{"client_sentence": "' + b"["):
            assert server.ask("POST", "/api/v1/hub/", body).status == 400
        name = quote(said)
        for path in (f"topics/{name}/", f"hub/?{urlencode({'seed': said})}", name):
            assert server.ask("GET", f"/api/v1/{path}").status >= 400
        server.ask("GET", f"/{name}?{urlencode({'sentence': said})}")
        server.ask("GET", f"/CAIR_hub?{urlencode({'sentence': said})}")
        ascii_only = said.encode("ascii", "ignore").decode()
        headers = {
            "User-Agent": ascii_only,
            "Referer": ascii_only,
            "X-Request-ID": f"!{ascii_only}",
        }
        server.ask("GET", "/", **headers)
        server.ask("GET", "/api/v1/hub/", Cookie=f"name={quote(said)}", Host="zebulonia.example")
        log_in(server, said)
        misframed(server, said)


def log_in(server: Server, said: str) -> None:
    """Try to log in with words that are no name and no password."""
    page = server.ask("GET", "/admin/login/")
    cookie = re.search(r"csrftoken=(\w+)", page.headers["Set-Cookie"])
    assert cookie is not None
    form = {"username": said, "password": said, "csrfmiddlewaretoken": cookie[1]}
    headers = {"Content-Type": "application/x-www-form-urlencoded", "Cookie": cookie[0]}
    path = f"/admin/login/?next=/{quote(said)}"
    assert server.ask("POST", path, urlencode(form).encode(), **headers).status == 200


def misframed(server: Server, said: str) -> None:
    """Send a body that is longer than its length: its rest comes where a request should begin."""
    body = json.dumps({"client_sentence": said}, ensure_ascii=False).encode()
    for cut in (body.find(word.encode()) for word in WORDS if word in said):
        head = f"POST /api/v1/hub/ HTTP/1.1\r\nHost: localhost\r\nContent-Length: {cut}\r\n\r\n"
        with socket.create_connection(("127.0.0.1", server.port), timeout=5) as connection:
            connection.sendall(head.encode() + body + b"\r\n\r\n")
            while connection.recv(65536):
                pass


def forms(word: str) -> list[bytes]:
    """Return how a word may be written in a file."""
    plain = word.encode()
    escaped = json.dumps(word)[1:-1].encode()
    packed = [base64.b64encode(plain[start:])[4:-4] for start in range(3)]
    coded = [quote(word).encode(), word.encode("utf-16-le"), word.lower().encode()]
    return [plain, escaped, repr(plain)[2:-1].encode(), *coded, *(one for one in packed if one)]


def found(place: str, data: bytes) -> list[tuple[str, str]]:
    small = data.lower()
    return [(place, word) for word in WORDS if any(one.lower() in small for one in forms(word))]


def dump(database: Path) -> bytes:
    with closing(sqlite3.connect(database)) as opened:
        return "\n".join(opened.iterdump()).encode()


def files_below(folder: Path) -> Iterator[tuple[str, bytes]]:
    for path in sorted(folder.rglob("*")):
        if path.is_file():
            yield str(path.relative_to(folder)), path.read_bytes()


@pytest.mark.parametrize("word", WORDS)
def test_the_search_would_find_a_word(word: str, tmp_path: Path) -> None:
    for number, form in enumerate(forms(word)):
        (tmp_path / f"{number}").write_bytes(b"\x00\x01before" + form + b"after")
    for name, data in files_below(tmp_path):
        assert found(name, data), name


def test_after_a_thousand_turns_nothing_said_is_anywhere(
    watched: Server, tmp_path: Path, own_var: Path
) -> None:
    states = talk(watched, TURNS)
    old_client(watched)
    trouble(watched)
    metrics = watched.ask("GET", "/metrics")
    assert metrics.status == 200
    places = [*files_below(own_var), *files_below(tmp_path / "temporary")]
    places += [("metrics", metrics.body), ("database", dump(own_var / "cair.sqlite3"))]
    assert any("counter" in name for name, _data in places)
    watched.stop()
    assert not list((tmp_path / "temporary").glob("cair-counts-*"))
    log = watched.log.read_bytes()
    places += [("log", log), *files_below(own_var), *files_below(tmp_path / "temporary")]
    assert [one for name, data in places for one in found(name, data)] == []
    everything = b"".join(data for _name, data in places)
    assert not [state for state in states if state.encode() in everything]
    counted = re.findall(
        rb'^cair_turns_total\{.*service="(?:hub|plan|dialogue)".* (\d+\.0)$', metrics.body, re.M
    )
    assert sum(map(float, counted)) == TURNS * 4 / 5
    lines = [json.loads(line) for line in log.splitlines()]
    loggers = {line["logger"] for line in lines}
    assert {"cair.access", "cair.slow", "cair.audit", "gunicorn.error"} <= loggers
    assert all(line["request_id"] for line in lines if line["logger"] == "cair.slow")
    assert any("no HTTP" in line["message"] for line in lines)


def test_talking_adds_no_row_to_any_table(watched: Server) -> None:
    before = rows(watched.var)
    talk(watched, 30)
    old_client(watched)
    assert rows(watched.var) == before


def rows(var: Path) -> dict[str, int]:
    """Return how many rows each table has."""
    with closing(sqlite3.connect(var / "cair.sqlite3")) as database:
        named = "SELECT name FROM sqlite_master WHERE type = 'table'"
        names = [name for (name,) in database.execute(named)]
        return {name: count(database, name) for name in names}


def count(database: sqlite3.Connection, table: str) -> int:
    question = f'SELECT count(*) FROM "{table}"'  # noqa: S608 - our own table
    return int(database.execute(question).fetchone()[0])
