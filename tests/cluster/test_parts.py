"""The parts of a cluster: networks, the load balancer's file, what is ended."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from cluster.balancer import TALK, configuration
from cluster.network import Loopback, Namespaces, network
from cluster.nodes import Node
from cluster.processes import NotPossibleError, kill, plain_environment, program, start, wait_until


def nodes(folder: Path) -> list[Node]:
    net = Loopback()
    return [Node(number, net, folder / str(number), {}) for number in range(2)]


def test_the_file_of_the_load_balancer_is_accepted(tmp_path: Path) -> None:
    command = shutil.which("haproxy", path=f"{os.environ['PATH']}:/usr/sbin")
    if command is None:
        pytest.skip("haproxy is not installed: apt-get install haproxy")
    file = tmp_path / "haproxy.cfg"
    file.write_text(configuration(nodes(tmp_path), 8080, tmp_path), encoding="ascii")
    done = subprocess.run(
        [command, "-c", "-f", str(file)], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize(
    ("path", "again"),
    [
        ("/api/v1/hub/", True),
        ("/api/v1/dialogue/inspect/", True),
        ("/CAIR_hub", True),
        ("/it/CAIR_hub", True),
        ("/admin/dialogue/sentence/1/change/", False),
        ("/api/v1/ontology/", False),
        ("/api/v1/hubs/", False),
    ],
)
def test_only_what_writes_nothing_is_asked_twice(path: str, again: bool) -> None:
    assert bool(re.match(TALK, path)) is again


def test_every_node_has_a_line(tmp_path: Path) -> None:
    both = nodes(tmp_path)
    text = configuration(both, 8080, tmp_path)
    for node in both:
        assert text.count(f"server {node.name} 127.0.0.1:{node.address[1]} check") == 2


def test_a_program_that_is_missing_is_named_with_its_package() -> None:
    with pytest.raises(NotPossibleError, match="apt-get install some-package"):
        program("no-such-program", "some-package")


def test_a_cluster_takes_no_settings_from_the_shell(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CAIR_STATE_KEYS", "x")
    monkeypatch.setenv("DATABASE_URL", "x")
    assert not {"CAIR_STATE_KEYS", "DATABASE_URL"} & plain_environment().keys()


def test_killing_ends_the_children_too(tmp_path: Path) -> None:
    script = "import subprocess as s; p = s.Popen(['sleep', '60']); print(p.pid, flush=True)"
    script += "; p.wait()"
    with (tmp_path / "log").open("wb") as log:
        process = start([sys.executable, "-c", script], log, plain_environment())
    while not (text := (tmp_path / "log").read_text()).endswith("\n"):
        assert process.poll() is None
    kill(process)
    assert wait_until(lambda: ended(int(text)), 10) is not None


def ended(process: int) -> bool:
    """Say whether a process is gone, or waits only for its parent to hear of it."""
    try:
        return ") Z " in Path(f"/proc/{process}/stat").read_text()
    except (FileNotFoundError, ProcessLookupError):
        return True


def test_without_namespaces_all_is_on_the_loopback() -> None:
    with network(namespaces=False) as net:
        host, port = net.address(0)
        assert (host, net.address(0)) == ("127.0.0.1", (host, port))
        assert net.command(0, ["true"]) == ["true"]
        assert net.own_address == ""


def test_namespaces_leave_nothing_behind() -> None:
    with network() as net:
        if not isinstance(net, Namespaces):
            pytest.skip("No network namespaces here: not root, or no ip.")
        assert net.address(1)[0].startswith(net.subnet.rsplit(".", 1)[0])
        name = net.command(1, [])[3]
        assert name in _listed()
    assert name not in _listed()


def _listed() -> str:
    command = [shutil.which("ip") or "ip", "netns"]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout
