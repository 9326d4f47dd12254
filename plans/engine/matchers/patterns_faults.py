"""What keeps a trigger from fitting a sentence, in sentences for its author."""

from collections.abc import Iterator
from itertools import groupby

from plans.engine.alignment import EXTRA, Alignment, Errors, align
from plans.engine.matchers.candidates import Fit, aligned_fit, candidate_of, stretches
from plans.engine.matchers.matcher import NearMiss
from plans.engine.matchers.patterns_hearing import Hearing, Knowledge
from plans.engine.templates import Template
from plans.engine.vocabulary import one_edit_apart

_MOST_TRIED = 40
#: Tried one after the other, so that one kind of fault is told where it is enough.
_LOOSE = (
    Errors(most=2, missing=True, empty=True),
    Errors(most=3, extra=True),
    Errors(most=4, extra=True, wrong=True, missing=True, empty=True),
)


def near_misses(hearing: Hearing, known: Knowledge, most: int) -> tuple[NearMiss, ...]:
    """Return the triggers that almost fit, those with the fewest faults first."""
    found: list[tuple[int, int, NearMiss]] = []
    for template in _nearest(hearing, known):
        missed = _missed(hearing, template, known)
        if missed is not None:
            cost, faults = missed
            miss = NearMiss(template.intent, template.trigger, faults)
            found.append((cost, len(found), miss))
    return tuple(miss for _, _, miss in sorted(found)[:most])


def _nearest(hearing: Hearing, known: Knowledge) -> list[Template]:
    """Return the triggers whose words are in the sentence to the largest part."""
    shares = [
        (sum(not clause.isdisjoint(hearing.keys) for clause in each.clauses), each)
        for each in known.index.templates
    ]
    some = [(have / len(each.clauses), have, each) for have, each in shares if have]
    some.sort(key=lambda share: share[:2], reverse=True)
    return [template for _, _, template in some[:_MOST_TRIED]]


def _missed(
    hearing: Hearing, template: Template, known: Knowledge
) -> tuple[int, tuple[str, ...]] | None:
    """Return the number of errors and the faults, or None where the trigger is far or fits."""
    best: tuple[int, tuple[str, ...]] | None = None
    for fit, alignment in _alignments(hearing, template, known):
        faults = tuple(faults_of(fit, alignment))
        if not faults and candidate_of(fit, known) is not None:
            return None
        cost = _cost(fit, alignment)
        if fit.literal and (best is None or cost < best[0]):
            best = (cost, faults or tuple(_refused(fit, known)))
    return best


def _alignments(
    hearing: Hearing, template: Template, known: Knowledge
) -> Iterator[tuple[Fit, Alignment]]:
    reading = hearing.reading
    for start, end in known.edges.widest_and_shortest(reading.units):
        units, others = reading.units[start:end], reading.others[start:end]
        for errors in _LOOSE:
            alignment = align(template.machine, units, others, errors)
            if alignment is not None:
                yield aligned_fit(template, reading, start, alignment), alignment


def _cost(fit: Fit, alignment: Alignment) -> int:
    """Return how far the trigger is from the sentence; a wrong word is a long way."""
    words, units = fit.template.machine.words, fit.reading.units
    wrong = [
        1 if one_edit_apart(units[fit.start + place], words[alignment.path[place]]) else 3
        for place in alignment.wrong
    ]
    return len(alignment.extra) + len(alignment.missing) + sum(wrong)


def faults_of(fit: Fit, alignment: Alignment) -> Iterator[str]:
    """Yield what is missing, in the way, or there instead."""
    machine, blank = fit.template.machine, _blank(fit)
    reading = fit.reading
    for name, group in groupby(alignment.missing, key=machine.slots.__getitem__):
        if name:
            yield f"{{{name}}} is empty"
        else:
            words = blank.join(machine.words[position] for position in group)
            kind = "words" if " " in words else "word"
            verb = "are" if kind == "words" else "is"
            yield f"the {kind} '{words}' {verb} missing"
    for extra, places in groupby(
        range(len(alignment.path)), lambda at: alignment.path[at] == EXTRA
    ):
        if extra:
            at = list(places)
            said = reading.original(fit.start + at[0], fit.start + at[-1] + 1)
            yield f"'{said}' stands in the way"
    for place in alignment.wrong:
        said = reading.original(fit.start + place, fit.start + place + 1)
        yield f"'{said}' stands where '{machine.words[alignment.path[place]]}' is expected"


def _refused(fit: Fit, known: Knowledge) -> Iterator[str]:
    for name, start, end in stretches(fit.names):
        first, last = fit.start + start, fit.start + end
        slot = fit.template.slots[name]
        if known.slot_words.value(slot, fit.reading, first, last) is None:
            yield f"'{fit.reading.original(first, last)}' cannot be a {{{name}}}"


def _blank(fit: Fit) -> str:
    return (
        " " if any(len(word) > 1 and word.isascii() for word in fit.template.machine.words) else ""
    )
