from collections.abc import Callable, Iterable, Mapping
from typing import Any, NamedTuple, TypeVar, overload

__version__: str
__all__ = ["Action", "CairError", "Conversation", "Reply", "UnreachableError"]

LONGEST_ANSWER: int
LONGEST_PAUSE: float
ANY: str
AT_ONCE: tuple[str, ...]
PASSING: tuple[int, ...]
SILENCE: Reply

class CairError(Exception):
    code: str
    message: str
    hint: str
    status: int
    def __init__(self, code: str, message: str, hint: str = "", status: int = 0) -> None: ...

class UnreachableError(CairError): ...

class Action(NamedTuple):
    name: str
    parameters: dict[str, str | None]

class Reply(NamedTuple):
    plan_sentence: str
    dialogue_sentence: str
    actions: tuple[Action, ...]
    plan: str
    topic: str
    sentence_type: str
    restarted: bool
    @property
    def text(self) -> str: ...

_Handler = TypeVar("_Handler", bound=Callable[[Action], object])
_Transport = Callable[
    [str, str, dict[str, str], bytes | None, float], tuple[int, Mapping[str, str], bytes]
]

class Conversation:
    language: str | None
    culture: str | None
    person: str | None
    gender: str | None
    seed: int | None
    def __init__(
        self,
        server: str,
        language: str | None = None,
        culture: str | None = None,
        state_file: str | None = None,
        person: str | None = None,
        gender: str | None = None,
        key: str | None = None,
        capabilities: Iterable[str] | None = None,
        seed: int | None = None,
        timeout: float = 10.0,
        patience: float = 30.0,
        ca_file: str | None = None,
        transport: _Transport | None = None,
    ) -> None: ...
    @property
    def dialogue_state(self) -> str: ...
    @property
    def capabilities(self) -> list[str] | None: ...
    @overload
    def on(self, action: str, handler: None = None) -> Callable[[_Handler], _Handler]: ...
    @overload
    def on(self, action: str, handler: _Handler) -> _Handler: ...
    def start(self, afresh: bool = False) -> Reply: ...
    def say(self, text: str) -> Reply: ...
    def perform(self, reply: Reply, say: Callable[[str], object]) -> list[Action]: ...
    def call(self, method: str, path: str, fields: Mapping[str, Any] | None = None) -> Any: ...
