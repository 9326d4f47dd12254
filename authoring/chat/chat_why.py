"""Why a reply was said, in plain words with links to what can be edited."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace

from django.utils.translation import gettext as _

from authoring.chat.chat_contents import Chosen
from authoring.chat.chat_pieces import Links, Piece, filled
from authoring.chat.chat_rules import (
    ATTITUDES,
    LINES,
    LOSING,
    MATCHING,
    NOTHING_WORDS,
    OTHER_TITLE,
    REACTION_WORDS,
    RULES,
    TITLES,
    WAYS,
)
from authoring.chat.replaying import Exchange
from dialogue.engine.pools import POOLS
from dialogue.engine.sentence_types import REACTION, SENTENCE_TYPES
from dialogue.engine.turn import Step
from plans.engine.explain import Explanation, Winner, explain
from plans.engine.manager import PlanAnswer

MOST_CANDIDATES = 40
MOST_CLOSE = 3


@dataclass(frozen=True, slots=True)
class Likely:
    """A topic that could have been chosen: its likeliness 0..1 and whether it was."""

    topic: Piece
    likeliness: float
    chosen: bool


@dataclass(frozen=True, slots=True)
class Why:
    """One step: its title, its lines of Algorithm 1, the words, the topics it was drawn from.

    `title` is "" where a step goes on, `lines` where there are none; `more` candidates are left
    out.
    """

    title: str
    lines: str
    pieces: tuple[Piece, ...]
    candidates: tuple[Likely, ...] = ()
    more: int = 0


def reasons(chosen: Chosen, turn: Exchange) -> list[Why]:
    """Return the steps that led to a reply: the Plan Manager's, then the Dialogue Manager's."""
    language = turn.reply.state.language
    links = Links(chosen, language)
    found: list[Why] = []
    if turn.heard:
        matched = explain(chosen.content.catalogue, turn.heard, language)
        found += _under_one_title(_matching(links, matched, turn.understood))
    elif not turn.reply.steps:
        found += _opening(chosen, links, turn)
    found += (_told(links, step) for step in turn.reply.steps)
    return found


def _under_one_title(steps: Iterable[Why]) -> list[Why]:
    first, *others = steps
    return [first, *(replace(step, title="") for step in others)]


def _opening(chosen: Chosen, links: Links, turn: Exchange) -> Iterator[Why]:
    for number in turn.reply.state.frames:
        key = chosen.content.tree.lines[number].key
        yield _told(links, Step("pool", f"{key}, from the pool start"))


def _plan(links: Links, template: str, pieces: Mapping[str, Piece]) -> Why:
    return Why(str(TITLES["plan"]), "", filled(template, pieces))


def _matching(links: Links, matched: Explanation, understood: PlanAnswer) -> Iterator[Why]:
    winner = matched.winner
    if winner is None:
        yield _plan(links, _("No intent fits: nothing was asked for."), {})
        yield from _near(links, matched)
        return
    yield _won(links, winner)
    for one in winner.parameters:
        words = _("“%(words)s” is taken as %(name)s = %(value)s.")
        values = {"words": one.words, "name": one.name, "value": one.value}
        yield _plan(links, words, {name: Piece(text) for name, text in values.items()})
    yield from _runners_up(links, matched, winner)
    wanted = links.chosen.content.catalogue.intents[winner.intent].plan
    kept = {action.action for action in understood.plan_actions}
    for action in wanted if understood.intent else ():
        if action.action not in kept:
            words = _("This robot cannot do “%(action)s”: it is left out.")
            yield _plan(links, words, {"action": Piece(action.action)})


def _won(links: Links, winner: Winner) -> Why:
    words = _("%(intent)s was asked for, by its trigger “%(trigger)s”: %(way)s.")
    pieces = {
        "intent": links.intent(winner.intent),
        "trigger": Piece(winner.trigger),
        "way": Piece(str(MATCHING.get(winner.way, winner.way))),
    }
    return _plan(links, words, pieces)


def _runners_up(links: Links, matched: Explanation, winner: Winner) -> Iterator[Why]:
    others = [one for one in matched.losers if one.intent != winner.intent]
    for loser in others[:MOST_CLOSE]:
        words = _("It could have been %(intent)s (“%(trigger)s”), but that %(why)s.")
        pieces = {
            "intent": links.intent(loser.intent),
            "trigger": Piece(loser.trigger),
            "why": Piece(str(LOSING.get(loser.why, loser.why))),
        }
        yield _plan(links, words, pieces)


def _near(links: Links, matched: Explanation) -> Iterator[Why]:
    for near in matched.near[:1]:
        words = _("The nearest is %(intent)s (“%(trigger)s”): %(faults)s.")
        pieces = {
            "intent": links.intent(near.intent),
            "trigger": Piece(near.trigger),
            "faults": Piece("; ".join(near.faults)),
        }
        yield _plan(links, words, pieces)


def _told(links: Links, step: Step) -> Why:
    """Return a step of the Dialogue Manager; one without a rule as the engine tells it."""
    title, lines = str(TITLES.get(step.rule, OTHER_TITLE)), LINES.get(step.rule, "")
    for rule in RULES:
        match = rule.pattern.fullmatch(step.text) if rule.name == step.rule else None
        if match:
            values = {name: text or "" for name, text in match.groupdict().items()}
            pieces = {name: _piece(links, name, text) for name, text in values.items()}
            likely = _likely(links, step, values.get("topic", ""))
            more = max(0, len(step.candidates) - MOST_CANDIDATES)
            return Why(title, lines, filled(str(rule.words), pieces), likely, more)
    return Why(title, lines, (Piece(step.text),))


def _likely(links: Links, step: Step, drawn: str) -> tuple[Likely, ...]:
    ordered = sorted(step.candidates, key=lambda one: (one.topic != drawn, -one.likeliness))
    return tuple(
        Likely(links.topic(one.topic), one.likeliness, one.topic == drawn)
        for one in ordered[:MOST_CANDIDATES]
    )


def _piece(links: Links, name: str, text: str) -> Piece:
    if name in ("topic", "from"):
        return links.topic(text)
    if name == "line":
        return links.sentence(text)
    if name == "intent":
        return links.intent(text)
    return Piece(_worded(name, text))


def _worded(name: str, text: str) -> str:
    if name == "pool":
        return _(POOLS[text].used_when) if text in POOLS else text
    if name == "type":
        return type_name(text)
    if name == "order":
        letters = [] if text == "empty" else text.split()
        return ", ".join(type_name(letter) for letter in letters) or str(NOTHING_WORDS)
    known = {"way": WAYS, "attitude": ATTITUDES}.get(name, {})
    return str(known.get(text, text))


def type_name(letter: str) -> str:
    """Return what a kind of sentence is called."""
    if letter == REACTION:
        return str(REACTION_WORDS)
    known = SENTENCE_TYPES.get(letter)
    return _(known.name) if known else letter
