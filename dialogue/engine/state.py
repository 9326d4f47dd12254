"""What an agent remembers of one conversation: an immutable value that travels with the client."""

from collections.abc import Collection
from itertools import compress

import msgspec
from msgspec.structs import replace

RING = 32
TOPIC_RING = 16
MAX_AVOIDED = 8
MAX_SLOT = 127
MAX_TOPIC = 131_071
MAX_FRAME = 2**31 - 1
MAX_PARAMETERS = 8
MAX_SLOT_NAME = 40
MAX_VALUE = 300

# A level is one byte: 0 = as the culture says, 1..11 = 0.0, 0.1 … 1.0.
_LIKELINESS: tuple[float | None, ...] = (None, *(tenth / 10 for tenth in range(11)))


class Pending(msgspec.Struct, frozen=True):
    """A parameter the agent asked for: "Which song?" waits for `title` of the intent playsong."""

    intent: int
    slot: str
    parameters: tuple[tuple[str, str], ...] = ()

    def cut_to_fit(self) -> "Pending":
        """Return a copy the codec can write: 8 parameters, values of 300 characters, no surrogates.

        What people say goes through here before it becomes a state.
        """
        parameters = (
            (_text(name, MAX_SLOT_NAME), _text(value, MAX_VALUE))
            for name, value in self.parameters[:MAX_PARAMETERS]
        )
        return replace(self, slot=_text(self.slot, MAX_SLOT_NAME), parameters=tuple(parameters))


class DialogueState(msgspec.Struct, frozen=True):
    """One person's conversation so far; every `with_…` returns a changed copy.

    The columns hold one byte per topic number: `levels` the likeliness the person showed,
    `used[k]` the sentences said (bit b of `used[k][topic]` is the frame slot 8k + b).
    Shorter columns mean zeros; the methods never leave zeros at a column's end.

    Example: `DialogueState("en", "EN").with_used(7, 2).used_slots(7) == 0b100`.
    """

    language: str
    culture: str
    seed: int = 0  # 0 = fresh chance each time; 1..2**32-1 = reproducible
    turn: int = 0
    topic: int = 0  # 0 = none yet
    last_type: str = ""  # letter of the last sentence type
    ordering: str = ""  # types still to come in this topic, such as "wc"
    frames: tuple[int, ...] = ()  # the last 32 frame numbers, newest last
    topics: tuple[int, ...] = ()  # the last 16 topics started, newest last
    siblings: int = 0  # siblings in a row
    noes: int = 0  # refusals in a row
    questions: int = 0  # turns in a row that ended with a question
    misses: int = 0  # turns in a row that we did not understand
    ended: bool = False  # the person said stop
    avoided: tuple[tuple[int, int], ...] = ()  # (topic, last turn of its absence), at most 8
    offer: int = 0  # frame number of the proposal just made; 0 = none
    pending: Pending | None = None
    levels: bytes = b""
    used: tuple[bytes, ...] = ()

    def likeliness(self, topic: int) -> float | None:
        """Return how much the person likes the topic, or None where the culture decides."""
        return _LIKELINESS[self.levels[topic]] if topic < len(self.levels) else None

    def with_likeliness(self, topic: int, value: float | None) -> "DialogueState":
        """Return a copy with the value rounded to the nearest tenth in 0..1; None forgets it."""
        _check_topic(topic)
        level = 0 if value is None else 1 + round(10 * min(max(value, 0.0), 1.0))
        return replace(self, levels=_column_with(self.levels, topic, level))

    def has_used(self, topic: int, slot: int) -> bool:
        """Say whether the sentence in this frame slot was said about the topic."""
        return bool(self.used_slots(topic) >> slot & 1)

    def used_slots(self, topic: int) -> int:
        """Return the frame slots said about the topic as bits: 0b101 = slots 0 and 2."""
        mask = 0
        for column in reversed(self.used):
            mask = mask << 8 | (column[topic] if topic < len(column) else 0)
        return mask

    def with_used(self, topic: int, slot: int) -> "DialogueState":
        """Return a copy in which the sentence of this slot (0..127) was said."""
        _check_topic(topic)
        if not 0 <= slot <= MAX_SLOT:
            raise ValueError(f"Slot {slot} is outside 0..{MAX_SLOT}.")
        return self._with_mask(topic, self.used_slots(topic) | 1 << slot)

    def without_used(self, topic: int, slots_mask: int) -> "DialogueState":
        """Return a copy in which the sentences of these slots may be said again."""
        return self._with_mask(topic, self.used_slots(topic) & ~slots_mask)

    def with_frame(self, frame: int) -> "DialogueState":
        """Return a copy that remembers the frame as the newest of the last 32."""
        return replace(self, frames=(*self.frames, frame)[-RING:])

    def with_topic_started(self, topic: int) -> "DialogueState":
        """Return a copy whose topic is this one, the newest of the last 16 started."""
        _check_topic(topic)
        return replace(self, topic=topic, topics=(*self.topics, topic)[-TOPIC_RING:])

    def with_avoided(self, topic: int, until: int) -> "DialogueState":
        """Return a copy that avoids the topic up to and with turn `until`; the oldest of 9 goes."""
        _check_topic(topic)
        others = (pair for pair in self.avoided if pair[0] != topic and pair[1] >= self.turn)
        return replace(self, avoided=(*others, (topic, until))[-MAX_AVOIDED:])

    def avoids(self, topic_or_ancestors: Collection[int]) -> bool:
        """Say whether one of these topics stays out in this turn."""
        return any(
            self.turn <= until and topic in topic_or_ancestors for topic, until in self.avoided
        )

    def covered_topics(self) -> tuple[int, ...]:
        """Return the topics with a likeliness of their own or a sentence said, ascending."""
        cover = union((self.levels, *self.used))
        return tuple(compress(range(len(cover)), cover))

    def forgotten(self) -> "DialogueState":
        """Return a copy without anything the person showed to like or dislike."""
        return replace(self, levels=b"")

    def _with_mask(self, topic: int, mask: int) -> "DialogueState":
        columns = list(self.used)
        for number in range(max(len(columns), (mask.bit_length() + 7) // 8)):
            if number == len(columns):
                columns.append(b"")
            columns[number] = _column_with(columns[number], topic, mask >> 8 * number & 0xFF)
        while columns and not columns[-1]:
            columns.pop()
        return replace(self, used=tuple(columns))


def union(columns: Collection[bytes]) -> bytes:
    """Return a column that is not zero wherever one of these is not zero."""
    merged = 0
    for column in columns:
        merged |= int.from_bytes(column, "little")
    return merged.to_bytes(max(map(len, columns), default=0), "little")


def _column_with(column: bytes, topic: int, value: int) -> bytes:
    if not value:
        return (column[:topic] + b"\0" + column[topic + 1 :]).rstrip(b"\0")
    return column[:topic].ljust(topic, b"\0") + bytes((value,)) + column[topic + 1 :]


def _text(text: str, longest: int) -> str:
    return text[:longest].encode("utf-8", "replace").decode("utf-8")


def _check_topic(topic: int) -> None:
    if not 0 <= topic <= MAX_TOPIC:
        raise ValueError(f"Topic number {topic} is outside 0..{MAX_TOPIC}.")
