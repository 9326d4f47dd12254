"""Any talk about anything: the agent always says something, its plans are as documented."""

import re
from typing import Any

from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, rule
from hypothesis.stateful import run_state_machine_as_test as run

from dialogue.engine.content import Content
from dialogue.turns import TurnAnswer, first_turn, read_state, take_turn, write_state
from plans.engine.actions import ACTIONS
from tests.fuzz import targets
from tests.fuzz.strategies import LANGUAGES, examples, sentences
from tests.site_fixtures import CONTENT

ROBOT = [action.name for action in ACTIONS]


def documented_reader() -> Any:
    """Return `read_plan` as docs/plans.md shows it, knowing every action."""
    page = (CONTENT.parent / "docs" / "plans.md").read_text(encoding="utf-8")
    (code,) = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    names: dict[str, Any] = {}
    exec(code, names)  # noqa: S102 - the page shows it
    names["PARAMETERS"] = {one.name: [each.name for each in one.parameters] for one in ACTIONS}
    return names["read_plan"]


class Talk(RuleBasedStateMachine):
    """One talk; only the text of the state goes from turn to turn, as with a robot."""

    def __init__(self, content: Content) -> None:
        super().__init__()
        self.content = content
        self.state = ""
        self.taken: TurnAnswer | None = None
        self.read_plan = documented_reader()

    @initialize(
        code=LANGUAGES, culture=st.sampled_from(["EN", "IT", "JP", "IN"]), seed=st.integers(0, 99)
    )
    def start(self, code: str, culture: str, seed: int) -> None:
        said = first_turn(self.content, code, culture, seed)
        assert said.sentence.strip()
        self.code = code
        self.state = write_state(said.state)

    @rule(data=st.data(), can=st.none() | st.lists(st.sampled_from(ROBOT), max_size=4))
    def say(self, data: st.DataObject, can: list[str] | None) -> None:
        self._turn(data.draw(sentences(self.content.catalogue, self.code)), can)

    @rule(
        words=st.sampled_from(
            ["yes", "no", "sì", "no", "はい", "いいえ", "", "stop", "tell me more", "change topic"]
        )
    )
    def answer(self, words: str) -> None:
        self._turn(words, None)

    @rule(data=st.data())
    def name_a_topic(self, data: st.DataObject) -> None:
        node = data.draw(st.sampled_from(list(self.content.tree.nodes.values())))
        self._turn(node.names[self.code].forms[""], None)

    def _turn(self, sentence: str, can: list[str] | None) -> None:
        state = read_state(self.state)
        self.taken = take_turn(self.content, state, sentence[:1000], capabilities=can, explain=True)
        self.state = write_state(self.taken.reply.state)
        assert self.taken.reply.state.turn == state.turn + 1
        assert can is None or {one.action for one in self.taken.plan.plan_actions} <= set(can)

    @invariant()
    def something_is_said(self) -> None:
        if self.taken is not None:
            assert (self.taken.plan.plan_sentence + self.taken.reply.sentence).strip()

    @invariant()
    def plans_are_as_documented(self) -> None:
        if self.taken is None:
            return
        plan = self.taken.plan
        actions = [(one.action, dict(one.parameters)) for one in plan.plan_actions]
        targets.plan_of(plan.plan, actions)
        assert self.read_plan(plan.plan) == actions


def test_any_talk_goes_on_and_its_plans_are_as_documented(published: Content) -> None:
    run(lambda: Talk(published), settings=examples(25, stateful_step_count=12))
