"""Sentences with one wrongly spelt word, one lost blank or one blank too much."""

from collections.abc import Iterator

from plans.engine.matchers.candidates import candidate_of, fit_of
from plans.engine.matchers.patterns_hearing import Hearing, Knowledge, Spelt
from plans.engine.matchers.patterns_mending import Mended, mended, mendings
from plans.engine.matchers.trust import Trust, trust_words
from plans.engine.templates import Template

_MOST_TEMPLATES = 12
_MOST_RUNS = 24


def spelt(hearing: Hearing, known: Knowledge) -> Iterator[Spelt]:
    """Yield what the sentence means once one word of it is mended."""
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
