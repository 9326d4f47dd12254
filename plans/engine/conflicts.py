"""Find intents that take each other's sentences, by trying sentences of every trigger.

No proof: up to 20 sentences of a trigger are tried. Wordings two intents share are found exactly
where a trigger has few of them.
"""

from collections import defaultdict
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from functools import cache, partial

from languages.known import LANGUAGES
from plans.engine.catalogue import Catalogue, IntentMatch
from plans.engine.intents import Intent, Library
from plans.engine.matchers.matcher import Candidate
from plans.engine.patterns import expansions
from plans.engine.reading import units_of
from plans.engine.remarks import Remark
from plans.engine.trigger_samples import (
    Phrases,
    Sample,
    Sampler,
    all_wordings,
    parsed,
)

MOST_SAMPLES = 20
MOST_OF_AN_INTENT = 240
MOST_WORDINGS = 300
_REASONS = ("priority", "literal words", "listed values", "fewer free slots", "shorter slots")


@dataclass(frozen=True, slots=True)
class _Trigger:
    """One trigger of one intent in one language."""

    intent: Intent
    language: str
    text: str


@dataclass(frozen=True, slots=True)
class _Lost:
    """A sentence of a trigger that another intent took, or nobody (`winner` None)."""

    sample: Sample
    winner: IntentMatch | None
    own: Candidate | None


def conflicts(
    library: Library,
    catalogue: Catalogue,
    *,
    intents: Collection[str] = (),
    languages: Collection[str] = (),
) -> list[Remark]:
    """Return what the intents take from each other; with `intents`, of these intents only."""
    found: list[Remark] = []
    for language in languages or LANGUAGES:
        sampler = Sampler(library, language)
        shared = list(_shared_wordings(library, language, sampler.phrases, intents))
        found += shared
        known = {(remark.near, remark.other) for remark in shared}
        for intent in library.intents:
            if intent.key in (intents or catalogue.intents):
                tried = _tried(intent, catalogue, sampler)
                found += [one for one in tried if (one.near, one.other) not in known]
    return found


def _tried(intent: Intent, catalogue: Catalogue, sampler: Sampler) -> Iterator[Remark]:
    language = sampler.language
    triggers = intent.triggers.get(language, ())
    most = max(4, min(MOST_SAMPLES, MOST_OF_AN_INTENT // max(len(triggers), 1)))
    for text in triggers:
        samples = sampler.samples(intent, text, most=most)
        tried = (_lost(intent, one, language, catalogue) for one in samples)
        lost = [each for each in tried if each is not None]
        yield from _told(_Trigger(intent, language, text), lost, len(samples))


def _lost(intent: Intent, one: Sample, language: str, catalogue: Catalogue) -> _Lost | None:
    """Return who took the sentence of an intent, or None where the intent wins it."""
    match = catalogue.match(one.sentence, language)
    if match is not None and match.intent.key == intent.key:
        return None
    own = [each for each in _candidates(one, language, catalogue) if each.intent.key == intent.key]
    return _Lost(one, match, max(own, key=lambda candidate: candidate.score, default=None))


def _candidates(one: Sample, language: str, catalogue: Catalogue) -> tuple[Candidate, ...]:
    """Return the candidates among which the catalogue chose."""
    found = (matcher.find(one.sentence) for matcher in catalogue.matchers.get(language, ()))
    return next(filter(None, found), ())


def _told(trigger: _Trigger, lost: list[_Lost], tried: int) -> Iterator[Remark]:
    if len(lost) == tried:
        yield _never_wins(trigger, lost)
        return
    by_winner: defaultdict[str, list[_Lost]] = defaultdict(list)
    for each in lost:
        by_winner[each.winner.intent.key if each.winner else ""].append(each)
    for winner, these in by_winner.items():
        yield _wins_some(trigger, these, tried) if winner else _unheard(trigger, these, tried)


def _never_wins(trigger: _Trigger, lost: list[_Lost]) -> Remark:
    first = lost[0]
    taken = _who(first) if first.winner else "matches nothing" + _filled(first.sample)
    return _remark(
        "C002",
        trigger,
        f"'{trigger.text}' never wins: '{first.sample.sentence}' {taken}.",
        error=True,
        winner=first.winner,
    )


def _wins_some(trigger: _Trigger, lost: list[_Lost], tried: int) -> Remark:
    tie = next((each for each in lost if _reason(each) is None), None)
    first = tie or lost[0]
    return _remark(
        "C003" if tie else "C001",
        trigger,
        f"{len(lost)} of {tried} sentences of '{trigger.text}' are lost: "
        f"'{first.sample.sentence}' {_who(first)}.",
        error=bool(tie),
        winner=first.winner,
    )


def _unheard(trigger: _Trigger, lost: list[_Lost], tried: int) -> Remark:
    first = lost[0].sample
    return _remark(
        "C004",
        trigger,
        f"{len(lost)} of {tried} sentences of '{trigger.text}' match nothing: "
        f"'{first.sentence}'{_filled(first)}.",
    )


def _filled(one: Sample) -> str:
    slots = ", ".join(f"{name}={value}" for name, value in one.slots)
    return f" (is {slots} refused, or cut off as skip words?)" if slots else ""


def _who(lost: _Lost) -> str:
    if lost.winner is None:
        return "matches nothing"
    reason = _reason(lost)
    why = f"by {reason}" if reason else "only because it stands first in the library"
    return f"goes to {lost.winner.intent.key} by '{lost.winner.trigger}', which wins {why}"


def _reason(lost: _Lost) -> str | None:
    """Return what the winner is better in; None where both are alike."""
    if lost.winner is None or lost.own is None:
        return "being the only one that fits"
    pairs = zip(_REASONS, lost.winner.score, lost.own.score, strict=False)
    return next((name for name, one, two in pairs if one != two), None)


def _remark(
    code: str,
    trigger: _Trigger,
    text: str,
    *,
    error: bool = False,
    winner: IntentMatch | None = None,
) -> Remark:
    return Remark(
        code=code,
        where=trigger.intent.key,
        language=trigger.language,
        text=text,
        error=error,
        other=winner.intent.key if winner else "",
        near=trigger.text,
    )


def _shared_wordings(
    library: Library, language: str, phrases: Phrases, intents: Collection[str]
) -> Iterator[Remark]:
    units = cache(partial(units_of, language=LANGUAGES[language]))
    holders: dict[tuple[str, ...], dict[str, _Trigger]] = {}
    for intent in library.intents:
        for text in intent.triggers.get(language, ()):
            if expansions(parsed(text), phrases) <= MOST_WORDINGS:
                stands = _stands_for(intent)
                for wording in all_wordings(parsed(text), phrases, stands.__getitem__, units):
                    trigger = _Trigger(intent, language, text)
                    holders.setdefault(wording, {}).setdefault(intent.key, trigger)
    blank = " " if LANGUAGES[language].spaced else ""
    told: dict[tuple[str, str], Remark] = {}
    for wording, triggers in holders.items():
        for loser, winner in _pairs(list(triggers.values())):
            if not intents or {loser.intent.key, winner.intent.key} & set(intents):
                remark = _shares(loser, winner, blank.join(wording))
                told.setdefault((loser.text, winner.text), remark)
    yield from told.values()


def _stands_for(intent: Intent) -> dict[str, str]:
    """Return what stands for each slot in a wording: free slots are all alike."""
    return {slot.name: "{…}" if slot.free else f"{{{slot.kind}}}" for slot in intent.slots}


def _pairs(triggers: list[_Trigger]) -> Iterator[tuple[_Trigger, _Trigger]]:
    """Yield every two of them, the one that loses first."""
    ranked = sorted(triggers, key=lambda trigger: trigger.intent.priority)
    for place, loser in enumerate(ranked):
        for winner in ranked[place + 1 :]:
            yield loser, winner


def _shares(loser: _Trigger, winner: _Trigger, wording: str) -> Remark:
    same = loser.intent.priority == winner.intent.priority
    ends = "both have the same priority" if same else f"{winner.intent.key} has the higher priority"
    return Remark(
        code="C005",
        where=loser.intent.key,
        language=loser.language,
        text=f"'{wording}' is a wording of '{loser.text}' and of '{winner.text}' of "
        f"{winner.intent.key}; {ends}.",
        error=same,
        other=winner.intent.key,
        near=loser.text,
    )
