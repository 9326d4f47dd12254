"""Which triggers are near a sentence without spaces that fits none of them."""

import re
from collections import defaultdict
from collections.abc import Callable, Iterable, Set
from functools import cache, partial
from heapq import nlargest
from itertools import islice

from plans.engine.matchers.patterns_index import TriggerIndex
from plans.engine.templates import Clause, Template

#: Characters that are often typed for each other: small and large kana, the mark of length.
SMALL = dict(
    zip("ゃゅょっぁぃぅぇぉャュョッァィゥェォ", "やゆよつあいうえおヤユヨツアイウエオ", strict=True)
)
LENGTH_MARK = "ー"
_PLAIN = str.maketrans({**SMALL, LENGTH_MARK: None})
_DOUBLED = re.compile(r"(.)\1+", re.DOTALL)
#: A pair of characters that more triggers share says nothing ("して").
_MOST_SHARING = 150
_MOST_DAMAGED = 3
#: So many more are looked at than are returned.
_FACTOR = 3


def plain(text: str) -> str:
    """Return text as it sounds in haste: no long or doubled characters, no small kana."""
    return _DOUBLED.sub(r"\1", text.translate(_PLAIN))


class NearTriggers:
    """The triggers of a language without spaces, found in spite of an error.

    `runs_of` gives the literal runs of a trigger, wherever they stand in it.
    """

    __slots__ = ("_alike", "_index", "_pairs", "_runs_of")

    def __init__(self, index: TriggerIndex, runs_of: Callable[[Template], Iterable[str]]) -> None:
        self._index = index
        self._runs_of = runs_of
        self._pairs: dict[str, list[int]] | None = None
        self._alike: TriggerIndex | None = None

    def alike(self, keys: Set[str], most: int) -> list[Template]:
        """Return up to `most` triggers whose every clause is in the sentence as `plain` has it.

        `keys` are those of the plain sentence.
        """
        return self._in_haste().possible(keys)[:most]

    def prepare(self) -> None:
        """Make both tables now instead of at first use."""
        self._in_haste()
        self._shared()

    def _in_haste(self) -> TriggerIndex:
        """Return the index of the triggers as `plain` has them; made at first use."""
        if self._alike is None:
            heard = cache(plain)
            self._alike = TriggerIndex(self._index.templates, partial(_plain_clauses, heard))
        return self._alike

    def sharing(self, run: str, keys: Set[str], most: int) -> list[Template]:
        """Return up to `most` triggers that share most with a sentence, rare pairs before common.

        Triggers that lack more clauses than one error can damage are left out.
        """
        index, templates = self._shared(), self._index.templates
        scores: defaultdict[int, float] = defaultdict(float)
        for pair in {run[place : place + 2] for place in range(len(run) - 1)} & index.keys():
            numbers = index[pair]
            worth = len(numbers) ** -0.5
            for number in numbers:
                scores[number] += worth
        ranked = nlargest(_FACTOR * most, scores, key=scores.__getitem__)
        near = (templates[number] for number in ranked if _damaged(templates[number], keys))
        return list(islice(near, most))

    def _shared(self) -> dict[str, list[int]]:
        """Return the triggers, by number, that have a pair of characters; made at first use."""
        if self._pairs is None:
            found: defaultdict[str, list[int]] = defaultdict(list)
            for number, template in enumerate(self._index.templates):
                runs = self._runs_of(template)
                for pair in {run[at : at + 2] for run in runs for at in range(len(run) - 1)}:
                    found[pair].append(number)
            self._pairs = {
                pair: numbers for pair, numbers in found.items() if len(numbers) <= _MOST_SHARING
            }
        return self._pairs


def _plain_clauses(heard: Callable[[str], str], template: Template) -> tuple[Clause, ...]:
    """Return the clauses as `plain` has their keys, without those of which nothing is left."""
    found = [frozenset([heard(key) for key in clause]) for clause in template.clauses]
    return tuple([clause for clause in found if "" not in clause])


def _damaged(template: Template, keys: Set[str]) -> bool:
    """Say whether one error is enough for the clauses a sentence lacks."""
    missing = 0
    for clause in template.clauses:
        if clause.isdisjoint(keys):
            missing += 1
            if missing > _MOST_DAMAGED:
                return False
    return True
