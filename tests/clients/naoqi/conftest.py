"""A Pepper that only writes down what it would do, on a real qi session where there is qi."""

import json
import sys
import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.clients.naoqi.fake_robot import FakeRobot, Notes, without_qi
from tests.clients.naoqi.fake_services import services
from tests.server.conftest import Server

CLIENT = Path(__file__).resolve().parent.parent.parent.parent / "clients" / "naoqi"
sys.path.insert(0, str(CLIENT))

#: What a robot of a test has besides the defaults.
SETTINGS: dict[str, Any] = {"seed": 7, "echo": 0.0, "patience": 10, "person": "Anna"}


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Mark what starts a server."""
    for item in items:
        if "server" in getattr(item, "fixturenames", ()):
            item.add_marker(pytest.mark.server)


def with_qi() -> tuple[FakeRobot, Callable[[], None]]:
    """Return a robot on a qi session of its own, and what closes it."""
    qi = pytest.importorskip("qi", reason="qi, the library of NAOqi robots, is not installed")
    qi.logging.setLevel(qi.logging.ERROR)
    notes = Notes()
    offered = services(notes, lambda signature: qi.Signal(signature))
    naoqi, session = qi.Session(), qi.Session()
    naoqi.listenStandalone("tcp://127.0.0.1:0")
    for name, service in offered.items():
        kind = type(service)
        several_at_once = qi.multiThreaded()(type(kind.__name__, (kind,), {}))
        service.__class__ = several_at_once
        naoqi.registerService(name, service)
    session.connect(naoqi.endpoints()[0])

    def close() -> None:
        session.close()
        naoqi.close()

    robot = FakeRobot(notes, offered, session)
    robot.address = naoqi.endpoints()[0]
    return robot, close


@pytest.fixture(params=["qi", "without qi"])
def pepper(request: pytest.FixtureRequest, loopback: None) -> Iterator[FakeRobot]:
    """Return a Pepper with all its services."""
    if request.param == "without qi":
        yield without_qi()
        return
    robot, close = with_qi()
    yield robot
    close()


@pytest.fixture
def plain_pepper() -> FakeRobot:
    """Return a Pepper without a qi session, for what does not depend on one."""
    return without_qi()


@pytest.fixture
def let_talk(tmp_path: Path) -> Iterator[Callable[..., Any]]:
    """Return a function that lets a robot talk: let_talk(pepper, address, language="it")."""
    from cair_pepper.robot import Robot
    from cair_pepper.settings import read_settings

    running: list[tuple[Any, threading.Thread]] = []

    def start(robot: FakeRobot, address: str, **settings: Any) -> Any:
        alone = {
            key: settings.pop(key) for key in ("now", "chance", "talk_with") if key in settings
        }
        own = {**SETTINGS, "server": address, "folder": str(tmp_path / "cair"), **settings}
        program = Robot(robot.session, read_settings(json.dumps(own)), **alone)
        thread = threading.Thread(target=program.run)
        thread.start()
        running.append((program, thread))
        return program

    yield start
    for program, thread in running:
        program.end()
        thread.join(20)
        assert not thread.is_alive()


@pytest.fixture
def address(server: Server) -> str:
    """Return the server's address."""
    return f"http://127.0.0.1:{server.port}"
