"""HAProxy in front of the nodes: it asks each for /readyz, and lets another node try again.

A turn may be asked of another node when the first is gone, answers 502, 503 or 504, or takes too
long: the service keeps nothing of a turn, so taking it twice gives what taking it once gives. That
is no rule for the admin's pages, which write: they are tried again only where there was no
connection.
"""

import csv
import io
import signal
import socket
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from cluster.nodes import Node
from cluster.processes import Process, end, free_port, plain_environment, program, start, wait_until

#: What talks: all of it may be asked twice.
TALK = "^/(api/v1/(hub|plan|dialogue|topics|intents|actions)(/|$)|([a-z]{2}/)?CAIR_hub)"
CONFIGURATION = """global
    maxconn 4000
    # A turn to be asked again must fit, and fits by far: states are a few kilobytes.
    tune.bufsize 65536
    stats socket {socket} mode 600 level user

defaults
    mode http
    timeout http-request 10s
    timeout http-keep-alive 30s
    timeout client 30s
    timeout queue 10s
    timeout connect 500ms
    retries 5
    option redispatch 1
    option httpchk
    http-check send meth GET uri /readyz ver HTTP/1.1 hdr Host localhost
    http-check expect status 200
    timeout check 1s
    default-server inter 500ms fall 2 rise 1

frontend cair
    bind 127.0.0.1:{port}
    use_backend talk if {{ path_reg {talk} }}
    default_backend pages

backend talk
    balance roundrobin
    # The whole body is here before a node is chosen: it can be sent again.
    option http-buffer-request
    retry-on conn-failure empty-response junk-response response-timeout 502 503 504
    timeout server {turn_seconds}s
{servers}

backend pages
    balance roundrobin
    timeout server 120s
{servers}
"""
#: The longest that a turn may take on one node before another one is asked.
TURN_SECONDS = 2


@dataclass
class Balancer:
    """A running HAProxy."""

    folder: Path
    port: int
    process: Process | None = None

    @property
    def url(self) -> str:
        """Return the address that people and robots use."""
        return f"http://127.0.0.1:{self.port}/"

    def stop(self) -> None:
        """End it at once."""
        if self.process:
            end(self.process, signal.SIGTERM, 5)

    def up(self) -> set[str]:
        """Return the names of the nodes it sends turns to."""
        rows = csv.DictReader(io.StringIO(self._ask("show stat").lstrip("# ")))
        return {
            row["svname"]
            for row in rows
            if row["pxname"] == "talk"
            and row["svname"] != "BACKEND"
            and row["status"].startswith("UP")
        }

    def _ask(self, question: str) -> str:
        with socket.socket(socket.AF_UNIX) as asked:
            asked.settimeout(5)
            asked.connect(str(self.folder / "socket"))
            asked.sendall(f"{question}\n".encode())
            return b"".join(iter(lambda: asked.recv(65536), b"")).decode()


def configuration(nodes: Sequence[Node], port: int, folder: Path) -> str:
    """Return the text of haproxy.cfg."""
    servers = "\n".join(
        f"    server {node.name} {node.address[0]}:{node.address[1]} check" for node in nodes
    )
    return CONFIGURATION.format(
        socket=folder / "socket",
        port=port,
        talk=TALK,
        turn_seconds=TURN_SECONDS,
        servers=servers,
    )


def start_balancer(nodes: Sequence[Node], folder: Path, port: int = 0) -> Balancer:
    """Start HAProxy on a port of the loopback and wait until it sends turns to all nodes."""
    command = program("haproxy", "haproxy")
    folder.mkdir(parents=True, exist_ok=True)
    balancer = Balancer(folder, port or free_port())
    file = folder / "haproxy.cfg"
    file.write_text(configuration(nodes, balancer.port, folder), encoding="ascii")
    with (folder / "log").open("ab") as log:
        balancer.process = start([command, "-db", "-f", str(file)], log, plain_environment())
    names = {node.name for node in nodes}
    if wait_until(lambda: _answers(balancer) and balancer.up() == names, 15) is None:
        balancer.stop()
        told = (folder / "log").read_text(errors="replace")[-2000:]
        raise RuntimeError(f"HAProxy did not start:\n{told}")
    return balancer


def _answers(balancer: Balancer) -> bool:
    try:
        balancer.up()
    except OSError:
        return False
    return True
