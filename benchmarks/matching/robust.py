"""What people and speech recognisers do to a sentence, and what becomes of it."""

from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence, Set
from dataclasses import dataclass
from functools import partial
from random import Random

from benchmarks.matching.homeassistant import Answer, Templates, comparable
from benchmarks.matching.household import UNLISTED
from benchmarks.matching.measure import percent, table
from benchmarks.matching.noise import (
    as_recognised,
    with_filler,
    with_typo,
    without_a_space,
    without_accents,
)
from benchmarks.matching.samples import Sample
from benchmarks.matching.targets import Figures
from languages.known import LANGUAGES
from plans.engine.catalogue import Catalogue
from plans.engine.intents import Library
from plans.engine.matchers.patterns_compiler import FILLERS, SKIP_END, SKIP_START
from plans.engine.patterns import parse_options
from plans.engine.reading import units_of
from plans.engine.wordings import wordings

RIGHT, VALUE, ASKED, NOTHING = "right", "other value", "asked", "nothing"
WRONG, ASKED_WRONG = "wrong", "asked for another"
OUTCOMES = (RIGHT, VALUE, ASKED, ASKED_WRONG, NOTHING, WRONG)
#: Where a question about the right intent counts as much as acting on it.
UNDERSTOOD = frozenset(("unlisted filler", "typo"))
CLEAN = "as it is"
KINDS = {
    CLEAN: "",
    "listed filler": "listed filler",
    "filler that is not listed": "unlisted filler",
    "one typo": "typo",
    "lost accents": "accents",
    "missing space": "",
    "as a speech recogniser writes": "",
}


@dataclass(frozen=True)
class Asked:
    """A sentence with the intent and parameters it must give; `kept` are not changed."""

    text: str
    intent: str
    parameters: Mapping[str, str]
    kept: tuple[str, ...]


Change = Callable[[Asked], str | None]


def stored(library: Library, code: str) -> list[Asked]:
    """Return the positive stored tests of a library."""
    return [
        Asked(test.sentence, intent.key, test.parameters, tuple(test.parameters.values()))
        for intent in library.intents
        for test in intent.tests.get(code, ())
        if test.parameters is not None
    ]


def sampled(made: Iterable[Sample], templates: Templates) -> list[Asked]:
    """Return samples that both engines get right when nothing is changed."""
    return [
        Asked(one.text, one.answer.intent, one.answer.slots, one.said)
        for one in made
        if templates.ours(one.text) == one.answer == templates.theirs(one.text)
    ]


def changes(library: Library, code: str, seed: int) -> dict[str, Change]:
    """Return the kinds of noise of a language, each a function of a sentence."""
    chance, gap = Random(seed), " " if LANGUAGES[code].spaced else ""
    before, after = (_listed(library, {key, FILLERS}, code) for key in (SKIP_START, SKIP_END))
    new_before, new_after = UNLISTED[code]
    return {
        CLEAN: lambda one: one.text,
        "listed filler": lambda one: with_filler(one.text, chance, before, after, gap),
        "filler that is not listed": lambda one: with_filler(
            one.text, chance, _others(new_before, before), _others(new_after, after), gap
        ),
        "one typo": lambda one: with_typo(one.text, chance, code, one.kept),
        "lost accents": lambda one: without_accents(one.text, code),
        "missing space": lambda one: without_a_space(one.text, chance, code, one.kept),
        "as a speech recogniser writes": lambda one: as_recognised(one.text),
    }


def _listed(library: Library, keys: Set[str], code: str) -> list[str]:
    """Return the skip words and fillers of a library, sorted: the same run meets the same ones."""
    texts = [
        phrase.texts[code]
        for phrase in library.phrases
        if phrase.key in keys and code in phrase.texts
    ]
    gap = " " if LANGUAGES[code].spaced else ""
    cut = partial(units_of, language=LANGUAGES[code])
    found = (wordings(parse_options(text), cut) - {()} for text in texts)
    return sorted(gap.join(units) for each in found for units in each)


def _others(words: Sequence[str], listed: Sequence[str]) -> list[str]:
    return [word for word in words if word not in listed]


def outcome(found: Answer | None, one: Asked, code: str, asked: str = "") -> str:
    """Say what an answer to a changed sentence is; `asked` is the intent of a question, if any."""
    if found is None and asked:
        return ASKED if asked == one.intent else ASKED_WRONG
    if found is None:
        return NOTHING
    if found.intent != one.intent:
        return WRONG
    return RIGHT if _same(found.slots, one.parameters, code) else VALUE


def _own_outcome(catalogue: Catalogue, code: str, one: Asked, sentence: str) -> str:
    match = catalogue.match(sentence, code)
    if match is not None:
        return outcome(Answer(match.intent.key, match.parameters), one, code)
    suggestion = catalogue.suggest(sentence, code)
    return outcome(None, one, code, suggestion.intent.key if suggestion else "")


def own(library: Library, catalogue: Catalogue, figures: Figures, seed: int) -> None:
    """Print what noise does to the stored tests of the shipped library."""
    rows: list[Sequence[object]] = []
    for code in LANGUAGES:
        judge = partial(_own_outcome, catalogue, code)
        asked = [one for one in stored(library, code) if judge(one, one.text) == RIGHT]
        for kind, change in changes(library, code, seed).items():
            counts = Counter(
                judge(one, noisy) for one in asked if (noisy := change(one)) is not None
            )
            _row(rows, figures, (code, kind), counts, "own")
    _print("Noise on the stored tests of the shipped library", rows, ())


def on_templates(templates: Templates, made: Sequence[Sample], figures: Figures, seed: int) -> None:
    """Print what noise does to sentences of Home Assistant's templates, beside hassil."""
    code, rows = templates.code, list[Sequence[object]]()
    asked = sampled(made, templates)
    for kind, change in changes(templates.conversion.library, code, seed).items():
        counts: Counter[str] = Counter()
        theirs = 0
        for one in asked:
            noisy = change(one)
            if noisy is not None:
                counts[_judge_template(templates, one, noisy)] += 1
                theirs += outcome(templates.theirs(noisy), one, code) == RIGHT
        total = counts.total()
        _row(rows, figures, (code, kind), counts, "HA", percent(theirs, total))
    _print(f"Noise on sentences of Home Assistant's templates, {code}", rows, ("hassil right",))


def _judge_template(templates: Templates, one: Asked, noisy: str) -> str:
    found = templates.ours(noisy)
    asked = None if found else templates.catalogue.suggest(noisy, templates.code)
    return outcome(found, one, templates.code, templates.names[asked.intent.key] if asked else "")


def _same(found: Mapping[str, str], wanted: Mapping[str, str], code: str) -> bool:
    return found.keys() == wanted.keys() and all(
        comparable(found[name], code) == comparable(wanted[name], code) for name in wanted
    )


def _row(
    rows: list[Sequence[object]],
    figures: Figures,
    names: tuple[str, str],
    counts: Counter[str],
    where: str,
    *more: str,
) -> None:
    (code, kind), total = names, counts.total()
    if not total:
        return
    shares = [percent(counts[each], total) for each in OUTCOMES]
    rows.append((code, kind, total, *shares, *more))
    name = KINDS[kind]
    if name:
        good = counts[RIGHT] + (counts[ASKED] if name in UNDERSTOOD else 0)
        figures[f"{name}, {where} {code}"] = 100 * good / total


def _print(title: str, rows: Iterable[Sequence[object]], more: tuple[str, ...]) -> None:
    table(
        title,
        "Only sentences that are right as they are, and only where the noise changes something; "
        "words that fill a slot are left as they are. Other value: the right intent, acted on with "
        "another value (a filler beside a slot of free text becomes a part of it). Asked: not "
        "acted on, but the right intent is suggested; the targets for unlisted fillers and for "
        "typos count right and asked together, all others only right.",
        ("language", "noise", "sentences", *OUTCOMES, *more),
        rows,
    )
