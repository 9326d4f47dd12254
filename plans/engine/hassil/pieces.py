"""Finds the words of a template whose brackets continue words: `light[s]` is `(light|lights)`.

Only what may touch its neighbour without a space between is written out; the rest keeps its form.
"""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from itertools import permutations, product

from plans.engine.hassil.grammar import (
    Group,
    Item,
    Items,
    ListUse,
    Permutation,
    RuleUse,
    Space,
    TemplateError,
    Text,
)
from plans.engine.patterns import Choice, Part, PhraseUse, Sequence, SlotUse, Word

MOST_WRITTEN_OUT = 3_000
MOST_PERMUTED = 5

SlotName = Callable[[ListUse], str]


@dataclass(frozen=True, slots=True)
class _Edges:
    """Whether letters may stand at the edges, and whether nothing at all may stand here."""

    begins: bool
    ends: bool
    empty: bool


_APART = _Edges(begins=False, ends=False, empty=False)


@dataclass(frozen=True, slots=True)
class Words:
    """How a language's templates become words.

    `phrases` are groups that may be written as a phrase of the library. In a language without
    spaces nothing needs to be written out: letters are its units.
    """

    spaced: bool
    slot_name: SlotName
    phrases: dict[Group, str]

    def sequence(self, items: Items) -> Sequence:
        """Return the words of a template, not yet simplified."""
        parts: list[Part] = []
        for cluster in self._clusters(items):
            parts += self._parts(cluster)
        return Sequence(tuple(parts))

    def _clusters(self, items: Items) -> Iterator[Items]:
        """Yield neighbours that may make one word together."""
        start = 0
        while start < len(items):
            end = start + 1
            place = start
            while place < end:
                end = max(end, self._reach(items, place))
                place += 1
            yield items[start:end]
            start = end

    def _reach(self, items: Items, place: int) -> int:
        """Return the end of what may touch the item at `place` on its right."""
        end = place + 1
        if not self.spaced or not _edges(items[place]).ends:
            return end
        for after in range(place + 1, len(items)):
            edges = _edges(items[after])
            if edges.begins:
                end = after + 1
            if not edges.empty:
                break
        return end

    def _parts(self, cluster: Items) -> Iterable[Part]:
        if len(cluster) == 1:
            return self._one(cluster[0])
        options = dict.fromkeys(self._written(form) for form in written_out(cluster))
        return (Choice(tuple(options), optional=False),)

    def _one(self, item: Item) -> Iterable[Part]:
        if isinstance(item, Text):
            return (Word(item.text),)
        if isinstance(item, ListUse):
            return (SlotUse(self.slot_name(item)),)
        if isinstance(item, Group):
            if item in self.phrases:
                return (PhraseUse(self.phrases[item]),)
            return (Choice(tuple(map(self.sequence, item.options)), optional=False),)
        return ()

    def _written(self, form: Items) -> Sequence:
        parts: list[Part] = []
        letters = ""
        for item in (*form, Space()):
            if isinstance(item, Text):
                letters += item.text
                continue
            if letters:
                parts.append(Word(letters))
            letters = ""
            if isinstance(item, ListUse):
                parts.append(SlotUse(self.slot_name(item)))
        return Sequence(tuple(parts))


def _edges(item: Item) -> _Edges:
    if isinstance(item, Text):
        return _Edges(item.text[0].isalnum(), item.text[-1].isalnum(), empty=False)
    if isinstance(item, Group):
        options = [_items_edges(option) for option in item.options]
        return _Edges(
            begins=any(option.begins for option in options),
            ends=any(option.ends for option in options),
            empty=any(option.empty for option in options),
        )
    return _APART


def _items_edges(items: Items) -> _Edges:
    begins = ends = False
    empty = True
    for item in items:
        edges = _edges(item)
        begins = begins or (empty and edges.begins)
        ends = edges.ends or (edges.empty and ends)
        empty = empty and edges.empty
    return _Edges(begins, ends, empty)


def written_out(items: Items) -> list[Items]:
    """Return every form of some items, without groups. Raises TemplateError beyond the limit."""
    forms: list[Items] = [()]
    for item in items:
        ways = _ways(item)
        if len(forms) * len(ways) > MOST_WRITTEN_OUT:
            raise TemplateError(f"A word with more than {MOST_WRITTEN_OUT} forms", 0)
        forms = [before + way for before, way in product(forms, ways)]
    return forms


def _ways(item: Item) -> list[Items]:
    if isinstance(item, Group):
        return list(dict.fromkeys(form for option in item.options for form in written_out(option)))
    return [(item,)]


def without_rules(items: Items, rules: Callable[[RuleUse], Items]) -> Items:
    """Return a template with rules put in as groups and permutations as choices."""
    return tuple(_plain(item, rules) for item in items)


def _plain(item: Item, rules: Callable[[RuleUse], Items]) -> Item:
    if isinstance(item, RuleUse):
        return Group((rules(item),), rule=item.name)
    if isinstance(item, Group):
        return Group(tuple(without_rules(option, rules) for option in item.options))
    if isinstance(item, Permutation):
        if len(item.options) > MOST_PERMUTED:
            raise TemplateError(f"More than {MOST_PERMUTED} parts in any order", 0)
        options = [without_rules(option, rules) for option in item.options]
        return Group(tuple(_in_order(order) for order in permutations(options)))
    return item


def _in_order(options: tuple[Items, ...]) -> Items:
    return tuple(item for option in options for item in (Space(), *option, Space()))
