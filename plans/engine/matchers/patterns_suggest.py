"""The nearest trigger, which is asked about: unknown words in the way, one word left out."""

from collections.abc import Iterator

from plans.engine.alignment import Alignment, Errors, align
from plans.engine.matchers.candidates import Fit, aligned_fit, candidate_of
from plans.engine.matchers.matcher import Candidate
from plans.engine.matchers.patterns_faults import faults_of
from plans.engine.matchers.patterns_hearing import Hearing, Knowledge
from plans.engine.reading import Reading
from plans.engine.templates import Template
from plans.engine.vocabulary import one_edit_apart

_MOST_TEMPLATES = 24
_MOST_NEAR = 4
_PROOF = 3
_PROOF_CHARACTERS = 3
_LONGEST_UNKNOWN = 5
_EXTRA_WORDS = Errors(most=3, extra=True)
_EXTRA_CHARACTERS = Errors(most=8, extra=True)
_ONE_WORD = Errors(most=1, missing=True, wrong=True)
#: Endings after which words in front are the subject of a statement.
_PARTICLES = frozenset("はがをも")
#: At the very end of a sentence it only softens a request: ラジオなんだけど
_SOFTENER = ("け", "ど")


def suggested(hearing: Hearing, known: Knowledge) -> Iterator[Candidate]:
    """Yield what the sentence may have been meant to say."""
    extra = _EXTRA_WORDS if known.spaced else _EXTRA_CHARACTERS
    ranges = known.edges.widest_and_shortest(hearing.reading.units)
    for template in hearing.possible[:_MOST_TEMPLATES]:
        yield from _aligned(hearing.reading, ranges, template, extra, known)
    if known.spaced:
        for template in known.index.nearly(hearing.keys, _MOST_NEAR):
            yield from _aligned(hearing.reading, ranges, template, _ONE_WORD, known)


def _aligned(
    reading: Reading,
    ranges: list[tuple[int, int]],
    template: Template,
    errors: Errors,
    known: Knowledge,
) -> Iterator[Candidate]:
    for first, last in ranges:
        units, others = reading.units[first:last], reading.others[first:last]
        alignment = align(template.machine, units, others, errors)
        if alignment is None:
            continue
        fit = aligned_fit(template, reading, first, alignment)
        if _is_worth_asking(fit, alignment, known):
            change = " and ".join(faults_of(fit, alignment))
            candidate = candidate_of(fit, known, change)
            if candidate is not None:
                yield candidate


def _is_worth_asking(fit: Fit, alignment: Alignment, known: Knowledge) -> bool:
    proof = fit.literal + fit.listed
    extra = alignment.extra
    if alignment.missing or alignment.wrong:
        return proof >= _PROOF + fit.free and _nearly_said(fit, alignment)
    if not extra or extra[-1] - extra[0] >= len(extra):
        return False
    said = tuple(fit.reading.units[fit.start + place] for place in extra)
    if fit.start + extra[0] == 0:
        said = _without_skip_words(said, known)
    elif extra[-1] == len(alignment.path) - 1:
        said = _behind_skip_words(said, known)
    behind = extra[-1] == len(alignment.path) - 1
    if behind and len(said) > len(_SOFTENER) and said[-len(_SOFTENER) :] == _SOFTENER:
        said = said[: -len(_SOFTENER)]
    if _tells(said, known):
        return False
    if known.spaced:
        return min(map(len, said)) > 1 and proof >= len(said) + 1 + fit.free
    return (
        said[-1] not in _PARTICLES and len(said) <= _LONGEST_UNKNOWN and proof >= _PROOF_CHARACTERS
    )


def _nearly_said(fit: Fit, alignment: Alignment) -> bool:
    """Say whether a wrong word is at least a letter away from the one that is meant."""
    words = fit.template.machine.words
    return all(
        one_edit_apart(fit.reading.units[fit.start + place], words[alignment.path[place]])
        for place in alignment.wrong
    )


def _without_skip_words(said: tuple[str, ...], known: Knowledge) -> tuple[str, ...]:
    """Cut skip words that follow an unknown first word: "buddy, could you ..."."""
    rest = said[1:]
    return said[:1] if rest and len(rest) in known.edges.starts(rest) else said


def _behind_skip_words(said: tuple[str, ...], known: Knowledge) -> tuple[str, ...]:
    """Cut skip words that stand before unknown last words: "..., please buddy"."""
    skipped = (size for size in range(len(said) - 1, 0, -1) if 0 in known.edges.ends(said[:size]))
    return said[next(skipped, 0) :]


def _tells(said: tuple[str, ...], known: Knowledge) -> bool:
    """Say whether what stands in the way belongs to a statement: "we", "was", "because"."""
    refused = known.slot_words.not_in_topic
    return any(
        said[start : start + length] in refused
        for length in known.slot_words.clause_lengths
        for start in range(len(said))
    )
