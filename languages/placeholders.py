"""Placeholders for what only the client knows: `$name` in "Hello, $name, how are you?"."""

import re

_NAME = re.compile(r"\$(?:name|desspk|prevspk)\b")
#: With the comma that goes with a name, and the さん behind it.
_WITH_COMMA = re.compile(r"(?:\s*,)?\s*\$(?:name|desspk|prevspk)(?:さん|様)?、?", re.ASCII)
_LEADING = re.compile(r"\A[\s,、]+")


def without_placeholders(text: str) -> str:
    """Return the sentence for a client that knows no name: "Hello, how are you?"."""
    if "$" not in text:
        return text
    bare = _LEADING.sub("", _WITH_COMMA.sub("", text))
    return bare[:1].upper() + bare[1:]


def with_speaker(text: str, profile: str) -> str:
    """Return the sentence with the speaker's own placeholder, which the client replaces."""
    return _NAME.sub(lambda _: f"${profile}", text)
