"""Where nodes live: each in a network namespace of its own, or all on the loopback.

With root and `ip`, a node is a machine of its own as far as the network goes: a cable (veth) leads
from it to a bridge, and to cut it off the cable is pulled. Elsewhere the processes of a node are
stopped (SIGSTOP): it answers nobody, but it does not notice that it was cut off.
"""

import ipaddress
import json
import os
import shutil
import signal
import subprocess
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Protocol

from cluster.processes import Process, free_port, signal_group

NODE_PORT = 8000
FIRST_NODE = 11


class Network(Protocol):
    """Gives nodes their addresses, and cuts them off."""

    how: str
    #: Where nodes find the database; "" where it is on the loopback like them.
    own_address: str
    subnet: str

    def address(self, node: int) -> tuple[str, int]:
        """Return where a node listens, and make room for it the first time."""

    def command(self, node: int, command: Sequence[str]) -> list[str]:
        """Return the command that runs a command where a node lives."""

    def cut(self, node: int, process: Process) -> None:
        """Let nothing through to a node nor from it."""

    def mend(self, node: int, process: Process) -> None:
        """Let everything through again."""


class Loopback:
    """All on 127.0.0.1, each on a port of its own."""

    how = "loopback; a node that is cut off is stopped (SIGSTOP)"
    own_address = ""
    subnet = ""

    def __init__(self) -> None:
        self._ports: dict[int, int] = {}

    def address(self, node: int) -> tuple[str, int]:
        """Return a free port of the loopback, the same one each time."""
        if node not in self._ports:
            self._ports[node] = free_port()
        return "127.0.0.1", self._ports[node]

    def command(self, node: int, command: Sequence[str]) -> list[str]:
        """Return the command as it is."""
        return list(command)

    def cut(self, node: int, process: Process) -> None:
        """Stop the processes of a node."""
        signal_group(process, signal.SIGSTOP)

    def mend(self, node: int, process: Process) -> None:
        """Let the processes of a node go on."""
        signal_group(process, signal.SIGCONT)


class Namespaces:
    """A network namespace for each node, joined by a bridge on this machine."""

    how = "a network namespace for each node; a node is cut off by pulling its cable (veth down)"

    def __init__(self, subnet: ipaddress.IPv4Network) -> None:
        self.subnet = str(subnet)
        self.own_address = str(subnet[1])
        self._hosts = subnet
        self._mark = f"{os.getpid():x}"
        self._bridge = f"cb{self._mark}"
        self._made: list[int] = []

    def open(self) -> None:
        """Make the bridge."""
        _ip("link", "add", self._bridge, "type", "bridge")
        _ip("addr", "add", f"{self.own_address}/24", "dev", self._bridge)
        _ip("link", "set", self._bridge, "up")

    def close(self) -> None:
        """Take away the namespaces, with what hangs on them, and the bridge."""
        for node in self._made:
            _ip("netns", "del", self._name(node), check=False)
            _ip("link", "del", self._cable(node), check=False)
        _ip("link", "del", self._bridge, check=False)

    def address(self, node: int) -> tuple[str, int]:
        """Return the address of a node; its namespace and its cable are made the first time."""
        host = str(self._hosts[FIRST_NODE + node])
        if node not in self._made:
            self._made.append(node)
            self._lay_cable(node, host)
        return host, NODE_PORT

    def command(self, node: int, command: Sequence[str]) -> list[str]:
        """Return the command that runs in the namespace of a node, with the same process id."""
        return ["ip", "netns", "exec", self._name(node), *command]

    def cut(self, node: int, process: Process) -> None:
        """Pull the cable of a node."""
        _ip("link", "set", self._cable(node), "down")

    def mend(self, node: int, process: Process) -> None:
        """Put the cable of a node in again."""
        _ip("link", "set", self._cable(node), "up")

    def _lay_cable(self, node: int, host: str) -> None:
        name, cable, end = self._name(node), self._cable(node), f"cn{self._mark}x{node}"
        _ip("netns", "add", name)
        _ip("link", "add", cable, "type", "veth", "peer", "name", end)
        _ip("link", "set", end, "netns", name)
        _ip("link", "set", cable, "master", self._bridge, "up")
        _ip("-n", name, "addr", "add", f"{host}/24", "dev", end)
        _ip("-n", name, "link", "set", end, "up")
        _ip("-n", name, "link", "set", "lo", "up")

    def _name(self, node: int) -> str:
        return f"cair-{self._mark}-{node}"

    def _cable(self, node: int) -> str:
        return f"ch{self._mark}x{node}"


def _ip(*arguments: str, check: bool = True) -> str:
    done = subprocess.run(
        ["ip", *arguments],  # noqa: S607 - root's own
        capture_output=True,
        text=True,
        check=False,
    )
    if check and done.returncode:
        raise OSError(f"ip {' '.join(arguments)}: {done.stderr.strip()}")
    return done.stdout


def _free_subnet() -> ipaddress.IPv4Network:
    """Return a private network that no interface of this machine is in."""
    taken = [
        ipaddress.ip_network(f"{one['local']}/{one['prefixlen']}", strict=False)
        for link in json.loads(_ip("-j", "-4", "addr"))
        for one in link.get("addr_info", ())
    ]
    for third in range(20, 250):
        subnet = ipaddress.IPv4Network(f"10.213.{third}.0/24")
        if not any(subnet.overlaps(one) for one in taken):
            return subnet
    raise OSError("No private network is free.")


@contextmanager
def network(*, namespaces: bool = True) -> Iterator[Network]:
    """Yield namespaces where they can be had (and are wanted), else the loopback."""
    made = _namespaces() if namespaces and not os.geteuid() and shutil.which("ip") else None
    if made is None:
        yield Loopback()
        return
    try:
        yield made
    finally:
        made.close()


def _namespaces() -> Namespaces | None:
    """Return namespaces that work: the first is made to try it."""
    try:
        made = Namespaces(_free_subnet())
    except OSError:
        return None
    try:
        made.open()
        made.address(0)
        subprocess.run(made.command(0, ["true"]), check=True, capture_output=True)
    except (OSError, subprocess.CalledProcessError):
        made.close()
        return None
    return made
