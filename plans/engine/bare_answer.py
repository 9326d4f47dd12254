"""The value of a slot in an answer without a trigger: "How long?" "In twenty minutes, please"."""

from collections.abc import Iterator, Mapping

from languages.spoken.shape import Spoken, SpokenKind, yes_or_no
from plans.engine.catalogue import Catalogue
from plans.engine.intents import Slot
from plans.engine.matchers.patterns_hearing import Knowledge
from plans.engine.matchers.patterns_matcher import PatternMatcher
from plans.engine.reading import Reading, read

Units = tuple[str, ...]

#: Fewer kana than these may be the end of any word: し is four, and the し of ました.
_SHORTEST_KANA = 3
#: An answer of skip words only is kept from this length on: the song "Now and Then".
_SHORTEST_TITLE = 3


def bare_value(catalogue: Catalogue, slot: Slot, sentence: str, language: str) -> str | None:
    """Return what a bare answer says for a slot, written as a trigger would have captured it.

    Of a value list: the canonical value found in the answer. Of a spoken kind: the value of the
    longest piece that has one. Free text and topics: the answer without skip words and words such
    as "it is". None where the answer says nothing for the slot, or two things at once.
    """
    for matcher in catalogue.matchers.get(language, ()):
        if isinstance(matcher, PatternMatcher):
            known = matcher.knowledge
            reading = read(sentence, matcher.language, known.vocabulary, known.sounds)
            return _value(slot, reading, known) if reading and reading.units else None
    return None


def _value(slot: Slot, reading: Reading, known: Knowledge) -> str | None:
    words = known.slot_words
    if slot.list_key:
        return _listed(reading.units, words.values[slot.list_key])
    if slot.kind == "yes_no":
        return yes_or_no(words.attitude(reading.sentence))
    start, end = _bare(reading.units, known, words.spoken)
    if start == end:
        return None
    if slot.kind in words.spoken.kinds:
        whole = words.value(slot, reading, start, end)
        return whole or _longest(reading.units, words.spoken.kinds[slot.kind], words.spoken)
    return words.value(slot, reading, start, end)


def _listed(units: Units, values: Mapping[Units, str]) -> str | None:
    """Return the value with the longest words in the answer; None where two are as long."""
    for length in sorted({len(words) for words in values}, reverse=True):
        pieces = _pieces(units, length)
        found = {values[piece] for piece in pieces if piece in values}
        if found:
            return found.pop() if len(found) == 1 else None
    return None


def _longest(units: Units, kind: SpokenKind, spoken: Spoken) -> str | None:
    """Return the value of the longest piece that has one; None where two are as long."""
    readable = {unit for unit in set(units) if kind.may_read(unit)}
    for length in range(min(spoken.most_units, len(units)), 0, -1):
        pieces = {piece for piece in _pieces(units, length) if readable.issuperset(piece)}
        found = {kind.parse(piece) for piece in pieces if not _is_scrap(piece)} - {None}
        if found:
            return found.pop() if len(found) == 1 else None
    return None


def _pieces(units: Units, length: int) -> Iterator[Units]:
    return (units[place : place + length] for place in range(len(units) - length + 1))


def _is_scrap(piece: Units) -> bool:
    return len(piece) < _SHORTEST_KANA and all("\u3040" < unit < "\u30ff" for unit in piece)


def _bare(units: Units, known: Knowledge, spoken: Spoken) -> tuple[int, int]:
    """Return where the answer itself begins and ends."""
    start, end = 0, len(units)
    while start < end:
        kept = units[start:end]
        first = max(known.edges.starts(kept)) or _at_start(kept, spoken)
        last = min(known.edges.ends(kept))
        last = last if last < len(kept) else len(kept) - _at_end(kept, spoken)
        if first >= last:
            # Nothing would be left: it is a title, or no answer.
            return (start, end) if len(units) >= _SHORTEST_TITLE else (start, start)
        if (first, last) == (0, len(kept)):
            break
        start, end = start + first, start + last
    return start, end


def _at_start(units: Units, spoken: Spoken) -> int:
    return max((len(lead) for lead in spoken.leads if units[: len(lead)] == lead), default=0)


def _at_end(units: Units, spoken: Spoken) -> int:
    return max((len(tail) for tail in spoken.tails if units[-len(tail) :] == tail), default=0)
