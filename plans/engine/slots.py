"""What the words standing in a slot mean: canonical values, numbers, trimmed topics."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from languages.language import Attitude
from languages.spoken.shape import Spoken, yes_or_no
from plans.engine.intents import Slot
from plans.engine.reading import Reading

Units = tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Limits:
    """The most units a topic and a free text may have."""

    topic: int
    text: int


SPACED_LIMITS = Limits(topic=5, text=20)
UNSPACED_LIMITS = Limits(topic=16, text=50)


@dataclass(frozen=True, slots=True)
class SlotWords:
    """The words of one language that slots need; all in units.

    `spoken` reads numbers, lengths, times and days; `attitude` answers to yes/no questions.

    `topic_edges` are cut off a topic ("the", "very much"), `not_a_topic` is refused as a whole
    topic ("it"), `not_in_topic` is refused anywhere in it ("because").
    """

    limits: Limits
    values: Mapping[str, Mapping[Units, str]]
    spoken: Spoken
    attitude: Callable[[str], Attitude]
    topic_edges: frozenset[Units]
    not_a_topic: frozenset[Units]
    not_in_topic: frozenset[Units]

    @property
    def edge_lengths(self) -> list[int]:
        """Return the lengths of what is cut off a topic, longest first."""
        return sorted(set(map(len, self.topic_edges)), reverse=True)

    @property
    def clause_lengths(self) -> set[int]:
        """Return the lengths of what is refused in a topic."""
        return set(map(len, self.not_in_topic))

    def value(self, slot: Slot, reading: Reading, start: int, end: int) -> str | None:
        """Return what the units from `start` to `end` say, or None where they do not fit."""
        if slot.list_key:
            return self.values[slot.list_key].get(reading.units[start:end])
        if slot.kind in self.spoken.kinds or slot.kind == "yes_no":
            return self._spoken(slot.kind, reading, start, end)
        if slot.kind == "topic":
            return self._topic(reading, start, end)
        return reading.original(start, end) if end - start <= self.limits.text else None

    def _spoken(self, kind: str, reading: Reading, start: int, end: int) -> str | None:
        if end - start > self.spoken.most_units:
            return None
        if kind == "yes_no":
            return yes_or_no(self.attitude(reading.original(start, end)))
        return self.spoken.kinds[kind].parse(reading.units[start:end])

    def _topic(self, reading: Reading, start: int, end: int) -> str | None:
        start, end = self._trimmed(reading.units, start, end)
        units = reading.units[start:end]
        if not 0 < len(units) <= self.limits.topic or units in self.not_a_topic:
            return None
        if self._clause(units):
            return None
        return reading.original(start, end)

    def _trimmed(self, units: Units, start: int, end: int) -> tuple[int, int]:
        """Cut articles and the like off both edges, longest first."""
        cut = True
        while cut and start < end:
            cut = False
            for length in self.edge_lengths:
                if units[start : min(start + length, end)] in self.topic_edges:
                    start, cut = min(start + length, end), True
                elif units[max(end - length, start) : end] in self.topic_edges:
                    end, cut = max(end - length, start), True
        return start, end

    def _clause(self, units: Units) -> bool:
        return any(
            units[place : place + length] in self.not_in_topic
            for place in range(len(units))
            for length in self.clause_lengths
        )
