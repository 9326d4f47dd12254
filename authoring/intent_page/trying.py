"""Try a sentence: which intent takes it, what is captured, what the robot then says and does."""

from collections.abc import Iterable
from dataclasses import dataclass
from random import Random

from authoring.intent_page.draft_library import Compiled
from plans.engine.explain import Explanation, Parameter, Winner, explain
from plans.engine.manager import answer
from plans.engine.matchers.matcher import Explaining

LONGEST = 300
MOST_CLOSE = 5
MOST_LOOKED_AT = 60
MOST_OWN = 3


@dataclass(frozen=True, slots=True)
class Piece:
    """A piece of the sentence; `name` is the parameter that captured it, "" for none."""

    text: str
    name: str = ""


@dataclass(frozen=True, slots=True)
class Other:
    """Another trigger: its intent and number, and the reasons why it did not win."""

    intent: str
    number: int
    trigger: str
    reasons: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Tried:
    """What became of a sentence; `winner` is None where it asks for nothing.

    `plan` and `kbplan` are as a client gets them; `question` is what would be asked.
    """

    sentence: str
    pieces: tuple[Piece, ...]
    words: tuple[str, ...]
    winner: Winner | None
    number: int
    says: str
    plan: str
    kbplan: str
    question: str
    lost: tuple[Other, ...]
    near: tuple[Other, ...]


def tried(compiled: Compiled, sentence: str, language: str, own: int = -1) -> Tried:
    """Return what becomes of a sentence in a language.

    `own` is the number of the intent that is being written: what it lacks is told first.
    """
    catalogue = compiled.catalogue
    found: Explanation = explain(catalogue, sentence, language)
    made = answer(catalogue, sentence, language, chance=Random(0))
    winner = found.winner
    return Tried(
        sentence=sentence,
        pieces=marked(sentence, winner.parameters if winner else ()),
        words=found.words,
        winner=winner,
        number=_number(compiled, winner.intent) if winner else 0,
        says=made.plan_sentence,
        plan=made.plan,
        kbplan=made.kbplan,
        question=made.question.text if made.question else "",
        lost=tuple(
            Other(one.intent, _number(compiled, one.intent), one.trigger, (one.why,))
            for one in found.losers[:MOST_CLOSE]
        ),
        near=_near(compiled, found, sentence, language, own),
    )


def _near(
    compiled: Compiled, found: Explanation, sentence: str, language: str, own: int
) -> tuple[Other, ...]:
    near = [
        Other(one.intent, _number(compiled, one.intent), one.trigger, one.faults)
        for one in found.near
    ]
    taken = found.winner is not None and _number(compiled, found.winner.intent) == own
    if own >= 0 and not taken:
        misses = (
            miss
            for each in compiled.catalogue.matchers.get(language, ())
            if isinstance(each, Explaining)
            for miss in each.near(sentence, MOST_LOOKED_AT)
        )
        mine = [
            Other(miss.intent.key, own, miss.trigger, miss.faults)
            for miss in misses
            if miss.intent.number == own
        ][:MOST_OWN]
        near = [*mine, *(one for one in near if one not in mine)]
    return tuple(near[:MOST_CLOSE])


def _number(compiled: Compiled, key: str) -> int:
    return compiled.catalogue.intents[key].number


def marked(sentence: str, parameters: Iterable[Parameter]) -> tuple[Piece, ...]:
    """Return the sentence in pieces, those that parameters captured with their names."""
    places = sorted(
        (start, start + len(one.words), one.name)
        for one in parameters
        if one.words and (start := sentence.find(one.words)) >= 0
    )
    pieces, done = [], 0
    for start, end, name in places:
        if start >= done:
            pieces += [Piece(sentence[done:start]), Piece(sentence[start:end], name)]
            done = end
    return tuple(piece for piece in (*pieces, Piece(sentence[done:])) if piece.text)
