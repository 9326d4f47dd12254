"""A real roscore on loopback where Debian's ROS is; nodes are ended by their process ids."""

import json
import os
import signal
import socket
import subprocess
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.clients.network import Network
from tests.server.conftest import Server, wait_for

CLIENTS = Path(__file__).resolve().parent.parent.parent.parent / "clients"
ROS1 = CLIENTS / "ros1" / "cair_ros"
ROS2 = CLIENTS / "ros2"

#: What `make test-ros` installs, by a file of each package that the tests need.
NEEDED = {
    "python3-roslaunch": "/usr/bin/roscore",
    "python3-rospy": "/usr/lib/python3/dist-packages/rospy/__init__.py",
    "python3-std-srvs": "/usr/lib/python3/dist-packages/std_srvs/srv/__init__.py",
    "python3-std-msgs": "/usr/lib/python3/dist-packages/std_msgs/msg/__init__.py",
    "ros-message-generation": "/usr/share/message_generation/package.xml",
    "catkin": "/usr/bin/catkin_make",
    "g++": "/usr/bin/g++",
}


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Mark what starts a server."""
    for item in items:
        if "server" in getattr(item, "fixturenames", ()):
            item.add_marker(pytest.mark.server)


class Process:
    """A program of ours and all it starts, with what it writes."""

    def __init__(self, command: list[str], environment: dict[str, str], folder: Path) -> None:
        self.log = folder / f"{Path(command[0]).name}-{time.monotonic_ns()}.log"
        with self.log.open("wb") as errors:
            self._process = subprocess.Popen(
                command,
                cwd=folder,
                env=environment,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=errors,
                text=True,
                start_new_session=True,
            )
        self.lines: list[str] = []
        self._reading = threading.Thread(target=self._read)
        self._reading.start()

    def _read(self) -> None:
        assert self._process.stdout is not None
        for line in self._process.stdout:
            self.lines.append(line)

    def running(self) -> bool:
        return self._process.poll() is None

    def write(self, line: str) -> None:
        assert self._process.stdin is not None
        self._process.stdin.write(line + "\n")
        self._process.stdin.flush()

    def stop(self) -> None:
        """End it as Ctrl-C would; what it has started ends with it."""
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._process.stdin.close()
        if self.running():
            self._process.send_signal(signal.SIGINT)
        try:
            self._process.wait(20)
        except subprocess.TimeoutExpired:
            os.killpg(self._process.pid, signal.SIGKILL)
            self._process.wait(5)
        self._reading.join(10)
        self._process.stdout.close()


class Peer:
    """The other node: tell("hear", "Hello") makes it publish; `events` is what it received."""

    def __init__(self, process: Process) -> None:
        self.process = process

    @property
    def events(self) -> list[dict[str, Any]]:
        return [json.loads(line) for line in self.process.lines]

    def tell(self, *command: object) -> None:
        self.process.write(json.dumps(command))

    def next(self, count: int, kinds: tuple[str, ...], after: int) -> list[dict[str, Any]]:
        """Return the next so many events of these kinds, when they have come."""

        def come() -> list[dict[str, Any]]:
            return [one for one in self.events[after:] if one["kind"] in kinds]

        assert wait_for(lambda: len(come()) >= count, 30), self.events[after:]
        return come()[:count]

    def answer_to(self, *command: object) -> dict[str, Any]:
        """Return what a service answers."""
        after = len(self.events)
        self.tell(*command)
        kinds = {"say": "said", "start": "started", "stop": "stopped", "connected": "connected"}
        return self.next(1, (kinds[str(command[0])],), after)[0]


@pytest.fixture(scope="session")
def ros(loopback: None) -> None:
    """Skip where Debian's ROS 1 is not installed."""
    missing = [package for package, file in NEEDED.items() if not Path(file).exists()]
    if missing:
        pytest.skip(f"ROS 1 is not here (apt-get install {' '.join(missing)})")


@pytest.fixture(scope="session")
def workspace(ros: None, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a catkin workspace with the package built in it."""
    folder = tmp_path_factory.mktemp("workspace")
    (folder / "src").mkdir()
    (folder / "src" / "cair_ros").symlink_to(ROS1)
    built = subprocess.run(
        ["/usr/bin/catkin_make", "-j1", "-DPYTHON_EXECUTABLE=/usr/bin/python3"],
        cwd=folder,
        env={"PATH": "/usr/bin:/bin", "HOME": str(folder)},
        capture_output=True,
        text=True,
        check=False,
        timeout=300,
    )
    assert built.returncode == 0, built.stderr[-3000:]
    return folder


@pytest.fixture(scope="session")
def launch(workspace: Path) -> Iterator[Callable[..., Process]]:
    """Return a function that runs a program of ROS beside a roscore of its own."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        master = f"http://127.0.0.1:{free.getsockname()[1]}"
    environment = {
        "PATH": "/usr/bin:/bin",
        "LANG": "C.UTF-8",
        "HOME": str(workspace),
        "ROS_HOME": str(workspace / "ros_home"),
        "ROS_MASTER_URI": master,
        "ROS_HOSTNAME": "127.0.0.1",
        "PYTHONUNBUFFERED": "1",
    }
    started: list[Process] = []

    def run(*command: str) -> Process:
        shell = '. devel/setup.sh && export ROS_MASTER_URI="$0" && exec "$@"'
        started.append(
            Process(["/bin/bash", "-c", shell, master, *command], environment, workspace)
        )
        return started[-1]

    core = run("roscore", "-p", master.rsplit(":", 1)[1])
    assert wait_for(lambda: "started core service" in "".join(core.lines), 30), core.lines
    yield run
    for process in reversed(started):
        process.stop()


@pytest.fixture(scope="module")
def network(server: Server) -> Iterator[Network]:
    """Return the network between the node and the server."""
    between = Network(server.port)
    between.up()
    yield between
    between.down()


@pytest.fixture(scope="module")
def peer(launch: Callable[..., Process]) -> Iterator[Peer]:
    """Return another node, which listens to all the node under test publishes."""
    process = launch("/usr/bin/python3", str(Path(__file__).parent / "peer.py"))
    yield Peer(process)
    process.stop()


@pytest.fixture(scope="module")
def node(launch: Callable[..., Process], peer: Peer, network: Network) -> Iterator[Process]:
    """Return the node under test, as roslaunch starts it."""
    settings = {"server": network.address, "language": "en", "person": "Anna", "seed": "7"}
    settings |= {"patience": "5", "timeout": "5"}
    arguments = [f"{name}:={value}" for name, value in settings.items()]
    process = launch("roslaunch", "cair_ros", "cair.launch", *arguments)
    assert wait_for(lambda: peer.answer_to("connected")["yes"], 30), "".join(process.lines)
    yield process
    process.stop()
