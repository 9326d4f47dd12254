"""Conversations as text files that an expert can read and write.

talk: en EN 3
user: I love dogs
topic: Dog            the topic the reply is about
type: c w             its last sentence is one of these types
plan: #action=time    the plan the client gets; `plan: none` for no plan
says: dog             the reply (with the plan sentence) holds this text, in any case
never: cat            the reply does not hold this text
branch: Animal        the topic is in this branch
"""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import pytest

from dialogue.engine.content import Content
from dialogue.engine.manager import start
from dialogue.transcripts import retell
from dialogue.turns import TurnAnswer, take_turn

HERE = Path(__file__).parent
TRANSCRIPTS = HERE.parent.parent / "docs" / "transcripts"
FILES = sorted(HERE.glob("*/*.txt"))


@dataclass(frozen=True, slots=True)
class Answer:
    """A reply as the expectations look at it."""

    content: Content
    taken: TurnAnswer

    @property
    def text(self) -> str:
        return f"{self.taken.plan.plan_sentence} {self.taken.reply.sentence}".casefold()

    @property
    def branch(self) -> str:
        tree = self.content.tree
        node = tree.by_key.get(self.taken.reply.topic)
        return tree.nodes[node.branch].key if node else ""


CHECKS: dict[str, Callable[[Answer, str], bool]] = {
    "topic": lambda answer, wanted: answer.taken.reply.topic == wanted,
    "branch": lambda answer, wanted: answer.branch == wanted,
    "type": lambda answer, wanted: answer.taken.reply.sentence_type in wanted.split(),
    "plan": lambda answer, wanted: answer.taken.plan.plan == wanted.removeprefix("none"),
    "says": lambda answer, wanted: wanted.casefold() in answer.text,
    "never": lambda answer, wanted: wanted.casefold() not in answer.text,
}


@pytest.mark.parametrize("file", FILES, ids=lambda file: f"{file.parent.name}-{file.stem}")
def test_a_conversation_goes_as_its_file_says(file: Path, shipped: Content) -> None:
    lines = [line for line in file.read_text(encoding="utf-8").splitlines() if line.strip()]
    language, culture, seed = lines[0].removeprefix("talk: ").split()
    state = start(shipped, language, culture, int(seed)).state
    answer: Answer | None = None
    for line in lines[1:]:
        word, _, rest = line.partition(": ")
        if word == "user":
            answer = Answer(shipped, take_turn(shipped, state, rest))
            state = answer.taken.reply.state
        elif not line.startswith("#"):
            assert answer is not None, f"{file.name}: begin with a user line"
            if not CHECKS[word](answer, rest):
                reply = answer.taken.reply
                said = f"{reply.topic} ({reply.sentence_type}): {answer.text.strip()}"
                pytest.fail(f"{file.name}: {line!r} but: {said} {answer.taken.plan.plan}")


@pytest.mark.parametrize("file", sorted(TRANSCRIPTS.glob("*.txt")), ids=lambda file: file.stem)
def test_transcripts_are_told_again_word_for_word(file: Path, shipped: Content) -> None:
    text = file.read_text(encoding="utf-8")
    assert retell(shipped, text) == text, "Run `make transcripts` and read what changed."
