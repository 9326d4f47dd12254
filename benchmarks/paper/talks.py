"""Real talks of one person with each system, until so many topics are covered."""

from collections.abc import Iterator
from copy import deepcopy
from dataclasses import replace
from random import Random
from typing import NamedTuple

from benchmarks.baseline.data import Data
from benchmarks.baseline.dialogue_manager import reply as baseline_reply
from benchmarks.baseline.plan_manager import find_plan
from benchmarks.baseline.state import State, covered, first_state
from dialogue.engine.content import Content, keyword_rows
from dialogue.engine.state import DialogueState
from dialogue.engine.tree import Node
from dialogue.simulation.users import NO, SHORT, YES
from dialogue.turns import first_turn, take_turn

LANGUAGE, CULTURE = "en", "EN"
#: After so many turns without a new topic the person names one.
PATIENCE = 4
MOST_TRIES = 6


class Stage(NamedTuple):
    """A state at a moment of the talk: how many topics and turns it took to get there."""

    topics: int
    turns: int
    state: object


def answer(chance: Random) -> str:
    """Return what the person answers: yes more often than no, now and then neither."""
    kind = chance.choices((YES, NO, SHORT), (6, 3, 1))[0]
    return chance.choice(kind[LANGUAGE])


class Person:
    """Who talks with our service: answers, and names a topic where nothing new comes."""

    def __init__(self, content: Content, seed: int) -> None:
        self.content = content
        self.chance = Random(seed)
        self.tries = dict.fromkeys(content.tree.nodes, 0)
        self.words = {row.topic: row.first for row in keyword_rows(content.knowledge, LANGUAGE)}
        self.quiet = 0

    def say(self, open_topics: set[int]) -> str:
        """Return the next sentence."""
        self.quiet += 1
        if self.quiet <= PATIENCE:
            return answer(self.chance)
        self.quiet = 0
        least = min(self.tries[number] for number in open_topics)
        number = next(one for one in sorted(open_topics) if self.tries[one] == least)
        self.tries[number] += 1
        return f"Let us talk about {self._name(self.content.tree.nodes[number], least)}"

    def gave_up(self, open_topics: set[int]) -> bool:
        """Say whether all that is left was asked for in vain."""
        return all(self.tries[number] >= MOST_TRIES for number in open_topics)

    def _name(self, node: Node, tries: int) -> str:
        names = [str(node.names[LANGUAGE].forms[""])]
        names += [word for word in self.words.get(node.number, ()) if "*" not in word]
        return names[tries % len(names)]


def ours(content: Content, marks: list[int], seed: int = 1) -> Iterator[Stage]:
    """Yield the state of our service at each mark, ascending; the last is the most one gets to."""
    person = Person(content, seed)
    state = first_turn(content, LANGUAGE, CULTURE, seed).state
    left, turns = set(content.tree.nodes), 0
    for mark in marks:
        while len(content.tree.nodes) - len(left) < mark and not person.gave_up(left):
            state = take_turn(content, state, person.say(left)).reply.state
            turns += 1
            if _notice(state, left, turns):
                person.quiet = 0
        yield Stage(len(content.tree.nodes) - len(left) if mark else 0, turns, state)


def _notice(state: DialogueState, left: set[int], turns: int) -> bool:
    """Strike out what the state covers now; say whether there is anything new."""
    before = len(left)
    left.difference_update(state.topics)
    if turns % 50 == 0 or len(left) < 50:
        left.difference_update(state.covered_topics())
    return len(left) < before


def baseline(data: Data, marks: list[int], seed: int = 1) -> Iterator[Stage]:
    """Yield the state of the baseline at each mark, ascending, after a talk of yes and no."""
    chance, state, turns = Random(seed), first_state(data), 0
    data = replace(data, remembered={})
    plans: dict[str, str] = {}
    for mark in marks:
        while turns < 40 * len(data.topics) and _fewer(state, mark, turns):
            sentence = answer(chance)
            if sentence not in plans:
                plans[sentence] = find_plan(data, sentence, chance)["kbplan"]
            baseline_reply(data, state, sentence, plans[sentence], chance)
            turns += 1
        yield Stage(covered(state), turns, deepcopy(state))


def _fewer(state: State, mark: int, turns: int) -> bool:
    return bool(mark) and (turns % 20 != 0 or covered(state) < mark)
