"""Sentences with one wrongly spelt word, one lost blank or one blank too much."""

from collections.abc import Iterator

from plans.engine.alignment import Alignment, Errors, align
from plans.engine.automaton import DIGITS
from plans.engine.matchers.candidates import Fit, aligned_fit, candidate_of, fit_of
from plans.engine.matchers.patterns_hearing import Hearing, Knowledge, Spelt
from plans.engine.matchers.patterns_mending import Mended, mended, mendings
from plans.engine.matchers.trust import Trust, trust_characters, trust_words
from plans.engine.templates import Template

_MOST_TEMPLATES = 12
_MOST_RUNS = 24
_MOST_NEAR = 4
_ONE = Errors(most=1, extra=True, wrong=True, missing=True)


def spelt(hearing: Hearing, known: Knowledge) -> tuple[Spelt, ...]:
    """Return what the sentence means once one word of it is mended."""
    found = _words_spelt(hearing, known) if known.spaced else _characters_spelt(hearing, known)
    return tuple(found)


def _words_spelt(hearing: Hearing, known: Knowledge) -> Iterator[Spelt]:
    options = mendings(hearing.reading, known.vocabulary)
    keys = hearing.keys.union(*(option.words for option in options)) if options else frozenset()
    runs = 0
    for template in known.index.possible(keys)[:_MOST_TEMPLATES] if options else ():
        lacking = [clause for clause in template.clauses if clause.isdisjoint(hearing.keys)]
        for option in options:
            if not _helps(option, template, lacking, known) or runs >= _MOST_RUNS:
                continue
            runs += 1
            yield from _mended_fits(hearing, template, option, known)


def _helps(
    option: Mended, template: Template, lacking: list[frozenset[str]], known: Knowledge
) -> bool:
    """Say whether the mended words give the trigger all it lacks, or stand where they can help."""
    if lacking:
        return not any(clause.isdisjoint(option.words) for clause in lacking)
    kinds = template.machine.kinds
    return any(word in kinds or word in known.edges.words for word in option.words)


def _mended_fits(
    hearing: Hearing, template: Template, option: Mended, known: Knowledge
) -> Iterator[Spelt]:
    reading = mended(hearing.reading, option)
    for start, end in known.edges.ranges(reading.units):
        path = template.machine.read(reading.units[start:end], reading.others[start:end])
        if path is None:
            continue
        fit = fit_of(template, reading, start, path)
        trust = trust_words(fit, option)
        if trust is not Trust.NO:
            change = f"'{option.said}' was read as '{' '.join(option.words)}'"
            candidate = candidate_of(fit, known, change)
            if candidate is not None:
                yield Spelt(candidate, trust is Trust.ACT)


def _characters_spelt(hearing: Hearing, known: Knowledge) -> Iterator[Spelt]:
    reading = hearing.reading
    templates = known.index.nearly(hearing.keys, _MOST_NEAR)
    for start, end in known.edges.widest_and_shortest(reading.units) if templates else ():
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
