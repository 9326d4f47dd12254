"""Which triggers can fit a sentence, found by the words they cannot do without."""

from collections import Counter
from collections.abc import Callable, Iterable, Set
from functools import cache, partial
from heapq import nsmallest
from itertools import chain
from typing import NamedTuple

from plans.engine.templates import Clause, Template

_NONE: Clause = frozenset()
#: The key that every sentence has.
_ALWAYS: Clause = frozenset(("",))
_LARGEST_SECOND = 12


class _Entry(NamedTuple):
    """A trigger with what it needs besides the clause it stands under, the rarest first.

    `needs` are the keys of clauses with a single key; `number` is its place in the library.
    """

    needs: Clause
    others: tuple[Clause, ...]
    number: int


def _clauses_of(template: Template) -> tuple[Clause, ...]:
    return template.clauses


class TriggerIndex:
    """Triggers under the keys of their rarest clause, there under those of the next rarest.

    One without clauses is never found.
    """

    __slots__ = ("_entries", "_every", "templates")

    def __init__(
        self,
        templates: Iterable[Template],
        clauses_of: Callable[[Template], tuple[Clause, ...]] = _clauses_of,
    ) -> None:
        self.templates = tuple(templates)
        every = [clauses_of(template) for template in self.templates]
        counts = Counter(key for clauses in every for clause in clauses for key in clause)
        weight = cache(partial(_weight, counts))
        entries: dict[str, dict[str, list[_Entry]]] = {}
        for number, clauses in enumerate(every):
            if clauses:
                rarest, second, entry = _entry(clauses, weight, number)
                for key in rarest:
                    inner = entries.setdefault(key, {})
                    for other in second:
                        inner.setdefault(other, []).append(entry)
        self._entries = entries
        #: The same without the second keys: each trigger once under each key of its rarest clause.
        self._every = {
            key: tuple(
                {entry.number: entry for entry in chain.from_iterable(inner.values())}.values()
            )
            for key, inner in entries.items()
        }

    def possible(self, keys: Set[str]) -> list[Template]:
        """Return the triggers whose every clause is in the sentence, as the library has them."""
        found: list[int] = []
        entries = self._entries
        keys = keys | _ALWAYS
        for key in keys & entries.keys():
            inner = entries[key]
            for second in keys & inner.keys():
                for needs, others, number in inner[second]:
                    if needs <= keys:
                        for clause in others:
                            if clause.isdisjoint(keys):
                                break
                        else:
                            found.append(number)
        templates = self.templates
        return [templates[number] for number in sorted(set(found))]

    def nearly(self, keys: Set[str], most: int) -> list[Template]:
        """Return up to `most` triggers of words that miss one clause, not the most telling."""
        found: dict[int, tuple[int, int]] = {}
        for key in keys & self._every.keys():
            for needs, others, number in self._every[key]:
                missing = len(needs - keys)
                if missing > 1:
                    continue
                for clause in others:
                    if clause.isdisjoint(keys):
                        missing += 1
                        if missing > 1:
                            break
                else:
                    found[number] = (missing - len(self.templates[number].clauses), number)
        near = nsmallest(most, found, key=found.__getitem__)
        return [self.templates[number] for number in near]


def _entry(
    clauses: tuple[Clause, ...], weight: Callable[[Clause], tuple[int, int]], number: int
) -> tuple[Clause, Clause, _Entry]:
    """Return the rarest clause, the next (or what is always there), and what is needed besides."""
    if len(clauses) == 1:
        return clauses[0], _ALWAYS, _Entry(_NONE, (), number)
    rarest, *others = sorted(clauses, key=weight)
    needs = frozenset([key for clause in others if len(clause) == 1 for key in clause])
    second = others[0] if len(others[0]) <= _LARGEST_SECOND else _ALWAYS
    return rarest, second, _Entry(needs, tuple([each for each in others if len(each) > 1]), number)


def _weight(counts: Counter[str], clause: Clause) -> tuple[int, int]:
    return sum([counts[key] for key in clause]), -min(map(len, clause))
