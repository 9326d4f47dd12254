"""Which triggers can fit a sentence, found by the words they cannot do without."""

from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Set
from dataclasses import dataclass
from heapq import nsmallest

from plans.engine.templates import Clause, Template

#: A window of characters is damaged by an error in any of its characters.
_WINDOW = 3
_FEWEST_CLAUSES = 3


@dataclass(frozen=True, slots=True)
class TriggerIndex:
    """Triggers under their rarest clause, and (without spaces) under two, one of them undamaged."""

    spaced: bool
    templates: tuple[Template, ...]
    rarest: dict[str, tuple[Template, ...]]
    two: dict[str, tuple[Template, ...]]

    def possible(self, keys: Set[str]) -> list[Template]:
        """Return the triggers whose every clause is in the sentence."""
        return [
            template
            for template in _listed(self.rarest, keys)
            if not any(clause.isdisjoint(keys) for clause in template.clauses)
        ]

    def nearly(self, keys: Set[str], most: int) -> list[Template]:
        """Return up to `most` triggers that miss as many clauses as one error can damage."""
        damage = 1 if self.spaced else _WINDOW
        found: list[tuple[int, int, Template]] = []
        # Of words, the most telling one must have been said.
        index = self.rarest if self.spaced else self.two
        for number, template in enumerate(_listed(index, keys)):
            missing = 0
            for clause in template.clauses:
                missing += clause.isdisjoint(keys)
                if missing > damage:
                    break
            else:
                found.append((missing - len(template.clauses), number, template))
        return [template for _, _, template in nsmallest(most, found)]


def build_index(templates: Iterable[Template], *, spaced: bool) -> TriggerIndex:
    """Return the index of the triggers of a language."""
    kept = tuple(templates)
    counts = Counter(key for template in kept for clause in template.clauses for key in clause)
    rarest: defaultdict[str, list[Template]] = defaultdict(list)
    two: defaultdict[str, list[Template]] = defaultdict(list)
    for template in kept:
        first, *others = _rarest(template.clauses, counts, spaced=spaced)
        for key in template.clauses[first]:
            rarest[key].append(template)
        if others and not spaced and len(template.clauses) >= _FEWEST_CLAUSES:
            for key in template.clauses[first] | template.clauses[others[0]]:
                two[key].append(template)
    return TriggerIndex(spaced, kept, _frozen(rarest), _frozen(two))


def _frozen(index: dict[str, list[Template]]) -> dict[str, tuple[Template, ...]]:
    return {key: tuple(listed) for key, listed in index.items()}


def _listed(index: dict[str, tuple[Template, ...]], keys: Set[str]) -> Iterator[Template]:
    found: dict[Template, None] = {}
    for key in keys & index.keys():
        found.update(dict.fromkeys(index[key]))
    return iter(found)


def _rarest(clauses: tuple[Clause, ...], counts: Counter[str], *, spaced: bool) -> list[int]:
    """Return the place of the rarest clause and of the rarest that an error in it leaves whole."""
    weights = [_weight(clause, counts) for clause in clauses]
    order = sorted(range(len(clauses)), key=weights.__getitem__)
    first = order[0]
    apart = [place for place in order[1:] if spaced or abs(place - first) >= _WINDOW]
    return [first, *(apart or order[1:])[:1]]


def _weight(clause: Clause, counts: Counter[str]) -> tuple[int, int]:
    return sum(counts[key] for key in clause), -min(map(len, clause))
