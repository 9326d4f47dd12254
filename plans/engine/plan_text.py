"""How experts write plans: `#action=goto where=docking station#action=rest`."""

import re
from collections.abc import Iterable

from plans.engine.intents import ActionItem

_ITEM = re.compile(r"action=(\w+)(?: (.*))?", re.ASCII | re.DOTALL)
_KEY = re.compile(r"(?:^| )([a-z][a-z0-9_]*)=")


class PlanTextError(ValueError):
    """A plan that cannot be read; `position` counts characters from 0."""

    def __init__(self, message: str, *, position: int, text: str) -> None:
        super().__init__(f"{message} at position {position} of {text!r}")
        self.message = message
        self.position = position
        self.text = text


def parse_plan(text: str) -> tuple[ActionItem, ...]:
    """Return the actions of a plan text; "" is no action."""
    if not text:
        return ()
    if not text.startswith("#"):
        raise PlanTextError("A plan begins with '#action='", position=0, text=text)
    items: list[ActionItem] = []
    position = 1
    for piece in text[1:].split("#"):
        found = _ITEM.fullmatch(piece)
        if found is None:
            message = "Expected 'action=' and a name"
            raise PlanTextError(message, position=position, text=text)
        items.append(ActionItem(action=found[1], parameters=_parameters(found[2] or "")))
        position += len(piece) + 1
    return tuple(items)


def print_plan(items: Iterable[ActionItem]) -> str:
    """Return the text of a plan; reading it again gives the same actions."""
    return "".join(
        " ".join([f"#action={item.action}", *(f"{key}={value}" for key, value in item.parameters)])
        for item in items
    )


def _parameters(text: str) -> tuple[tuple[str, str], ...]:
    keys = list(_KEY.finditer(text))
    ends = [*(key.start() for key in keys[1:]), len(text)][: len(keys)]
    return tuple(
        (key[1], text[key.end() : end].strip()) for key, end in zip(keys, ends, strict=True)
    )
