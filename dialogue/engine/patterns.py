"""Patterns: in which order a topic uses its sentence types, e.g. `q r w c [g] | c q r`."""

from collections.abc import Iterable

from dialogue.engine.sentence_types import PATTERN_LETTERS
from dialogue.engine.tree import Pattern

DEFAULT_PATTERN: Pattern = (("q", False), ("r", False), ("w", False), ("c", False))
MOST_TYPES = 15  # With the type a jump asks for, 16: what a dialogue state can hold.


class PatternError(ValueError):
    """A pattern that cannot be read: says which word of it."""


def parse_pattern(text: str) -> Pattern:
    """Return the types in order; `[g]` may be left out; `p|n` and `(p|n)` are written `r`."""
    steps = []
    for word in text.replace("(p|n)", "r").replace("p|n", "r").split():
        optional = word.startswith("[") and word.endswith("]")
        letter = word[1:-1] if optional else word
        if letter not in PATTERN_LETTERS:
            raise PatternError(
                f"{word!r} in the pattern {text!r} is no sentence type; "
                f"use {' '.join(sorted(PATTERN_LETTERS))}, in [ ] if it may be left out."
            )
        steps.append((letter, optional))
    if len(steps) > MOST_TYPES:
        raise PatternError(f"A pattern has {MOST_TYPES} types at most, this one {len(steps)}.")
    if not steps:
        raise PatternError("The pattern is empty; write for example q r w c [g].")
    return tuple(steps)


def parse_patterns(texts: Iterable[str]) -> tuple[Pattern, ...]:
    """Return each alternative parsed."""
    return tuple(parse_pattern(text) for text in texts)
