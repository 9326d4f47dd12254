"""A turn in the making: what was heard, the state as it changes, what will be said."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from random import Random
from types import MappingProxyType

from msgspec.structs import replace

from dialogue.engine.content import Content
from dialogue.engine.state import DialogueState, Pending
from dialogue.engine.tree import Line, Node
from languages.known import LANGUAGES
from languages.language import Language
from plans.engine.manager import Action, PlanAnswer

NO_WORDS: Mapping[str, str] = MappingProxyType({})


@dataclass(frozen=True, slots=True)
class Asking:
    """What the agent must ask before it acts, and what waits for the answer."""

    pending: Pending
    question: str


@dataclass(frozen=True, slots=True)
class Heard:
    """What reaches the Dialogue Manager: the sentence and what the Plan Manager made of it.

    `plan_said`: a plan sentence comes first, so what it says need not be said again.
    `plan_matched`: the person asked for a plan, so the words are no topic to talk about.
    `asking`: a parameter of that plan is missing, or an intent was nearly understood.
    `urgent`: help was asked for, so there is no chit-chat.
    """

    sentence: str
    kbplan_actions: tuple[Action, ...] = ()
    plan_matched: bool = False
    urgent: bool = False
    plan_said: bool = False
    asking: Asking | None = None
    capabilities: Collection[str] | None = None
    explain: bool = False


@dataclass(frozen=True, slots=True)
class Candidate:
    """A topic that could have been chosen, and how likely it was."""

    topic: str
    likeliness: float


@dataclass(frozen=True, slots=True)
class Step:
    """One step of the algorithm: the rule that fired and what it did, for authors."""

    rule: str
    text: str
    candidates: tuple[Candidate, ...] = ()


@dataclass(slots=True)
class Turn:
    """The turn being made. The only value that changes, and it lives for one reply."""

    content: Content
    state: DialogueState
    heard: Heard
    chance: Random
    parts: list[str] = field(default_factory=list)
    steps: list[Step] = field(default_factory=list)
    last_line: Line | None = None
    plan: PlanAnswer | None = None
    waiting: Pending | None = None  # the parameter that was asked for in the turn before
    named: dict[str, Node | None] = field(default_factory=dict)  # topics found by their words
    moving: bool = False  # the person asked for another subject
    announced: bool = False  # the change of subject has been said already

    @property
    def language(self) -> Language:
        """Return the language of the talk."""
        return LANGUAGES[self.state.language]

    @property
    def node(self) -> Node | None:
        """Return the current topic, None at the start or where it was removed."""
        return self.content.tree.node(self.state.topic)

    def change(self, **changes: object) -> None:
        """Replace fields of the state."""
        self.state = replace(self.state, **changes)

    def note(self, rule: str, text: str, candidates: Collection[tuple[Node, float]] = ()) -> None:
        """Remember a step, where somebody asked for the explanation."""
        if self.heard.explain:
            named = (Candidate(node.key, round(weight, 3)) for node, weight in candidates)
            self.steps.append(Step(rule, text, tuple(named)))

    def likeliness(self, node: Node) -> float:
        """Return the person's likeliness of a topic, else the culture's (PS- over CS-ABox)."""
        learned = self.state.likeliness(node.number)
        if learned is not None:
            return learned
        return node.likeliness.get(self.state.culture, 0.5)
