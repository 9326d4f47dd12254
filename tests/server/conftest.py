"""A real gunicorn on loopback, with a prepared CAIR_VAR of its own, ended by its process id."""

import http.client
import json
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parent.parent.parent
LISTENS = re.compile(r"Listening at: http://127\.0\.0\.1:(\d+)")
Json = dict[str, Any]


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Mark every test of this folder: it starts a server."""
    for item in items:
        if Path(item.path).is_relative_to(Path(__file__).parent):
            item.add_marker(pytest.mark.server)


def environment(var: Path) -> dict[str, str]:
    """Return the environment of a server whose data is in this folder, with nothing else set."""
    kept = {
        name: value
        for name, value in os.environ.items()
        if not name.startswith(("CAIR_", "DATABASE_", "DJANGO_"))
    }
    return kept | {"CAIR_VAR": str(var)}


def manage(var: Path, *arguments: str) -> str:
    """Run manage.py and return what it printed."""
    done = subprocess.run(
        [sys.executable, "manage.py", *arguments],
        cwd=ROOT,
        env=environment(var),
        capture_output=True,
        text=True,
        check=False,
        timeout=180,
    )
    assert done.returncode == 0, done.stderr[-3000:]
    return done.stdout


def manage_at_once(count: int, settings: dict[str, str], *arguments: str) -> list[tuple[int, str]]:
    """Run manage.py on several nodes at once; return the codes and what was complained of."""
    nodes = [
        subprocess.Popen(
            [sys.executable, "manage.py", *arguments],
            cwd=ROOT,
            env=settings,
            stderr=subprocess.PIPE,
        )
        for _ in range(count)
    ]
    told = [node.communicate(timeout=240)[1].decode()[-500:] for node in nodes]
    return [(node.returncode, text) for node, text in zip(nodes, told, strict=True)]


@dataclass(frozen=True)
class Answer:
    """What a server answered."""

    status: int
    headers: dict[str, str]
    body: bytes

    def json(self) -> Json:
        """Return the body as JSON."""
        data = json.loads(self.body)
        assert isinstance(data, dict)
        return data


@dataclass
class Server:
    """A running gunicorn."""

    var: Path
    port: int
    process: subprocess.Popen[bytes]
    log: Path

    def ask(self, method: str, path: str, body: bytes | None = None, **headers: str) -> Answer:
        """Return the answer on a connection of its own."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=20)
        try:
            connection.request(method, path, body, headers)
            answer = connection.getresponse()
            return Answer(answer.status, dict(answer.getheaders()), answer.read())
        finally:
            connection.close()

    def publication(self) -> int | None:
        """Return the number that one of the workers serves."""
        number = self.ask("GET", "/readyz").json()["publication"]
        assert number is None or isinstance(number, int)
        return number

    def stop(self) -> None:
        """End this process, and only this, at once."""
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGQUIT)
            try:
                self.process.wait(15)
            except subprocess.TimeoutExpired:
                self.process.kill()
                self.process.wait(5)


def start_server(var: Path, log: Path) -> Server:
    """Start gunicorn on a free port and wait until it answers."""
    command = [sys.executable, "-m", "gunicorn", "--config", "cair_site/gunicorn_conf.py"]
    command += ["--bind", "127.0.0.1:0", "--workers", "2", "--graceful-timeout", "3"]
    with log.open("wb") as file:
        process = subprocess.Popen(command, cwd=ROOT, env=environment(var), stderr=file)
    server = Server(var, 0, process, log)
    until = time.monotonic() + 120
    while time.monotonic() < until and process.poll() is None:
        found = LISTENS.search(log.read_text(errors="replace"))
        if found:
            server.port = int(found[1])
            return server
        time.sleep(0.05)
    server.stop()
    pytest.fail(f"gunicorn did not start:\n{log.read_text(errors='replace')[-3000:]}")


def wait_for(what: Callable[[], object], seconds: float) -> bool:
    """Say whether something becomes true in time."""
    until = time.monotonic() + seconds
    while not what():
        if time.monotonic() > until:
            return False
        time.sleep(0.1)
    return True


@pytest.fixture(scope="session")
def loopback() -> None:
    """Skip where no port of the loopback can be bound."""
    try:
        with socket.socket() as tried:
            tried.bind(("127.0.0.1", 0))
    except OSError as error:
        pytest.skip(f"No port of 127.0.0.1 can be bound here: {error}")


@pytest.fixture(scope="session")
def prepared(loopback: None, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a CAIR_VAR made by `manage.py prepare`; copy it before changing anything."""
    from tests import site_fixtures  # its asserts are rewritten: not to be imported before pytest

    var = tmp_path_factory.mktemp("prepared") / "var"
    manage(var, "prepare", "--content", str(site_fixtures.CONTENT))
    return var


@pytest.fixture(scope="session")
def server(prepared: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    """Return a server that tests share: they leave its content alone."""
    folder = tmp_path_factory.mktemp("server")
    shutil.copytree(prepared, folder / "var")
    started = start_server(folder / "var", folder / "log")
    yield started
    started.stop()


@pytest.fixture
def own_var(prepared: Path, tmp_path: Path) -> Path:
    """Return a prepared CAIR_VAR that a test may spoil."""
    return Path(shutil.copytree(prepared, tmp_path / "var"))


@pytest.fixture
def serve(loopback: None, tmp_path: Path) -> Iterator[Callable[[Path], Server]]:
    """Return a function that starts a server on a CAIR_VAR; it is ended after the test."""
    started: list[Server] = []

    def start(var: Path) -> Server:
        started.append(start_server(var, tmp_path / f"log{len(started)}"))
        return started[-1]

    yield start
    for one in started:
        one.stop()
