"""Kinds of sentence that a topic's pattern asks for and nothing provides."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from authoring.topic_page.shape import Shape
from dialogue.engine.patterns import DEFAULT_PATTERN, PatternError, parse_patterns
from dialogue.engine.saying import NEVER_WHEN_GENTLE
from dialogue.engine.sentence_types import REACTION
from dialogue.engine.tree import Pattern

REACTIONS = ("p", "n")


@dataclass(frozen=True, slots=True)
class Talker:
    """What decides which kinds a topic says: `said` are (kind, scope) of its own sentences."""

    pattern: str = ""
    stop: str = ""
    gentle: bool = False
    lenders: tuple[int, ...] = ()
    said: frozenset[tuple[str, str]] = frozenset()

    def kinds(self, hidden: str) -> frozenset[str]:
        """Return the kinds of its own sentences, without those of one scope."""
        return frozenset(kind for kind, scope in self.said if scope != hidden)


@dataclass(frozen=True, slots=True)
class _Given:
    kinds: frozenset[str] = frozenset()
    patterns: tuple[Pattern, ...] = (DEFAULT_PATTERN,)
    gentle: bool = False


def gaps(shape: Shape, talkers: Mapping[int, Talker]) -> dict[int, frozenset[str]]:
    """Return the missing kinds by topic; topics that lack none are left out.

    Inherits as the Dialogue Tree does: scopes, stopped kinds, lenders, gentle topics.
    """
    found: dict[int, frozenset[str]] = {}
    waiting = [(number, _Given()) for number in shape.branches]
    while waiting:
        number, given = waiting.pop()
        topic = talkers.get(number, Talker())
        above = given.kinds - frozenset(topic.stop)
        lent = (talkers.get(one, Talker()).kinds("self") for one in topic.lenders)
        here = above.union(topic.kinds("below"), *lent)
        patterns, gentle = _patterns(topic.pattern) or given.patterns, topic.gentle or given.gentle
        if missing := _asked(patterns, gentle=gentle) - here:
            found[number] = missing
        handed = _Given(above | topic.kinds("self"), patterns, gentle)
        waiting.extend((child, handed) for child in shape.children.get(number, ()))
    return found


def _patterns(text: str) -> tuple[Pattern, ...]:
    try:
        return parse_patterns(part for part in text.split(" | ") if part.strip())
    except PatternError:  # A check says so.
        return ()


def _asked(patterns: Iterable[Pattern], *, gentle: bool) -> frozenset[str]:
    asked = {letter for pattern in patterns for letter, optional in pattern if not optional}
    if REACTION in asked:
        asked = asked - {REACTION} | set(REACTIONS)
    if gentle:
        asked -= NEVER_WHEN_GENTLE
        if "q" not in asked:
            asked -= set(REACTIONS)
    return frozenset(asked)
