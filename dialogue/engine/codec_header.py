"""The first part of a state's text: every field that needs no look at the columns."""

import re

from dialogue.engine.codec_wire import (
    MAX_COUNT,
    Reader,
    number,
    numbers,
    shaped,
    text,
)
from dialogue.engine.state import (
    MAX_AVOIDED,
    MAX_FRAME,
    MAX_PARAMETERS,
    MAX_SLOT_NAME,
    MAX_TOPIC,
    MAX_VALUE,
    RING,
    DialogueState,
    Pending,
)

TYPE_LETTERS = "qpnrwcgte"
MAX_ORDERING = 16

_LANGUAGE = re.compile(r"[A-Za-z][A-Za-z0-9-]{1,7}", re.ASCII)
_CULTURE = re.compile(r"[A-Za-z]{2,8}", re.ASCII)
_TYPES = re.compile(rf"[{TYPE_LETTERS}]{{0,{MAX_ORDERING}}}[{TYPE_LETTERS}0]", re.ASCII)
_TO_DIGITS = str.maketrans(TYPE_LETTERS, "123456789")
_TO_LETTERS = str.maketrans("123456789", TYPE_LETTERS)

_ENDED, _SEED, _COUNTERS, _AVOIDED, _OFFER, _PENDING = 1, 2, 4, 8, 16, 32


def header(state: DialogueState) -> bytes:
    """Return the fields in order, the rare ones only where they say something.

    Raises ValueError where a field is out of its range: what is written can be read.
    """
    pieces = [
        bytes((_flags(state),)),
        _name(state.language, _LANGUAGE),
        _name(state.culture, _CULTURE),
        number(state.turn),
        number(state.topic, MAX_TOPIC),
        _types(state),
        numbers(state.frames, RING, MAX_FRAME),
    ]
    if state.seed:
        pieces.append(number(state.seed))
    counters = (state.siblings, state.noes, state.questions, state.misses)
    if any(counters):
        pieces.extend(map(number, counters))
    if state.avoided:
        pieces.append(number(len(state.avoided), MAX_AVOIDED))
        pieces.extend(number(topic, MAX_TOPIC) + number(until) for topic, until in state.avoided)
    if state.offer:
        pieces.append(number(state.offer, MAX_FRAME))
    if state.pending:
        pieces.append(_pending(state.pending))
    return b"".join(pieces)


def read_header(reader: Reader) -> DialogueState:
    """Return a state without what the body says, every field in its range, or raise StateError."""
    flags = reader.number(2 * _PENDING - 1)
    language = shaped(reader.text(8), _LANGUAGE)
    culture = shaped(reader.text(8), _CULTURE)
    turn, topic = reader.number(), reader.number(MAX_TOPIC)
    last_type, ordering = _read_types(reader)
    frames = reader.numbers(RING, MAX_FRAME)
    seed = reader.number() if flags & _SEED else 0
    siblings, noes, questions, misses = _read_counters(reader, flags)
    return DialogueState(
        language,
        culture,
        seed=seed,
        turn=turn,
        topic=topic,
        last_type=last_type,
        ordering=ordering,
        frames=frames,
        siblings=siblings,
        noes=noes,
        questions=questions,
        misses=misses,
        ended=bool(flags & _ENDED),
        avoided=_read_avoided(reader) if flags & _AVOIDED else (),
        offer=reader.number(MAX_FRAME) if flags & _OFFER else 0,
        pending=_read_pending(reader) if flags & _PENDING else None,
    )


def _flags(state: DialogueState) -> int:
    return (
        _ENDED * state.ended
        | _SEED * bool(state.seed)
        | _COUNTERS * bool(state.siblings or state.noes or state.questions or state.misses)
        | _AVOIDED * bool(state.avoided)
        | _OFFER * bool(state.offer)
        | _PENDING * bool(state.pending)
    )


def _name(value: str, shape: re.Pattern[str]) -> bytes:
    if not shape.fullmatch(value):
        raise ValueError(f"{value!r} is no language or culture; write 2 to 8 ASCII letters.")
    return text(value, 8)


def _types(state: DialogueState) -> bytes:
    # The letters are digits of one number, the last type at its end: "wc" after "q" is 561.
    letters = state.ordering + (state.last_type or "0")
    if len(state.last_type) > 1 or not _TYPES.fullmatch(letters):
        raise ValueError(f"{letters!r} has other letters than the sentence types {TYPE_LETTERS}.")
    return number(int(letters.translate(_TO_DIGITS)), 10 ** (MAX_ORDERING + 1))


def _read_types(reader: Reader) -> tuple[str, str]:
    letters = str(reader.number(10 ** (MAX_ORDERING + 1))).translate(_TO_LETTERS)
    shaped(letters, _TYPES)
    return letters[-1].rstrip("0"), letters[:-1]


def _read_counters(reader: Reader, flags: int) -> tuple[int, int, int, int]:
    if not flags & _COUNTERS:
        return 0, 0, 0, 0
    return reader.number(), reader.number(), reader.number(), reader.number()


def _read_avoided(reader: Reader) -> tuple[tuple[int, int], ...]:
    return tuple(
        (reader.number(MAX_TOPIC), reader.number()) for _ in range(reader.number(MAX_AVOIDED))
    )


def _pending(pending: Pending) -> bytes:
    pieces = [
        number(pending.intent, MAX_COUNT),
        text(pending.slot, MAX_SLOT_NAME),
        number(len(pending.parameters), MAX_PARAMETERS),
    ]
    for name, value in pending.parameters:
        pieces.append(text(name, MAX_SLOT_NAME))
        pieces.append(text(value, MAX_VALUE))
    return b"".join(pieces)


def _read_pending(reader: Reader) -> Pending:
    intent, slot = reader.number(MAX_COUNT), reader.text(MAX_SLOT_NAME)
    parameters = [
        (reader.text(MAX_SLOT_NAME), reader.text(MAX_VALUE))
        for _ in range(reader.number(MAX_PARAMETERS))
    ]
    return Pending(intent, slot, tuple(parameters))
