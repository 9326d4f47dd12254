"""The regression conversations as publishing needs them: which ones go another way now."""

from dataclasses import dataclass

from authoring.chat.conversations import run_all
from dialogue.engine.content import Content


@dataclass(frozen=True, slots=True)
class Failing:
    """A conversation that goes another way than it was saved: its number, title, and why."""

    number: int
    title: str
    reason: str


def failing_conversations(content: Content) -> list[Failing]:
    """Return the conversations that would go another way with this content."""
    return [
        Failing(result.id, result.title, result.reason)
        for result in run_all(content)
        if not result.passed
    ]
