"""So much of rclpy as the ROS 2 node uses, its messages made from the package's own files.

Only what the files declare can be set, and only to values of the declared types, as with rosidl.
"""

import logging
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

DEFAULTS: dict[str, Any] = {"string": "", "bool": False}
STANDARD = {
    "std_msgs.msg": {"String": "string data", "Empty": ""},
    "std_srvs.srv": {"Trigger": "---\nbool success\nstring message"},
}


def fields_of(text: str) -> list[tuple[str, str]]:
    """Return the (type, name) of each line of a message file."""
    lines = (line.split("#")[0].split() for line in text.splitlines())
    return [(words[0], words[1]) for words in lines if words]


def _default(kind: str, known: dict[str, type]) -> Any:
    if kind.endswith("[]"):
        return []
    return DEFAULTS[kind] if kind in DEFAULTS else known[kind]()


def _right(kind: str, value: object, known: dict[str, type]) -> bool:
    if kind.endswith("[]"):
        return isinstance(value, list) and all(_right(kind[:-2], one, known) for one in value)
    return type(value) is (type(DEFAULTS[kind]) if kind in DEFAULTS else known[kind])


def message(name: str, text: str, known: dict[str, type]) -> type:
    """Return the class of a message; `known` has the classes that its fields may have."""
    kinds = {field: kind for kind, field in fields_of(text)}

    def fill(self: Any, **values: object) -> None:
        for field, kind in kinds.items():
            setattr(self, field, _default(kind, known))
        for field, value in values.items():
            setattr(self, field, value)

    def set_field(self: Any, field: str, value: object) -> None:
        assert field in kinds, f"{name} has no {field}"
        assert _right(kinds[field], value, known), (
            f"{name}.{field} is {kinds[field]}, not {value!r}"
        )
        object.__setattr__(self, field, value)

    return type(name, (), {"__init__": fill, "__setattr__": set_field, "fields": kinds})


def service(name: str, text: str, known: dict[str, type]) -> SimpleNamespace:
    """Return the Request and Response of a service file."""
    request, _, response = text.partition("---")
    return SimpleNamespace(
        Request=message(f"{name}.Request", request, known),
        Response=message(f"{name}.Response", response, known),
    )


def interfaces(folder: Path) -> dict[str, dict[str, Any]]:
    """Return the modules of an interfaces package: {"cair_interfaces.msg": {"Action": …}}."""
    package = folder.name
    known: dict[str, type] = {}
    for name in ("Action", "Reply"):
        text = (folder / "msg" / f"{name}.msg").read_text(encoding="utf-8")
        known[f"{package}/{name}"] = message(name, text, known)
    services = {
        file.stem: service(file.stem, file.read_text(encoding="utf-8"), known)
        for file in sorted((folder / "srv").glob("*.srv"))
    }
    messages = {name.split("/")[1]: kind for name, kind in known.items()}
    return {f"{package}.msg": messages, f"{package}.srv": services}


class Publisher:
    """Keeps what is published; somebody always listens."""

    def __init__(self, kind: type) -> None:
        self.kind = kind
        self.published: list[Any] = []

    def publish(self, published: object) -> None:
        assert type(published) is self.kind, published
        self.published.append(published)

    def get_subscription_count(self) -> int:
        return 1


class Node:
    """A node whose parameters are those in `given`; callbacks are called by the test."""

    given: dict[str, object] = {}

    def __init__(self, name: str) -> None:
        self._name = name
        self._declared: dict[str, Any] = {}
        self.publishers: dict[str, Publisher] = {}
        self.callbacks: dict[str, tuple[Any, Callable[..., Any]]] = {}

    def get_name(self) -> str:
        return self._name

    def get_logger(self) -> logging.Logger:
        return logging.getLogger("stub")

    def declare_parameter(self, name: str, default: object) -> None:
        value = self.given.get(name, default)
        assert type(value) is type(default), f"{name} is {value!r}, declared as {default!r}"
        self._declared[name] = value

    def get_parameter(self, name: str) -> SimpleNamespace:
        return SimpleNamespace(value=self._declared[name])

    def create_publisher(self, kind: type, topic: str, depth: int) -> Publisher:
        self.publishers[topic] = Publisher(kind)
        return self.publishers[topic]

    def create_subscription(
        self,
        kind: type,
        topic: str,
        callback: Callable[..., Any],
        depth: int,
        *,
        callback_group: object,
    ) -> None:
        self.callbacks[topic] = kind, callback

    def create_service(
        self, kind: Any, name: str, callback: Callable[..., Any], *, callback_group: object
    ) -> None:
        self.callbacks[name] = kind, callback

    def destroy_node(self) -> None:
        self.callbacks.clear()

    def send(self, topic: str, **fields: object) -> None:
        """Let a message come in."""
        kind, callback = self.callbacks[topic]
        callback(kind(**fields))

    def ask(self, name: str, **fields: object) -> Any:
        """Return what a service answers."""
        kind, callback = self.callbacks[name]
        answer = callback(kind.Request(**fields), kind.Response())
        assert type(answer) is kind.Response
        return answer


@contextmanager
def rclpy_stub(folder: Path, spin: Callable[[Node], None]) -> Iterator[None]:
    """Let rclpy and the messages be imported; rclpy.spin() calls `spin` with the node."""
    shutdown = threading.Event()
    modules: dict[str, dict[str, Any]] = {
        "rclpy": {
            "init": lambda: None,
            "spin": lambda node, executor: spin(node),
            "try_shutdown": shutdown.set,
        },
        "rclpy.node": {"Node": Node},
        "rclpy.callback_groups": {"ReentrantCallbackGroup": object},
        "rclpy.executors": {
            "ExternalShutdownException": type("ExternalShutdownException", (Exception,), {}),
            "MultiThreadedExecutor": object,
        },
        **{
            module: {
                name: (message if module.endswith("msg") else service)(name, text, {})
                for name, text in texts.items()
            }
            for module, texts in STANDARD.items()
        },
        **interfaces(folder),
    }
    for name, content in modules.items():
        for whole in (name.split(".")[0], name):
            sys.modules.setdefault(whole, ModuleType(whole))
        vars(sys.modules[name]).update(content)
    try:
        yield
        assert shutdown.is_set()
    finally:
        for name in [*modules, *(name.split(".")[0] for name in modules)]:
            sys.modules.pop(name, None)
