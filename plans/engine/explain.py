"""Why a sentence means what it means: for the page where an author tries a sentence."""

from collections.abc import Iterator
from dataclasses import dataclass

from plans.engine.catalogue import Catalogue, IntentMatch
from plans.engine.matchers.matcher import Candidate, Explaining, Matcher, NearMiss, Way

MOST_NEAR = 5
#: The parts of a score, as an author knows them: one part decides, the rest is not looked at.
SCORE_PARTS = (
    "has a lower priority",
    "has fewer words of its own in the sentence",
    "has fewer listed values",
    "has more free slots",
    "has longer free words",
)


@dataclass(frozen=True, slots=True)
class Parameter:
    """One parameter of the winner and the person's own words it was read from."""

    name: str
    value: str
    words: str


@dataclass(frozen=True, slots=True)
class Winner:
    """The trigger that was chosen; `way` and `why` as in IntentMatch."""

    intent: str
    trigger: str
    way: str
    why: str
    parameters: tuple[Parameter, ...]


@dataclass(frozen=True, slots=True)
class Loser:
    """Another trigger that fitted, and why it was not chosen."""

    intent: str
    trigger: str
    why: str


@dataclass(frozen=True, slots=True)
class Near:
    """A trigger that almost fitted, and what is missing or in the way."""

    intent: str
    trigger: str
    faults: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Explanation:
    """What became of a sentence; `winner` is None where it asks for nothing.

    A winner whose way is "suggestion" would only be asked about.
    """

    words: tuple[str, ...]
    winner: Winner | None
    losers: tuple[Loser, ...]
    near: tuple[Near, ...]


def explain(catalogue: Catalogue, sentence: str, language: str) -> Explanation:
    """Return why the sentence means what it means; an unknown language explains nothing."""
    matchers = catalogue.matchers.get(language, ())
    match = catalogue.match(sentence, language) or catalogue.suggest(sentence, language)
    ranked = _ranked(matchers, sentence, match) if match else []
    winner = _winner(match, ranked, sentence) if match else None
    losers = tuple(_losers(ranked))
    near = [miss for each in _explaining(matchers) for miss in each.near(sentence, MOST_NEAR)]
    words = next((each.words(sentence) for each in _explaining(matchers)), ())
    catalogue.forget(language)
    return Explanation(
        words=words,
        winner=winner,
        losers=losers,
        near=tuple(_near(miss) for miss in _not_known(near, winner, losers)[:MOST_NEAR]),
    )


def _explaining(matchers: tuple[Matcher, ...]) -> Iterator[Explaining]:
    return (each for each in matchers if isinstance(each, Explaining))


def _ranked(matchers: tuple[Matcher, ...], sentence: str, match: IntentMatch) -> list[Candidate]:
    """Return every trigger that fitted as the winner did, each once, the best first.

    A clause is matched without the rest of the sentence, so nothing else competes with it.
    """
    best: dict[tuple[str, str], Candidate] = {}
    for matcher in matchers if match.way != Way.CLAUSE else ():
        for each in matcher.find(sentence, Way(match.way)):
            key = (each.intent.key, each.trigger)
            if key not in best or each.score > best[key].score:
                best[key] = each
        if best:
            break
    return sorted(best.values(), key=lambda each: each.score, reverse=True)


def _winner(match: IntentMatch, ranked: list[Candidate], sentence: str) -> Winner:
    spans = ranked[0].spans if ranked else {}
    parameters = tuple(
        Parameter(name, value, sentence[slice(*spans[name])] if name in spans else value)
        for name, value in match.parameters.items()
    )
    return Winner(match.intent.key, match.trigger, match.way, match.why, parameters)


def _losers(ranked: list[Candidate]) -> Iterator[Loser]:
    for other in ranked[1:]:
        pairs = zip(SCORE_PARTS, ranked[0].score, other.score, strict=True)
        parts = (part for part, won, lost in pairs if won != lost)
        yield Loser(other.intent.key, other.trigger, next(parts, "comes later in the library"))


def _not_known(
    near: list[NearMiss], winner: Winner | None, losers: tuple[Loser, ...]
) -> list[NearMiss]:
    known = {(loser.intent, loser.trigger) for loser in losers}
    if winner and winner.way != Way.SUGGESTION:
        known.add((winner.intent, winner.trigger))
    return [miss for miss in near if (miss.intent.key, miss.trigger) not in known]


def _near(miss: NearMiss) -> Near:
    return Near(miss.intent.key, miss.trigger, miss.faults)
