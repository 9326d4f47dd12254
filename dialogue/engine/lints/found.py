"""K2: "let's talk about X" leads to X, for every topic in every language."""

from collections.abc import Iterator
from random import Random
from typing import NamedTuple

from dialogue.engine.content import Content
from dialogue.engine.lints.remarks import Remark
from dialogue.engine.manager import reply
from dialogue.engine.state import DialogueState
from dialogue.engine.tree import ON_YOUR_MIND, Node
from dialogue.engine.turn import Heard
from languages.known import LANGUAGES
from plans.engine.manager import answer

ASKING = {
    "en": "Let's talk about {name}.",
    "it": "Parliamo {name}.",
    "ja": "{name}について話しましょう。",
}
LEAST_FOUND = 98.0  # percent


class Lost(NamedTuple):
    """A topic that its own name does not lead to, and the one it does lead to ("" for none)."""

    topic: str
    language: str
    asked: str
    found: str


def lint_names(content: Content) -> Iterator[Remark]:
    """Yield K2 for each topic that a wish for it does not find."""
    for lost in lost_topics(content):
        leads = f"leads to {lost.found}" if lost.found else "leads to no topic"
        message = f"‘{lost.asked}’ {leads}."
        hint = "Give it its name as a keyword, and take the word from the other."
        yield Remark("K2", lost.topic, message, hint, lost.language)


def lost_topics(content: Content) -> list[Lost]:
    """Return the topics that are not found by their names, language by language.

    A topic that shares its name with one above or below it is found by either.
    """
    found = []
    for language in LANGUAGES:
        culture = _culture_of(content, language)
        for node in content.tree.nodes.values():
            if language not in node.names or node.key == ON_YOUR_MIND:
                continue
            asked = wish(node, language)
            reached = _reached(content, asked, DialogueState(language, culture, seed=1))
            if not _is_right(content, node, reached, language):
                found.append(Lost(node.key, language, asked, reached))
    return found


def wish(node: Node, language: str) -> str:
    """Return how a person asks for a topic: "Parliamo del tè."."""
    forms = node.names[language].forms
    return ASKING[language].format(name=forms["di"] if language == "it" else forms[""])


def _culture_of(content: Content, language: str) -> str:
    speaking = (one.code for one in content.knowledge.cultures if one.language == language)
    return next(speaking, "")


def _reached(content: Content, sentence: str, state: DialogueState) -> str:
    """Return the key of the topic that the talk is about after the sentence, "" for none."""
    planned = answer(
        content.catalogue, sentence, state.language, culture=state.culture, chance=Random(1)
    )
    heard = Heard(sentence, planned.kbplan_actions, plan_matched=bool(planned.intent))
    topic = reply(content, state, heard).topic
    return "" if topic == ON_YOUR_MIND else topic


def _is_right(content: Content, node: Node, reached: str, language: str) -> bool:
    other = content.tree.by_key.get(reached)
    if other is None or other is node:
        return other is node
    related = node.number in other.ancestors or other.number in node.ancestors
    same = other.names[language].forms[""] == node.names[language].forms[""]
    return related and same
