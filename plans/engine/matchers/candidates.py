"""From the way a trigger read a sentence to a candidate with its parameters."""

from collections.abc import Sequence

import msgspec

from plans.engine.alignment import EXTRA, Alignment
from plans.engine.matchers.matcher import Candidate
from plans.engine.matchers.patterns_hearing import Knowledge
from plans.engine.reading import Reading
from plans.engine.templates import Template


class Fit(msgspec.Struct, frozen=True):
    """A trigger that read the units of `reading` from `start` on.

    `names` holds for each unit its slot, "" for a literal word, None for a unit too much; `wrong`
    counts the literal words that were read as another.
    """

    template: Template
    reading: Reading
    start: int
    names: Sequence[str | None]
    wrong: int = 0

    @property
    def literal(self) -> int:
        """Return how many units are words of the trigger itself."""
        return self.names.count("") - self.wrong

    @property
    def listed(self) -> int:
        """Return how many units stand in slots that take only certain words."""
        slots = self.template.slots
        return sum(1 for name in self.names if name and not slots[name].free)

    @property
    def free(self) -> bool:
        """Say whether a slot holds free words."""
        slots = self.template.slots
        return any(slots[name].free for name in set(self.names) if name)


def fit_of(template: Template, reading: Reading, start: int, path: Sequence[int]) -> Fit:
    """Return the fit for the positions that read the units."""
    slots = template.machine.slots
    return Fit(template, reading, start, [slots[position] for position in path])


def aligned_fit(template: Template, reading: Reading, start: int, alignment: Alignment) -> Fit:
    """Return the fit of a reading with errors."""
    slots = template.machine.slots
    names = [None if place == EXTRA else slots[place] for place in alignment.path]
    return Fit(template, reading, start, names, len(alignment.wrong))


def candidate_of(fit: Fit, known: Knowledge, change: str = "") -> Candidate | None:
    """Return the candidate, or None where the words of a slot mean nothing there."""
    parameters: dict[str, str] = {}
    spans: dict[str, tuple[int, int]] = {}
    template, reading = fit.template, fit.reading
    values = free = free_units = 0
    for name, start, end in stretches(fit.names):
        slot = template.slots[name]
        first, last = fit.start + start, fit.start + end
        if slot.free:
            first, last = known.asides.trimmed(reading.units, first, last)
            free_units += last - first
        value = known.slot_words.value(slot, reading, first, last)
        if value is None or name in parameters:
            return None
        parameters[name] = value
        spans[name] = (reading.spans[first][0], reading.spans[last - 1][1])
        values += not slot.free
        free += slot.free
    score = (template.intent.priority, fit.literal, values, -free, -free_units)
    return Candidate(template.intent, template.trigger, parameters, score, spans, change)


def stretches(names: Sequence[str | None]) -> list[tuple[str, int, int]]:
    """Return each slot with the range of units it covers."""
    found: list[tuple[str, int, int]] = []
    for place, name in enumerate(names):
        if name and found and found[-1][0] == name and found[-1][2] == place:
            found[-1] = (name, found[-1][1], place + 1)
        elif name:
            found.append((name, place, place + 1))
    return found
