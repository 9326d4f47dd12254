"""Matching by trigger sentences: an index of rare words first, then one machine per trigger."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

from languages.language import Language
from plans.engine.matchers.candidates import candidate_of, fit_of
from plans.engine.matchers.matcher import Candidate, NearMiss, Way
from plans.engine.matchers.patterns_characters import characters_meant, characters_spelt
from plans.engine.matchers.patterns_faults import near_misses
from plans.engine.matchers.patterns_hearing import Hearing, Knowledge, Spelt
from plans.engine.matchers.patterns_spelling import spelt
from plans.engine.matchers.patterns_suggest import suggested
from plans.engine.reading import Reading, read, without
from plans.engine.templates import Template, sentence_keys

_MOST_REMEMBERED = 16
_MOST_FILLERS = 4
#: What is left without fillers must still be words: そうですねえ does not ask え？
_SHORTEST_REST = 3
#: A request is short; a longer sentence is a story and is taken at its word.
_LONGEST_MENDED = 16
_LONGEST_MENDED_CHARACTERS = 40


@dataclass(frozen=True, slots=True)
class PatternMatcher:
    """All triggers of one language; its passes share the reading of a sentence."""

    language: Language
    knowledge: Knowledge
    _heard: dict[str, Hearing | None] = field(default_factory=dict, repr=False, compare=False)

    def find(self, sentence: str, way: Way = Way.WORDS) -> tuple[Candidate, ...]:
        """Return every intent with a trigger the whole sentence fits, skip words aside."""
        hearing = self._hear(sentence)
        if hearing is None:
            return ()
        if way == Way.WORDS:
            return () if hearing.reading.sounds else self._fitting_all(hearing)
        if way == Way.FILLERS:
            return self._without_fillers(hearing)
        if len(hearing.reading.units) > self._longest:
            return ()
        return self._mended(hearing) if way == Way.SPELLING else self._asked(hearing)

    @property
    def _longest(self) -> int:
        return _LONGEST_MENDED if self.knowledge.spaced else _LONGEST_MENDED_CHARACTERS

    def _mended(self, hearing: Hearing) -> tuple[Candidate, ...]:
        near = self.knowledge.near
        if near is not None:
            return tuple(characters_spelt(hearing, self.knowledge, near))
        return tuple([each.candidate for each in self._spelt(hearing) if each.acts])

    def _asked(self, hearing: Hearing) -> tuple[Candidate, ...]:
        near = self.knowledge.near
        if near is not None:
            asked = tuple(characters_meant(hearing, self.knowledge, near))
        else:
            asked = tuple([each.candidate for each in self._spelt(hearing) if not each.acts])
        return asked or tuple(suggested(hearing, self.knowledge))

    def forget(self) -> None:
        """Keep nothing of what was said: the turn is over."""
        self._heard.clear()

    def prepare(self) -> None:
        """Build all machines and tables now."""
        for template in self.knowledge.index.templates:
            _ = template.machine
        if self.knowledge.near is not None:
            self.knowledge.near.prepare()

    def words(self, sentence: str) -> tuple[str, ...]:
        """Return the words as they are read: small letters, accents as in the triggers."""
        hearing = self._hear(sentence)
        return hearing.reading.units if hearing else ()

    def near(self, sentence: str, most: int) -> tuple[NearMiss, ...]:
        """Return up to `most` triggers that almost fit, the nearest first."""
        hearing = self._hear(sentence)
        return near_misses(hearing, self.knowledge, most) if hearing else ()

    def _hear(self, sentence: str) -> Hearing | None:
        # Another thread may forget in between, so the look-up is one step.
        try:
            return self._heard[sentence]
        except KeyError:
            pass
        if len(self._heard) >= _MOST_REMEMBERED:
            self._heard.clear()
        known = self.knowledge
        reading = read(sentence, self.language, known.vocabulary, known.sounds)
        hearing = None
        if reading is not None and reading.units:
            keys = sentence_keys(reading.units, known.spaced)
            hearing = Hearing(reading, keys, known.index.possible(keys))
        self._heard[sentence] = hearing
        return hearing

    def _fitting_all(self, hearing: Hearing) -> tuple[Candidate, ...]:
        if not hearing.possible:
            return ()
        return tuple(self._fitting(hearing.possible, hearing.reading, ""))

    def _fitting(
        self, templates: Iterable[Template], reading: Reading, change: str
    ) -> Iterator[Candidate]:
        for start, end in self.knowledge.edges.ranges(reading.units):
            units, others = reading.units[start:end], reading.others[start:end]
            for template in templates:
                path = template.machine.read(units, others)
                if path is not None:
                    fit = fit_of(template, reading, start, path)
                    candidate = candidate_of(fit, self.knowledge, change)
                    if candidate is not None:
                        yield candidate

    def _without_fillers(self, hearing: Hearing) -> tuple[Candidate, ...]:
        if hearing.reading.sounds:
            found = tuple(self._fitting(hearing.possible, hearing.reading, "a hesitation"))
            if found:
                return found
        fillers = self.knowledge.fillers.runs(hearing.reading.units)
        if not fillers:
            return ()
        every = tuple(place for run in fillers for place in run)
        singly = fillers[:_MOST_FILLERS] if len(fillers) > 1 else ()
        # One at a time first: "kindly play Just the Way You Are" keeps its title.
        for places in (*singly, every):
            found = self._leaving_out(hearing, places)
            if found:
                return found
        return ()

    def _leaving_out(self, hearing: Hearing, places: Iterable[int]) -> tuple[Candidate, ...]:
        reading = hearing.reading
        shorter = without(reading, places, sounds=reading.sounds)
        if sum(map(len, shorter.units)) < _SHORTEST_REST:
            return ()
        known = self.knowledge
        # Without spaces, new neighbours make new keys.
        possible = (
            hearing.possible
            if known.spaced
            else known.index.possible(sentence_keys(shorter.units, spaced=False))
        )
        blank = " " if known.spaced else ""
        said = blank.join(reading.units[place] for place in places)
        return tuple(self._fitting(possible, shorter, f"'{said}' was left out"))

    def _spelt(self, hearing: Hearing) -> tuple[Spelt, ...]:
        if hearing.spelt is None:
            hearing.spelt = tuple(spelt(hearing, self.knowledge))
        return hearing.spelt
