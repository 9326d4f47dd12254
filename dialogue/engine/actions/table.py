"""The table of KBplan actions: name → what the Dialogue Manager does (Algorithm 1, lines 3-19)."""

from collections.abc import Callable, Mapping
from types import MappingProxyType

from dialogue.engine.actions.abilities import abilities
from dialogue.engine.actions.change import change
from dialogue.engine.actions.forget import forget
from dialogue.engine.actions.jump import jump
from dialogue.engine.actions.leave import leave
from dialogue.engine.actions.list_topics import list_topics
from dialogue.engine.actions.listen import listen_now
from dialogue.engine.actions.more import more
from dialogue.engine.actions.opinion import opinion
from dialogue.engine.actions.repeat import repeat
from dialogue.engine.actions.setlikeliness import set_likeliness
from dialogue.engine.actions.stop import stop
from dialogue.engine.actions.tell import tell
from dialogue.engine.turn import Turn

#: An action returns True where it has said the reply, so that the turn is over.
Act = Callable[[Turn, Mapping[str, str | None]], bool]

ACTIONS: Mapping[str, Act] = MappingProxyType(
    {
        "setlikeliness": set_likeliness,
        "jump": jump,
        "leave": leave,
        "change": change,
        "repeat": repeat,
        "opinion": opinion,
        "more": more,
        "stop": stop,
        "forget": forget,
        "list": list_topics,
        "abilities": abilities,
        "listen": listen_now,
        "tell": tell,
    }
)
