"""A trigger ready for matching: its index keys, and its machine built on first use."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from languages.spoken.shape import Spoken, SpokenKind
from plans.engine.automaton import EMPTY, Automaton, Draft, Piece, either
from plans.engine.intents import Intent, Slot
from plans.engine.patterns import Part, PhraseUse, Sequence, SlotUse, Word, parts_of

Units = tuple[str, ...]
Clause = frozenset[str]
_WINDOW = 3


@dataclass(frozen=True, slots=True)
class Lexicon:
    """What the triggers of one language refer to; `units` cuts text as sentences are cut.

    `clauses` remembers those of phrases and lists, which many triggers share.
    """

    spaced: bool
    units: Callable[[str], Units]
    phrases: Mapping[str, Sequence]
    values: Mapping[str, Mapping[Units, str]]
    spoken: Spoken
    clauses: dict[str, tuple[Clause, ...]] = field(default_factory=dict, repr=False, compare=False)


class Template:
    """One trigger of one intent; `clauses`: of each at least one unit stands in the sentence."""

    __slots__ = ("_lexicon", "_machine", "clauses", "intent", "sequence", "slots", "trigger")

    def __init__(self, intent: Intent, trigger: str, sequence: Sequence, lexicon: Lexicon) -> None:
        self.intent = intent
        self.trigger = trigger
        self.slots = {slot.name: slot for slot in intent.slots}
        self.clauses = _clauses(sequence, lexicon, self.slots)
        self.sequence = sequence
        self._lexicon = lexicon
        self._machine: Automaton | None = None

    @property
    def machine(self) -> Automaton:
        """Return the machine of this trigger, built the first time."""
        if self._machine is None:
            draft = Draft()
            whole = _build(self.sequence, draft, self._lexicon, self.slots)
            self._machine = Automaton(draft, whole)
        return self._machine


def _build(sequence: Sequence, draft: Draft, lexicon: Lexicon, slots: Mapping[str, Slot]) -> Piece:
    whole = EMPTY
    for part in sequence.parts:
        whole = draft.join(whole, _build_part(part, draft, lexicon, slots))
    return whole


def _build_part(part: Part, draft: Draft, lexicon: Lexicon, slots: Mapping[str, Slot]) -> Piece:
    if isinstance(part, Word):
        return draft.chain(lexicon.units(part.text))
    if isinstance(part, SlotUse):
        return _build_slot(slots[part.name], draft, lexicon)
    if isinstance(part, PhraseUse):
        return _build(lexicon.phrases[part.name], draft, lexicon, slots)
    # Later positions are preferred when a sentence is traced: the longest wording comes last.
    longest_last = sorted(part.options, key=_length)
    options = [_build(option, draft, lexicon, slots) for option in longest_last]
    return either([*options, EMPTY] if part.optional else options)


def _length(option: Sequence) -> int:
    return sum(len(part.text) for part in parts_of(option) if isinstance(part, Word))


def _build_slot(slot: Slot, draft: Draft, lexicon: Lexicon) -> Piece:
    if slot.unbounded:
        return draft.add_free(slot.name)
    if slot.list_key:
        return either([draft.chain(words, slot.name) for words in lexicon.values[slot.list_key]])
    return _build_spoken(slot, draft, lexicon.spoken.kinds[slot.kind])


def _build_spoken(slot: Slot, draft: Draft, kind: SpokenKind) -> Piece:
    """Return the piece that reads any words of a kind; whether they mean anything is seen later."""
    unlisted = [draft.add_any(frozenset(), slot.name)] if kind.unlisted else []
    words = [draft.add_digits(slot.name), draft.add_any(kind.words, slot.name), *unlisted]
    body = either(words)
    draft.join(body, body)
    if not kind.openers:
        return body
    openers = draft.add_any(kind.openers, slot.name)
    draft.join(openers, openers)
    return draft.join(either([EMPTY, openers]), body)


def _clauses(sequence: Sequence, lexicon: Lexicon, slots: Mapping[str, Slot]) -> tuple[Clause, ...]:
    """Return sets of index keys; every wording has at least one key of each set."""
    found: list[Clause] = []
    for part in sequence.parts:
        found += _part_clauses(part, lexicon, slots)
    return tuple(found)


def _part_clauses(part: Part, lexicon: Lexicon, slots: Mapping[str, Slot]) -> tuple[Clause, ...]:
    if isinstance(part, Word):
        return _word_clauses(lexicon.units(part.text), lexicon)
    if isinstance(part, PhraseUse):
        return _remembered(f"<{part.name}>", part, lexicon, slots)
    if isinstance(part, SlotUse):
        return _remembered(slots[part.name].list_key, part, lexicon, slots)
    if not part.optional:
        return _any_of([_clauses(option, lexicon, slots) for option in part.options])
    return ()


def _remembered(
    name: str, part: PhraseUse | SlotUse, lexicon: Lexicon, slots: Mapping[str, Slot]
) -> tuple[Clause, ...]:
    """Return the clauses of a phrase (which holds no slot) or of a list, found only once."""
    found = lexicon.clauses.get(name)
    if found is None:
        if isinstance(part, PhraseUse):
            found = _clauses(lexicon.phrases[part.name], lexicon, slots)
        else:
            found = _any_of(
                [_word_clauses(words, lexicon) for words in lexicon.values.get(name, {})]
            )
        lexicon.clauses[name] = found
    return found


def _word_clauses(units: Units, lexicon: Lexicon) -> tuple[Clause, ...]:
    return tuple(Clause((key,)) for key in index_keys(units, lexicon.spaced))


def _any_of(options: list[tuple[Clause, ...]]) -> tuple[Clause, ...]:
    """Return one clause with a key of each option; none where an option has no key."""
    if not options or not all(options):
        return ()
    return (Clause().union(*(_shortest(option) for option in options)),)


def _shortest(clauses: tuple[Clause, ...]) -> Clause:
    """Return the clause that says most: few keys, and long ones."""
    return min(clauses, key=lambda clause: (len(clause), -min(map(len, clause))))


def index_keys(units: Units, spaced: bool) -> tuple[str, ...]:
    """Return what a literal run is found by: its words, or its windows of characters."""
    if spaced or not units:
        return units
    run = "".join(units)
    size = min(_WINDOW, len(run))
    return tuple(run[start : start + size] for start in range(len(run) - size + 1))


def sentence_keys(units: Units, spaced: bool) -> frozenset[str]:
    """Return every index key a sentence contains."""
    if spaced:
        return frozenset(units)
    run = "".join(units)
    return frozenset(
        [
            run[start : start + size]
            for size in range(1, _WINDOW + 1)
            for start in range(len(run) - size + 1)
        ]
    )
