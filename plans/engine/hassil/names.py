"""Names, phrases and notes of converted intents, as authors of this library write them."""

import re

from plans.engine.hassil.data import Block
from plans.engine.hassil.grammar import Group, Items, ListUse, Space, Text
from plans.engine.patterns import Choice, Sequence, print_pattern

_HUMPS = re.compile(r"(?<=[a-z0-9])(?=[A-Z])|[^A-Za-z0-9]+")


def key_of(name: str) -> str:
    """Return a name as the library writes names: "HassTurnOn" is "hass_turn_on"."""
    key = _HUMPS.sub("_", name).strip("_").lower()
    return key if key[:1].isalpha() else f"x_{key}"


def phrase_text(sequence: Sequence) -> str:
    """Return a phrase as its author writes it: `|` stands outside brackets."""
    only = sequence.parts[0] if len(sequence.parts) == 1 else None
    if isinstance(only, Choice) and not only.optional:
        return "|".join(map(print_pattern, only.options))
    return print_pattern(sequence)


def joined(form: Items) -> str:
    """Return the text of items without groups."""
    letters = (
        item.text if isinstance(item, Text) else " " if isinstance(item, Space) else ""
        for item in form
    )
    return " ".join("".join(letters).split())


def has_lists(items: Items) -> bool:
    """Say whether a list is used anywhere in some items."""
    return any(
        isinstance(item, ListUse) or (isinstance(item, Group) and any(map(has_lists, item.options)))
        for item in items
    )


def note_of(name: str, blocks: tuple[Block, ...]) -> str:
    """Return what of an intent of hassil is not in its triggers."""
    fixed = dict.fromkeys(
        f"{slot}={value}" for block in blocks for slot, value in block.fixed.items()
    )
    notes = [f"From {name} of hassil."]
    if fixed:
        notes.append(f"Some of its sentences also mean {', '.join(fixed)}.")
    if any(block.in_context for block in blocks):
        notes.append("Some of them asked for a context, which is not kept.")
    return " ".join(notes)
