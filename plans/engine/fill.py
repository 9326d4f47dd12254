"""Plan strings and plan sentences with the person's words in them, so that nothing is forged.

The guarantees of the plan string: every key of an action is present ("None" where unknown), free
text is last, no `#`, newline or second `action=` comes from a value, no blank before the next `#`.
"""

import re
import unicodedata
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from plans.engine.actions import ACTIONS_BY_NAME, Parameter, ParameterKind
from plans.engine.intents import ActionItem
from plans.engine.kb_actions import KB_ACTIONS_BY_NAME

LONGEST_VALUE = 200

_SLOT = re.compile(r"\{([a-z][a-z0-9_]*)\}")
_FORGERY = re.compile(r"action\s*=", re.IGNORECASE)
_ONE_WORD = re.compile(r"\w+", re.ASCII)
_NOT_IN_WORD = re.compile(r"[^\w.]+")
_DROPPED = frozenset("#\uff03\ufe5f")


@dataclass(frozen=True, slots=True)
class FilledAction:
    """One action with its values; None is a parameter nobody gave."""

    action: str
    parameters: dict[str, str | None]


def slots_in(template: str) -> frozenset[str]:
    """Return the names of the `{slots}` a template asks for."""
    return frozenset(_SLOT.findall(template))


def fill_text(template: str, values: Mapping[str, str]) -> str | None:
    """Return the template with its slots filled, or None where one is missing."""
    if not slots_in(template) <= values.keys():
        return None
    return _SLOT.sub(lambda slot: values[slot[1]], template)


def clean(value: str) -> str:
    """Return a value that is safe in a plan: one line, no `#`, no `action=`, at most 200 signs.

    >>> clean("Hey #action=rest")
    'Hey rest'
    """
    kept = "".join(" " if _unsafe(sign) else sign for sign in value[: 4 * LONGEST_VALUE])
    while _FORGERY.search(kept):
        kept = _FORGERY.sub(" ", kept)
    return " ".join(kept.split())[:LONGEST_VALUE].rstrip()


def _unsafe(sign: str) -> bool:
    return sign in _DROPPED or unicodedata.category(sign) in ("Cc", "Cs", "Zl", "Zp")


def fill_actions(
    items: Iterable[ActionItem], values: Mapping[str, str]
) -> tuple[FilledAction, ...]:
    """Return the actions with every parameter of their kind, in the table's order."""
    return tuple(_fill_action(item, values) for item in items)


def _fill_action(item: ActionItem, values: Mapping[str, str]) -> FilledAction:
    written = dict(item.parameters)
    filled = {
        name: fill_text(written[name], values) if name in written else None
        for name in _names(item.action)
    }
    cleaned = {name: clean(value) if value else None for name, value in filled.items()}
    for parameter in _client_parameters(item.action):
        cleaned[parameter.name] = _fitting(parameter, cleaned[parameter.name])
    return FilledAction(item.action, {name: value or None for name, value in cleaned.items()})


def _names(action: str) -> tuple[str, ...]:
    if action in KB_ACTIONS_BY_NAME:
        return KB_ACTIONS_BY_NAME[action].parameters
    return tuple(parameter.name for parameter in _client_parameters(action))


def _client_parameters(action: str) -> tuple[Parameter, ...]:
    known = ACTIONS_BY_NAME.get(action)
    return known.parameters if known else ()


def _fitting(parameter: Parameter, value: str | None) -> str | None:
    """Return the value where clients can read it: word parameters are single ASCII words."""
    if value is None or parameter.kind is ParameterKind.TEXT:
        return value
    single = _ONE_WORD.fullmatch(value) is not None
    return value if single and (not parameter.values or value in parameter.values) else None


def plan_string(actions: Iterable[FilledAction]) -> str:
    """Return the plan string of client actions: `#action=playsong title=Hey Brother`."""
    return "".join(_item(action, action.parameters) for action in actions)


def kbplan_string(actions: Iterable[FilledAction]) -> str:
    """Return the KBplan string, where every value is one word: `topic=green_tea value=1.0`."""
    return "".join(
        _item(action, {name: _one_word(value) for name, value in action.parameters.items()})
        for action in actions
    )


def _item(action: FilledAction, values: Mapping[str, str | None]) -> str:
    pairs = (f" {name}={value or 'None'}" for name, value in values.items())
    return f"#action={action.action}{''.join(pairs)}"


def _one_word(value: str | None) -> str | None:
    return _NOT_IN_WORD.sub("_", value).strip("_") if value else None
