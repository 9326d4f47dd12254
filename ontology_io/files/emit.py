"""Write YAML in one canonical form: the same knowledge gives the same bytes."""

import json
from collections.abc import Iterable, Mapping

_SPECIAL_START = frozenset("!&*-?:,[]{}#|>@`\"'%")
_SPECIAL_FLOW = frozenset(",[]{}:?")


def scalar(text: str) -> str:
    """Return a text as a block scalar, quoted only where YAML would misread it."""
    return text if _is_plain(text) else _quoted(text)


def flow_scalar(text: str) -> str:
    """Return a text as it stands inside `{…}` or `[…]`."""
    return text if _is_plain(text) and not _SPECIAL_FLOW & set(text) else _quoted(text)


def flow_list(texts: Iterable[str]) -> str:
    """Return `[Tea, Milk]`."""
    return f"[{', '.join(map(flow_scalar, texts))}]"


def flow_map(entries: Mapping[str, str]) -> str:
    """Return `{name: tea, n: p}` of values that are written as texts."""
    return raw_map({key: flow_scalar(value) for key, value in entries.items()})


def raw_map(entries: Mapping[str, str]) -> str:
    """Return `{key: value}` of values that are already written."""
    return f"{{{', '.join(f'{flow_scalar(key)}: {text}' for key, text in entries.items())}}}"


def _is_plain(text: str) -> bool:
    return (
        bool(text)
        and text[0] not in _SPECIAL_START
        and text == text.strip()
        and ": " not in text
        and " #" not in text
        and not text.endswith(":")
        and text.isprintable()
    )


def _quoted(text: str) -> str:
    return "".join(map(_printed, json.dumps(text, ensure_ascii=False)))


def _printed(letter: str) -> str:
    """Return a letter, escaped where it would not be seen or YAML would take it for a line end."""
    seen = letter.isprintable() or letter == "\u3000"  # the wide blank of Japanese
    return letter if seen else f"\\U{ord(letter):08x}"
