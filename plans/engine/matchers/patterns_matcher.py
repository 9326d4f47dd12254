"""Matching by trigger sentences: an index of rare words first, then one machine per trigger."""

from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from languages.language import Language
from plans.engine.matchers.matcher import Candidate
from plans.engine.reading import Edges, Reading, Vocabulary, read
from plans.engine.slots import SlotWords
from plans.engine.templates import Clause, Template, sentence_keys


@dataclass(frozen=True, slots=True)
class PatternMatcher:
    """All triggers of one language; `index` holds each under its rarest required words."""

    language: Language
    index: dict[str, tuple[Template, ...]]
    vocabulary: Vocabulary
    edges: Edges
    slot_words: SlotWords

    def find(self, sentence: str) -> tuple[Candidate, ...]:
        """Return every intent with a trigger the whole sentence fits, skip words aside."""
        reading = read(sentence, self.language, self.vocabulary)
        if reading is None or not reading.units:
            return ()
        templates = self._possible(reading)
        if not templates:
            return ()
        return tuple(
            candidate
            for start, end in self.edges.ranges(reading.units)
            for candidate in self._fitting(templates, reading, start, end)
        )

    def _possible(self, reading: Reading) -> list[Template]:
        keys = sentence_keys(reading.units, self.language.spaced)
        possible: dict[Template, None] = {}
        for key in keys & self.index.keys():
            possible.update(dict.fromkeys(self.index[key]))
        return [
            template
            for template in possible
            if not any(clause.isdisjoint(keys) for clause in template.clauses)
        ]

    def _fitting(
        self, templates: Iterable[Template], reading: Reading, start: int, end: int
    ) -> Iterator[Candidate]:
        units, others = reading.units[start:end], reading.others[start:end]
        for template in templates:
            path = template.machine.read(units, others)
            if path is not None:
                candidate = self._candidate(template, reading, start, path)
                if candidate is not None:
                    yield candidate

    def _candidate(
        self, template: Template, reading: Reading, offset: int, path: list[int]
    ) -> Candidate | None:
        names = [template.machine.slots[position] for position in path]
        parameters: dict[str, str] = {}
        literal = names.count("")
        values = free = free_units = 0
        for name, start, end in _stretches(names):
            slot = template.slots[name]
            value = self.slot_words.value(slot, reading, offset + start, offset + end)
            if value is None:
                return None
            parameters[name] = value
            values += not slot.free
            free += slot.free
            free_units += end - start if slot.free else 0
        score = (template.intent.priority, literal, values, -free, -free_units)
        return Candidate(template.intent, template.trigger, parameters, score)


def _stretches(names: list[str]) -> list[tuple[str, int, int]]:
    """Return each slot with the range of units it covers."""
    found: list[tuple[str, int, int]] = []
    for place, name in enumerate(names):
        if name and found and found[-1][0] == name and found[-1][2] == place:
            found[-1] = (name, found[-1][1], place + 1)
        elif name:
            found.append((name, place, place + 1))
    return found


def build_index(templates: Iterable[Template]) -> dict[str, tuple[Template, ...]]:
    """Return the templates under the keys of their rarest clause."""
    kept = tuple(templates)
    counts = Counter(key for template in kept for clause in template.clauses for key in clause)
    index: defaultdict[str, list[Template]] = defaultdict(list)
    for template in kept:
        for key in min(template.clauses, key=lambda clause: _weight(clause, counts)):
            index[key].append(template)
    return {key: tuple(listed) for key, listed in index.items()}


def _weight(clause: Clause, counts: Counter[str]) -> tuple[int, int]:
    return sum(counts[key] for key in clause), -min(map(len, clause))
