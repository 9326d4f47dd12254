"""Sentences without spaces in which one character is wrong, missing or too much."""

from collections.abc import Iterator

from plans.engine.alignment import Alignment, Errors, align
from plans.engine.automaton import DIGITS
from plans.engine.matchers.candidates import Fit, aligned_fit, candidate_of
from plans.engine.matchers.matcher import Candidate
from plans.engine.matchers.patterns_hearing import Hearing, Knowledge, Spelt
from plans.engine.matchers.patterns_near import NearTriggers, plain
from plans.engine.matchers.trust import Trust, trust_characters
from plans.engine.templates import Template, sentence_keys

_MOST_ALIKE = 8
_MOST_SHARING = 12
_ONE = Errors(most=1, extra=True, wrong=True, missing=True)


def characters_spelt(hearing: Hearing, known: Knowledge, near: NearTriggers) -> Iterator[Candidate]:
    """Yield what the sentence means once a character is mended that sounds the same."""
    run = "".join(hearing.reading.units)
    heard = plain(run)
    keys = hearing.keys if heard == run else sentence_keys(tuple(heard), spaced=False)
    templates = near.alike(keys, _MOST_ALIKE)
    if templates:
        for each in _mended(hearing, known, templates):
            if each.acts:
                yield each.candidate


def characters_meant(hearing: Hearing, known: Knowledge, near: NearTriggers) -> Iterator[Candidate]:
    """Yield what the sentence may mean once any one of its characters is mended."""
    run = "".join(hearing.reading.units)
    for each in _mended(hearing, known, near.sharing(run, hearing.keys, _MOST_SHARING)):
        yield each.candidate


def _mended(hearing: Hearing, known: Knowledge, templates: list[Template]) -> Iterator[Spelt]:
    reading = hearing.reading
    for start, end in known.edges.widest_and_shortest(reading.units):
        units, others = reading.units[start:end], reading.others[start:end]
        if DIGITS in others and len(units) == 1:
            continue
        for template in templates:
            alignment = align(template.machine, units, others, _ONE)
            if alignment is None:
                continue
            fit = aligned_fit(template, reading, start, alignment)
            said, meant = _error(fit, alignment)
            trust = trust_characters(fit, alignment, said, meant)
            if trust is not Trust.NO:
                change = _told(said, meant)
                candidate = candidate_of(fit, known, change)
                if candidate is not None:
                    yield Spelt(candidate, trust is Trust.ACT)


def _error(fit: Fit, alignment: Alignment) -> tuple[str, str]:
    """Return the character that was said and the one that was meant, "" where there is none."""
    units, words = fit.reading.units, fit.template.machine.words
    if alignment.wrong:
        place = alignment.wrong[0]
        return units[fit.start + place], words[alignment.path[place]]
    if alignment.missing:
        return "", words[alignment.missing[0]]
    return (units[fit.start + alignment.extra[0]], "") if alignment.extra else ("", "")


def _told(said: str, meant: str) -> str:
    if said and meant:
        return f"'{said}' was read as '{meant}'"
    return f"'{said}' was left out" if said else f"'{meant}' was put in"
