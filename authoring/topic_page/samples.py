"""Which topics to try a sentence with: the first, the one with the longest name, an odd one."""

from collections.abc import Mapping

Names = Mapping[int, Mapping[str, Mapping[str, str]]]

MOST_SAMPLES = 3


def samples(names: Names) -> tuple[int, ...]:
    """Return up to three topics (numbers); `names` are fields by language, in order of topics."""
    if not names:
        return ()
    longest = max(names, key=lambda number: _length(names[number]))
    oddest = max(names, key=lambda number: _oddness(names[number]))
    chosen = dict.fromkeys((next(iter(names)), longest, oddest))
    for number in names:
        if len(chosen) >= MOST_SAMPLES:
            break
        chosen.setdefault(number)
    return tuple(chosen)


def _length(name: Mapping[str, Mapping[str, str]]) -> int:
    return max((len(fields.get("name", "")) for fields in name.values()), default=0)


def _oddness(name: Mapping[str, Mapping[str, str]]) -> int:
    """Return how much of a name cannot be derived: plurals, and each form written by hand."""
    plural = sum(fields.get("n") == "p" for fields in name.values())
    return plural + sum(len(fields) - 1 for fields in name.values())
