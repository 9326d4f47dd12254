"""nginx with our configuration on loopback, before two real servers."""

import json
import os
import shutil
import signal
import ssl
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from http.client import HTTPConnection, HTTPResponse, HTTPSConnection
from pathlib import Path
from typing import Any

import pytest

from tests.deploy.files import DEPLOY, ROOT
from tests.deploy.ports import free_port

NGINX = shutil.which("nginx") or shutil.which("nginx", path="/usr/sbin:/usr/local/sbin")
HERE = "127.0.0.1"
HOST = "cair.example"
CERTIFICATE = ["openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "2"]
CERTIFICATE += ["-subj", f"/CN={HOST}"]


class Service:
    """A proxy and the servers behind it; `log` is what the proxy wrote of its requests."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.plain, self.tls = free_port(), free_port()
        self.behind = [free_port(), free_port()]
        self.servers: list[subprocess.Popen[bytes]] = []
        self.log = folder / "access.log"

    def connect(self) -> HTTPSConnection:
        """Return a connection that believes the proxy's certificate only."""
        trust = ssl.create_default_context(cafile=str(self.folder / "tls.crt"))
        trust.check_hostname = False
        return HTTPSConnection(HERE, self.tls, timeout=30, context=trust)

    def ask(
        self, method: str, path: str, body: bytes | str | None = None, **headers: str
    ) -> tuple[HTTPResponse, bytes]:
        """Return an answer and its body, on a connection of its own."""
        connection = self.connect()
        try:
            given = {name.replace("_", "-"): value for name, value in headers.items()}
            connection.request(method, path, body, {"Host": HOST} | given)
            answer = connection.getresponse()
            return answer, answer.read()
        finally:
            connection.close()

    def start(self) -> str:
        """Begin a talk; return its state."""
        answer, body = self.ask("GET", "/api/v1/hub/?language=en&culture=EN")
        assert answer.status == 200, body
        state = json.loads(body)["dialogue_state"]
        assert isinstance(state, str)
        return state

    def turn(self, state: str, **headers: str) -> tuple[HTTPResponse, dict[str, Any]]:
        """Take a turn; return the answer and its JSON."""
        body = json.dumps({"client_sentence": "I love dogs", "dialogue_state": state})
        answer, text = self.ask("POST", "/api/v1/hub/", body, **headers)
        said: dict[str, Any] = json.loads(text)
        return answer, said

    def lines(self) -> list[dict[str, Any]]:
        """Return the lines of the proxy's log."""
        return [json.loads(line) for line in self.log.read_text().splitlines()]

    def next_line(self, before: int) -> dict[str, Any]:
        """Return the line after the first `before` ones; nginx writes it after its answer."""
        until = time.monotonic() + 60
        while len(self.lines()) <= before and time.monotonic() < until:
            time.sleep(0.05)
        return self.lines()[before]


def environment_of(var: Path) -> dict[str, str]:
    unset = ("CAIR_", "DATABASE_", "DJANGO_", "PROMETHEUS_")
    kept = {name: value for name, value in os.environ.items() if not name.startswith(unset)}
    return kept | {
        "CAIR_VAR": str(var),
        "CAIR_HOSTS": HOST,
        "CAIR_HTTPS": "yes",
        "CAIR_ORIGINS": f"https://{HOST}",
        "PYTHONPATH": str(ROOT),
    }


def start_server(service: Service, number: int) -> "subprocess.Popen[bytes]":
    command = [sys.executable, "-m", "gunicorn", "--config", "cair_site/gunicorn_conf.py"]
    command += ["--bind", f"{HERE}:{service.behind[number]}", "--workers", "1"]
    environment = environment_of(service.folder / "var")
    with (service.folder / f"server{number}.log").open("ab") as log:
        return subprocess.Popen(
            command, cwd=ROOT, env=environment, stdout=log, stderr=log, start_new_session=True
        )


def kill(process: "subprocess.Popen[bytes]") -> None:
    """End a server and its workers without a word, as a machine that loses its power."""
    os.killpg(process.pid, signal.SIGKILL)
    process.wait(5)


def wait(port: int, path: str, seconds: float = 40) -> None:
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        connection = HTTPConnection(HERE, port, timeout=5)
        try:
            connection.request("GET", path)
            if connection.getresponse().status < 500:
                return
        except OSError:
            time.sleep(0.1)
        finally:
            connection.close()
    pytest.fail(f"Nobody answers at port {port}.")


def end(process: "subprocess.Popen[bytes]") -> None:
    if process.poll() is None:
        process.send_signal(signal.SIGQUIT)
        try:
            process.wait(10)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait(5)


def configuration(service: Service) -> Path:
    """Write our nginx.conf with ports and places of this machine; nothing else is changed."""
    text = (DEPLOY / "compose" / "nginx.conf").read_text()
    temporary = "/tmp/"  # noqa: S108
    for ours, here in {
        temporary: f"{service.folder}/",
        "/dev/stdout": str(service.log),
        "/dev/stderr": str(service.folder / "error.log"),
        "/run/secrets/": f"{service.folder}/",
        "172.30.77.11:8000": f"{HERE}:{service.behind[0]}",
        "172.30.77.12:8000": f"{HERE}:{service.behind[1]}",
        "listen 8080": f"listen {HERE}:{service.plain}",
        "listen 8443": f"listen {HERE}:{service.tls}",
    }.items():
        assert ours in text
        text = text.replace(ours, here)
    path = service.folder / "nginx.conf"
    path.write_text(text)
    return path


@contextmanager
def running(service: Service) -> Iterator[None]:
    made = [*CERTIFICATE, "-keyout", "tls.key", "-out", "tls.crt"]
    subprocess.run(made, cwd=service.folder, check=True, capture_output=True, timeout=60)
    path = configuration(service)
    with ExitStack() as stack:
        for number in range(2):
            service.servers.append(start_server(service, number))
            stack.callback(lambda number=number: end(service.servers[number]))
        user = ["-g", "daemon off; user root;" if os.geteuid() == 0 else "daemon off;"]
        proxy = subprocess.Popen([str(NGINX), "-c", str(path), *user], stderr=subprocess.DEVNULL)
        stack.callback(end, proxy)
        for port in service.behind:
            wait(port, "/readyz")
        wait(service.plain, "/")
        yield
