"""What is measured of simulated talks, and the bars D1-D4 they must meet."""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from itertools import pairwise
from typing import NamedTuple

from dialogue.engine.content import Content
from dialogue.engine.sentence_types import SENTENCE_TYPES
from dialogue.engine.tree import Node
from dialogue.simulation.talks import Exchange
from languages.known import LANGUAGES

SOON, LATE = 20, 100
AVOIDED_FOR = 20
#: Pools whose line tells that another subject follows.
_ANNOUNCING = frozenset(
    ("change", "transition", "begin", "leave", "change_asked", "stay_or_go", "initiative")
)
#: Users who leave the lead to the agent; who says no again and again is led elsewhere on purpose.
QUIET = ("passive", "yes", "no")
CONTENT = ("passive", "yes")


class Bar(NamedTuple):
    """One bar: its id, what it says, the share or number it bounds, for which users."""

    id: str
    text: str
    measure: str
    least: float | None = None
    most: float | None = None
    users: tuple[str, ...] = ()
    languages: tuple[str, ...] = ()

    def met(self, value: float) -> bool:
        """Say whether a figure is within the bar."""
        return not (
            (self.least is not None and value < self.least)
            or (self.most is not None and value > self.most)
        )


BARS = (
    Bar("D1", "identical sentences about topics in a talk", "identical", most=0.0, users=QUIET),
    Bar("D1", "frames heard again within 20 turns", "soon", most=0.03, users=QUIET),
    Bar("D1", "frames heard again within 100 turns", "late", most=0.13, users=QUIET),
    Bar("D2", "topics changed to a child, parent or sibling", "near", least=0.6, users=CONTENT),
    Bar("D2", "topics changed along a link", "link", least=0.2, most=0.4, users=CONTENT),
    Bar("D2", "topics changed to something unrelated", "far", most=0.1, users=CONTENT),
    Bar("D2", "unrelated changes announced", "announced", least=1.0),
    Bar("D2", "branches touched in 100 turns", "branches", least=8, users=QUIET),
    Bar("D3", "turns that end with a question", "questions", most=0.6, users=QUIET),
    Bar("D3", "three questions in a row", "three", most=0.0, users=QUIET),
    Bar("D3", "turns that propose an activity", "proposals", least=0.03, most=0.08, users=QUIET),
    Bar("D3", "distinct pairs of words", "distinct", least=0.6, users=QUIET, languages=("en",)),
    Bar("D4", "topical utterances recognised", "matched", least=0.7, users=("talkative",)),
    Bar("D4", "avoided subjects entered within 20 turns", "entered", most=0.0),
)


@dataclass(slots=True)
class Tally:
    """Counts over talks: each measure is a sum over a number of cases."""

    sums: Counter[str] = field(default_factory=Counter)
    cases: Counter[str] = field(default_factory=Counter)

    def add(self, measure: str, value: float, cases: int = 1) -> None:
        """Count one or more cases."""
        self.sums[measure] += value  # type: ignore[assignment]  # a Counter of fractions too
        self.cases[measure] += cases

    def value(self, measure: str) -> float | None:
        """Return the mean, None where there was no case."""
        return self.sums[measure] / self.cases[measure] if self.cases[measure] else None

    def join(self, other: "Tally") -> None:
        """Add the counts of another tally."""
        self.sums.update(other.sums)
        self.cases.update(other.cases)


def measured(content: Content, talk: Iterable[Exchange]) -> Tally:
    """Return the counts of one talk."""
    turns = list(talk)
    tally = Tally()
    for part in (_repetition, _moves, _questions, _words, _recognised):
        part(content, turns, tally)
    return tally


def _repetition(content: Content, turns: list[Exchange], tally: Tally) -> None:
    heard: dict[int, int] = {}
    told: set[tuple[int, int, int]] = set()
    for place, one in enumerate(turns):
        for number in one.frames:
            line = content.tree.lines.get(number)
            if line is None or not line.owner:
                continue
            ago = place - heard.get(number, -10 * LATE)
            tally.add("soon", ago < SOON)
            tally.add("late", ago < LATE)
            heard[number] = place
            # A transition names the topic before it, too.
            before = one.before if line.type == "t" else 0
            about = (number, before, one.reply.state.topic)
            tally.add("identical", about in told)
            told.add(about)


def _moves(content: Content, turns: list[Exchange], tally: Tally) -> None:
    branches: set[int] = set()
    for one in turns:
        old, new = content.tree.node(one.before), content.tree.node(one.reply.state.topic)
        if new:
            branches.add(new.branch)
        if old is None or new is None or old is new or one.led:
            continue
        way = _way(old, new)
        for name in ("near", "link", "far"):
            tally.add(name, name == way)
        if way == "far":
            tally.add("announced", bool(one.pools & _ANNOUNCING))
    if len(turns) >= LATE:
        tally.add("branches", len(branches))


def _way(old: Node, new: Node) -> str:
    """Return how two topics are related: near in the tree, by a link, or not at all."""
    if new.branch == old.branch:
        return "near"
    return "link" if {new.number, *new.ancestors} & set(old.links) else "far"


def _questions(_content: Content, turns: list[Exchange], tally: Tally) -> None:
    in_a_row = 0
    for one in turns:
        kind = one.reply.sentence_type
        asks = kind in SENTENCE_TYPES and SENTENCE_TYPES[kind].asks
        in_a_row = in_a_row + 1 if asks else 0
        tally.add("questions", asks)
        tally.add("three", in_a_row >= 3)
        tally.add("proposals", kind == "g")


def _words(_content: Content, turns: list[Exchange], tally: Tally) -> None:
    if not turns:
        return
    language = LANGUAGES[turns[0].reply.state.language]
    pairs: list[tuple[str, str]] = []
    for one in turns:
        words = [token.text for token in language.tokens(one.spoken)]
        pairs += pairwise(words)
    tally.add("distinct", len(set(pairs)), len(pairs))


def _recognised(content: Content, turns: list[Exchange], tally: Tally) -> None:
    avoided: list[tuple[Node, int]] = []
    for place, one in enumerate(turns):
        if one.said.topical:
            tally.add("matched", one.matched)
        if one.said.avoided:
            avoided.append((one.said.avoided, place))
        elif one.led:
            continue  # Where the person asks for it, it may come again.
        for node, since in avoided:
            if since < place <= since + AVOIDED_FOR:
                here = content.tree.is_same_or_below(one.reply.state.topic, node.number)
                moved = one.reply.state.topic != one.before
                tally.add("entered", here and moved)


class Figure(NamedTuple):
    """A bar with what was measured, and the cell that is farthest from it."""

    bar: Bar
    value: float
    worst: str
    worst_value: float

    @property
    def met(self) -> bool:
        """Say whether the bar is met over all talks."""
        return self.bar.met(self.value)


def figures(tallies: Mapping[tuple[str, str, str], Tally]) -> Iterator[Figure]:
    """Yield each bar that was measured; tallies by user, culture and language."""
    for bar in BARS:
        cells = {
            cell: tally
            for cell, tally in tallies.items()
            if (not bar.users or cell[0] in bar.users)
            and (not bar.languages or cell[2] in bar.languages)
        }
        whole = Tally()
        values: dict[tuple[str, str, str], float] = {}
        for cell, tally in cells.items():
            whole.join(tally)
            value = tally.value(bar.measure)
            if value is not None:
                values[cell] = value
        total = whole.value(bar.measure)
        if total is not None:
            worst = (min if bar.least is not None else max)(values, key=lambda one: values[one])
            yield Figure(bar, total, " ".join(worst), values[worst])
