"""The fields of a name as an author typed them, checked before any form is made."""

import re
from collections.abc import Mapping

from languages.language import FormError

LONGEST = 120
_FORBIDDEN = re.compile(r"[${}|\x00-\x1f\x7f\u2028\u2029]")


def check_fields(fields: Mapping[str, str], allowed: frozenset[str]) -> None:
    """Raise FormError for an unknown field, a missing name or a text that cannot be said."""
    for field, text in fields.items():
        if field not in allowed:
            raise FormError(
                field, "A name has no such field.", f"Use one of: {', '.join(sorted(allowed))}."
            )
        _check_text(field, text)
    if "name" not in fields:
        raise FormError("name", "The name is missing.", "Write what fits after 'I like ...'.")


def _check_text(field: str, text: str) -> None:
    if not text or text != text.strip():
        raise FormError(field, f"{text!r} is empty or has outer blanks.", "Remove it or fill it.")
    if len(text) > LONGEST:
        raise FormError(field, f"It has {len(text)} characters.", f"Use at most {LONGEST}.")
    found = _FORBIDDEN.search(text)
    if found:
        raise FormError(field, f"{found.group()!r} cannot be part of a name.", "Remove it.")


def pick(fields: Mapping[str, str], field: str, choices: Mapping[str, bool], usual: str) -> bool:
    """Return what a choice such as `n: p` means; FormError where the choice is not offered."""
    text = fields.get(field, usual)
    if text not in choices:
        offered = " or ".join(f"'{field}: {choice}'" for choice in choices)
        raise FormError(field, f"{text!r} is no choice.", f"Write {offered}.")
    return choices[text]


PLURAL = {"s": False, "p": True}
COUNTED = {"yes": True, "no": False}
