"""Sentences with links in them: translated words with topics, sentences and intents to edit."""

import re
from collections.abc import Mapping
from dataclasses import dataclass

from django.urls import reverse

from authoring.chat.chat_contents import Chosen

_GAP = re.compile(r"%\((\w+)\)s")


@dataclass(frozen=True, slots=True)
class Piece:
    """A piece of a sentence; with an address it is a link to what can be edited."""

    text: str
    url: str = ""


@dataclass(frozen=True, slots=True)
class Links:
    """The addresses of what a content says, in the names of one language."""

    chosen: Chosen
    language: str

    def topic(self, key: str) -> Piece:
        """Return a topic by its name and key; words that are no topic as they are."""
        node = self.chosen.content.tree.by_key.get(key)
        if node is None:
            return Piece(key)
        forms = node.names.get(self.language)
        name = forms.forms.get("", "") if forms else ""
        text = f"{name} ({key})" if name else key
        return Piece(text, reverse("admin:dialogue_topic_change", args=[node.number]))

    def sentence(self, key: str) -> Piece:
        """Return a sentence as it is written, with its key."""
        frame = self.chosen.frames.get(key)
        if frame is None:
            return Piece(key)
        written = frame.texts.get(self.language, "")
        text = f"“{written}” ({key})" if written else key
        return Piece(text, reverse("admin:dialogue_frame_change", args=[frame.number]))

    def intent(self, key: str) -> Piece:
        """Return an intent by its key."""
        intent = self.chosen.content.catalogue.intents.get(key)
        if intent is None:
            return Piece(key)
        return Piece(key, reverse("admin:plans_intent_change", args=[intent.number]))


def filled(template: str, pieces: Mapping[str, Piece]) -> tuple[Piece, ...]:
    """Return a text with its `%(name)s` filled: pieces in the order of the translation."""
    parts = _GAP.split(template)
    found = []
    for place, part in enumerate(parts):
        if place % 2:
            found.append(pieces.get(part, Piece("")))
        elif part:
            found.append(Piece(part.replace("%%", "%")))
    return tuple(found)
