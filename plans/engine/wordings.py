"""All wordings of a phrase, for the lists of words the engine keeps (skip words, articles)."""

from collections.abc import Callable

from plans.engine.patterns import Choice, Part, Sequence, Word

Units = tuple[str, ...]


def wordings(sequence: Sequence, units: Callable[[str], Units]) -> frozenset[Units]:
    """Return every wording of a phrase without slots; its size was checked before."""
    found: frozenset[Units] = frozenset({()})
    for part in sequence.parts:
        right = _part_wordings(part, units)
        found = frozenset(before + after for before in found for after in right)
    return found


def _part_wordings(part: Part, units: Callable[[str], Units]) -> frozenset[Units]:
    if isinstance(part, Word):
        return frozenset({units(part.text)})
    if not isinstance(part, Choice):
        return frozenset()
    none: frozenset[Units] = frozenset({()}) if part.optional else frozenset()
    return none.union(*(wordings(option, units) for option in part.options))
