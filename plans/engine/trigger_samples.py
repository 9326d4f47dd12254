"""Sentences that a trigger stands for, with plausible words in its slots."""

from collections import defaultdict
from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache, partial
from itertools import product
from random import Random

from languages.known import LANGUAGES
from languages.spoken.known import SPOKEN
from plans.engine.intents import Intent, Library, Slot
from plans.engine.patterns import (
    Choice,
    Part,
    PhraseUse,
    Sequence,
    SlotUse,
    Word,
    parse_options,
    parse_pattern,
    parts_of,
    sample,
)
from plans.engine.sayings import is_saying

Phrases = Mapping[str, Sequence]

#: Stands in a free slot for which no stored test says anything.
NEUTRAL = "Volare"
_TRIES = 3

parsed = lru_cache(maxsize=20_000)(parse_pattern)


@dataclass(frozen=True, slots=True)
class Sample:
    """One sentence of a trigger, and what was put into its slots."""

    sentence: str
    slots: tuple[tuple[str, str], ...]


def phrases_of(library: Library, language: str) -> dict[str, Sequence]:
    """Return the phrases of a library that compiles, in one language."""
    return {
        phrase.key: parse_options(phrase.texts[language])
        for phrase in library.phrases
        if phrase.texts.get(language) and not is_saying(phrase.key)
    }


def words_of(sequence: Sequence, phrases: Phrases) -> Iterator[str]:
    """Yield every word that is written in a pattern, those of its phrases too."""
    for part in parts_of(sequence):
        if isinstance(part, Word):
            yield part.text
        elif isinstance(part, PhraseUse):
            yield from words_of(phrases[part.name], phrases)


class Sampler:
    """Makes sentences of one language: listed words, numbers, and in free slots words of tests."""

    def __init__(self, library: Library, language: str) -> None:
        self.language = language
        self.phrases = phrases_of(library, language)
        self._lists = {
            listed.key: [word for row in listed.values.get(language, {}).values() for word in row]
            for listed in library.values
        }
        self._own: defaultdict[tuple[str, str], list[str]] = defaultdict(list)
        self._kind: defaultdict[str, list[str]] = defaultdict(list)
        for intent in library.intents:
            self._learn(intent)

    def _learn(self, intent: Intent) -> None:
        kinds = {slot.name: slot.kind for slot in intent.slots if slot.free}
        for test in intent.tests.get(self.language, ()):
            for name, value in (test.parameters or {}).items():
                if name in kinds:
                    self._own[intent.key, name].append(value)
                    self._kind[kinds[name]].append(value)

    def words(self, intent: Intent, slot: Slot) -> list[str]:
        """Return words for a slot; at least one."""
        if slot.list_key:
            return self._lists[slot.list_key] or [NEUTRAL]
        if not slot.free:
            return list(SPOKEN[self.language].examples.get(slot.kind, (NEUTRAL,)))
        return self._own[intent.key, slot.name] or self._kind[slot.kind] or [NEUTRAL]

    def samples(self, intent: Intent, trigger: str, *, most: int) -> list[Sample]:
        """Return up to `most` different sentences of a trigger, the same ones each time."""
        chance = Random(f"{intent.key} {self.language} {trigger}")
        possible = {slot.name: self.words(intent, slot) for slot in intent.slots}
        found: dict[str, Sample] = {}
        for _ in range(_TRIES * most):
            one = self._sample(trigger, chance, possible)
            found.setdefault(one.sentence, one)
            if len(found) == most:
                break
        return list(found.values())

    def _sample(
        self, trigger: str, chance: Random, possible: Mapping[str, Collection[str]]
    ) -> Sample:
        said: list[tuple[str, str]] = []

        def value(name: str) -> str:
            said.append((name, chance.choice(tuple(possible[name]))))
            return said[-1][1]

        blank = " " if LANGUAGES[self.language].spaced else ""
        words = sample(parsed(trigger), chance, self.phrases, value)
        return Sample(blank.join(words), tuple(said))


def all_wordings(
    sequence: Sequence,
    phrases: Phrases,
    slot: Callable[[str], str],
    units: Callable[[str], tuple[str, ...]],
) -> Iterator[tuple[str, ...]]:
    """Yield every wording of a trigger in units; `slot` gives the unit that stands for a slot.

    Only for triggers whose number of wordings is known to be small.
    """
    options = [list(_ways(part, phrases, slot, units)) for part in sequence.parts]
    for way in product(*options):
        yield tuple(unit for piece in way for unit in piece)


def _ways(
    part: Part,
    phrases: Phrases,
    slot: Callable[[str], str],
    units: Callable[[str], tuple[str, ...]],
) -> Iterator[tuple[str, ...]]:
    wordings = partial(all_wordings, phrases=phrases, slot=slot, units=units)
    if isinstance(part, Word):
        yield units(part.text)
    elif isinstance(part, SlotUse):
        yield (slot(part.name),)
    elif isinstance(part, PhraseUse):
        yield from wordings(phrases[part.name])
    elif isinstance(part, Choice):
        if part.optional:
            yield ()
        for option in part.options:
            yield from wordings(option)
